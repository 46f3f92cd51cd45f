/// What the audit log recorded before an attempt is older than the attempt, also where a clock that stood years back dated the attempt.
/// Thread: the context's own.
#pragma once

#include <cstdint>

#include "storage/records/context.h"

namespace cusp::storage {

/// Sequence number of the first log entry with before < at <= now; INT64_MAX without one. What this station gave a greater number is of
/// after `before`, whatever its date: StorageContext::next_sequence() numbers attempts, their events and log entries in one order. The first
/// entry about an attempt of another station is of its reading.
/// Scans the log up to that entry: 0.15 s for 900,000 entries.
Stored<std::int64_t> first_sequence_since(StorageContext& context, std::int64_t before_utc_us, std::int64_t now_utc_us);

}  // namespace cusp::storage
