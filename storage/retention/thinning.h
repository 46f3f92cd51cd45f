/// Thinning: recordings of old practice attempts go; session, grade, statements, metrics and final volume stay, and verify.
/// README.md beside this says which attempts. Thread: the context's own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "storage/base/rights.h"
#include "storage/base/watch.h"
#include "storage/records/context.h"
#include "storage/records/verify.h"
#include "storage/retention/clock_doubt.h"

namespace cusp::storage {

inline constexpr int kThinAfterDays = 90;
inline constexpr int kMostThinAfterDays = 36'500;

/// Why the recording of an old attempt stays; the first that applies.
enum class KeptBecause : std::uint8_t {
  other_station,  // its own station thins it
  assessment,
  unfinished,  // it runs, or broke off without finishing
  ungraded,
  stated,  // somebody overrode, confirmed or released its result
  broken,  // it does not verify
};
inline constexpr std::size_t kKeptBecause = 6;
std::string_view key_of(KeptBecause why) noexcept;

/// Old attempts, by reason.
using KeptTraces = std::array<std::uint64_t, kKeptBecause>;

struct OldTrace {
  SessionId session;
  std::int64_t ended_utc_us = 0;
};
struct OldTraces {
  std::vector<OldTrace> thinnable;  // oldest first; nothing is verified yet
  std::uint64_t bytes = 0;          // of their recordings
  KeptTraces kept{};                // without `broken`
};

/// Recordings of attempts that ended so many days ago, 1 to kMostThinAfterDays, by their dates and by the order of the log
/// (log_order.h). Needs manage_station.
Stored<OldTraces> old_traces(StorageContext& context, const Actor& actor, int older_than_days);

enum class ThinningMode : std::uint8_t { dry_run, carry_out };
struct ThinningOrder {
  int older_than_days = kThinAfterDays;
  ThinningMode mode = ThinningMode::dry_run;
  ClockTrust trust = ClockTrust::checked;
};

struct ThinningReport {
  std::uint64_t attempts = 0;          // thinned, or to be thinned
  std::uint64_t bytes = 0;             // of their recordings
  KeptTraces kept{};
  std::vector<ChainFinding> broken{};  // the first finding of each attempt that does not verify; `owner` names it
  bool stopped = false;                // the watch ended it before the last attempt
  std::optional<StorageFailure> failed{};  // what ended it at one attempt, once others were thinned
  std::uint64_t left = 0;                  // attempts after the last one that it took up: it was stopped, or failed there
  std::optional<StorageFailure> doubt{};   // of the clock: the attempts may be younger
};

/// Verifies each attempt, and in a dry run goes no further. Each is thinned in a transaction of its own: if the program
/// ends, or a write fails, the recording of every other attempt is whole. Fails if nothing was thinned. Thins nothing while the clock is
/// in doubt. Needs manage_station. `watch`: before each attempt.
Stored<ThinningReport> thin_traces(StorageContext& context, const Actor& actor, const ThinningOrder& order,
                                   const WorkWatch& watch = {});

}  // namespace cusp::storage
