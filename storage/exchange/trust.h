/// Whose files a station reads: the public keys of other stations, each made known by an administrator who has compared its
/// fingerprint. Thread: the context's own.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/base/rights.h"
#include "storage/exchange/signed_text.h"
#include "storage/records/context.h"

namespace cusp::storage {

/// What files under a key may bring.
enum class KeyRole : std::uint8_t {
  station,  // results: sessions and statements of its own
  office,   // accounts, cohorts, assignments and versions as well
  former,   // nothing: it signed records of a station whose present key is trusted
  revoked,  // nothing any more
};
std::string_view key_of(KeyRole role) noexcept;

struct OtherKey {
  Uuid station{};
  Hash256 key{};  // its id, whose beginning is the fingerprint
  KeyRole role = KeyRole::station;
  std::int64_t changed_utc_us = 0;
  std::array<std::uint8_t, 32> public_key{};
};

/// This station's id and public key, signed by it: what `exchange key` writes. Needs manage_station. read_only without the
/// station's key.
Stored<SignedText> own_key(StorageContext& context, const Actor& actor);
/// The station and key of such a text. bad_value if it is none, or its signature does not hold.
struct PublicKey {
  Uuid station{};
  std::array<std::uint8_t, 32> bytes{};
};
Stored<PublicKey> public_key_from(const SignedText& text);
/// The same as a file of two lines, read by public_key_in(). not_found if the file is not there.
std::string key_file_of(const SignedText& text);
Stored<PublicKey> public_key_in(const std::filesystem::path& file);

/// These need manage_station. trust(): not_allowed (where = own_key) for a key of this station itself.
Stored<void> trust(StorageContext& context, const Actor& actor, const PublicKey& key, KeyRole role);
/// not_found for a key that is not known.
Stored<void> revoke(StorageContext& context, const Actor& actor, const Hash256& key);
Stored<std::vector<OtherKey>> other_keys(StorageContext& context, const Actor& actor);

/// Within a transaction: the key as it is trusted, or nullopt.
std::optional<OtherKey> other_key(Transaction& transaction, const Hash256& key);
/// Keeps a key that signed records of a trusted station, unless it is known.
void keep_former_key(StorageContext& context, Transaction& transaction, UserId actor, const PublicKey& key);

}  // namespace cusp::storage
