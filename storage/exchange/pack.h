/// What a station signs about the files of an appeal pack: their hashes, the attempt, who made the pack, and the head of the
/// audit log at that moment. ui/report/appeal_pack.h lists the files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "storage/base/rights.h"
#include "storage/exchange/signed_text.h"
#include "storage/records/chain.h"
#include "storage/records/context.h"

namespace cusp::storage {

struct PackDescription {
  Uuid station{};
  SessionId session{};
  UserId maker{};
  std::int64_t made_utc_us = 0;
  ChainHead log{};  // of the station's audit log
  std::vector<PackFile> files{};  // blake2b_256 of their bytes
};

using SignedPack = SignedText;

/// Signs. Needs export_results, as the records have it now. read_only without the station's key.
Stored<SignedPack> sign_pack(StorageContext& context, const Actor& actor, SessionId session, std::vector<PackFile> files);

/// Writes the pack's bytes as a new file, and the entry "packed" with their hash, between the last byte and the name. Needs
/// export_results, as the records have it now. duplicate if the file exists; a failure leaves no file. A file in the same folder whose
/// program was killed between entry and name gets its name first; duplicate, detail "finished" (where = its name): it is this one, and
/// holds what was packed then.
Stored<void> give_out_pack(StorageContext& context, const Actor& actor, SessionId session, std::string_view bytes, const std::filesystem::path& file);

enum class PackSigner : std::uint8_t {
  this_station,   // a key of this database's station
  other_station,  // a key that this database does not know
};

struct CheckedPack {
  PackDescription description{};
  Hash256 key{};  // id of the key that signed
  bool signature_holds = false;
};

/// Texts of any origin. bad_value (where = "description" or "signature") for one that is none.
Stored<CheckedPack> check_pack(const SignedPack& pack);
Stored<PackSigner> signer_of(StorageContext& context, const CheckedPack& pack);

}  // namespace cusp::storage
