/// Messages for staff about opening the records: StorageContext::incident (storage/records/sealing.h). Needs no window.
#pragma once

#include <filesystem>
#include <string_view>

#include "storage/records/verify.h"
#include "ui/modules.h"
#include "ui/session/replay.h"
#include "ui/text/failure_text.h"

namespace cusp::ui {

/// What happened, what it means, and what to do about it. `incident`: an action of storage/records/sealing.h.
Message describe_incident(std::string_view incident, const std::filesystem::path& database);

/// Of clock_behind(): by the dates that this names, attempts would stand in another order than they came.
Message describe_clock_behind(std::int64_t newest_attempt_utc_us, std::int64_t now_utc_us);

/// The records can only be read, for the reason that `cause` names.
Message describe_reading_only(const StorageFailure& cause, const std::filesystem::path& database);

/// What can be done with records that are damaged and can be read in part.
Message describe_damaged();
/// What verification found, and where: "The record was changed: trace_chunks, row 11, second 12 of the session."
QString finding_text(const ChainFinding& finding);

/// What of the proof does not hold; empty if all does.
QString proof_text(const ReplayProof& proof);

/// The first eight bytes of a key's id, to be compared by eye: "1a2b 3c4d 5e6f 7a8b".
QString fingerprint(const Hash256& key);

}  // namespace cusp::ui
