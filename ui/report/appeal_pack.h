/// NAME.cusppack: one attempt as one file, for an appeal. A tar archive (scenarios/library/tar.h) of
///   pack.json, pack.sig   hashes of the other files, signed by the station (storage/exchange/pack.h)
///   records.db            the attempt's records with trace and statements (storage/exchange/session_extract.h)
///   log.csv               entries of the audit log about it
///   report.pdf, report.json, tooth.png, tooth.nrrd   the report, a picture, and the tooth as it was handed in
/// Everything but the log is made from records.db. Thread: the store's; seconds.
#pragma once

#include <QString>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "storage/exchange/pack.h"
#include "storage/exchange/session_extract.h"
#include "storage/records/verify.h"
#include "storage/store.h"
#include "ui/modules.h"
#include "ui/report/report_data.h"
#include "ui/session/replay.h"
#include "ui/text/failure_text.h"

class QTemporaryDir;

namespace cusp::ui {

inline constexpr std::string_view kPackSuffix = ".cusppack";
inline constexpr std::size_t kMaxPackBytes = std::size_t{1} << 30;

/// An assessment goes by the candidate number, any other attempt by the student's name. `file` is new: a pack of an earlier moment cannot be
/// made again, for its signature covers the audit log as it stood. A failure leaves no file; one that was killed before it had its name is
/// finished (storage/exchange/pack.h). Needs export_results and a QGuiApplication.
Result<void, Message> write_appeal_pack(Store& store, const Actor& actor, SessionId session, const std::filesystem::path& file);

/// A pack of any origin, unpacked. Its records stay in a temporary folder as long as it lives.
struct OpenedPack {
  CheckedPack checked;
  PackSigner signer = PackSigner::other_station;
  bool readable = true;                    // false: the records differ from what was signed, and are no records any more
  std::vector<std::string> differing{};    // files that are missing, not signed, or not as they were signed
  std::vector<ChainFinding> findings{};    // of the record's chain and statements
  std::uint64_t links = 0;                 // of the chain
  std::shared_ptr<const QTemporaryDir> folder{};
  std::filesystem::path records{};         // in that folder
  SessionResult result{};
  ReportData report{};
  bool whole() const { return checked.signature_holds && differing.empty() && findings.empty(); }
};

/// Fails for a file that is no pack, or whose records cannot be read; anything else that is wrong stands in the result.
/// `here`: the records that may know the signer; nullptr: none do.
Result<OpenedPack, Message> open_appeal_pack(const std::filesystem::path& file, Store* here);

/// Computes the trace anew and compares tooth and grade. Reads the unpacked records alone.
Result<ReplayProof, Message> prove_pack(const OpenedPack& pack);

}  // namespace cusp::ui
