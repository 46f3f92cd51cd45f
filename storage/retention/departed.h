/// Students who have made no attempt for years, and their erasure. Thread: the context's own.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "storage/repositories/accounts.h"
#include "storage/retention/clock_doubt.h"

namespace cusp::storage {

inline constexpr int kMostRetainedYears = 100;

struct DepartedStudent {
  Account account{};
  std::int64_t last_utc_us = 0;  // start of the newest attempt; without one, when the account was made
};
struct DepartedStudents {
  std::vector<DepartedStudent> erasable;  // longest gone first
  std::vector<DepartedStudent> waiting;   // they stay: an assessment of theirs is not released, or an attempt runs
  std::optional<StorageFailure> failed{};  // what ended the erasure before the last one, once others were erased
  std::optional<StorageFailure> doubt{};  // of the clock: they may have been away for less
  bool stopped = false;                   // the watch ended the erasure before the last one
};
/// Asked before each erasure; false ends it.
using ErasureWatch = std::function<bool()>;

/// No attempt for so many years of 365.25 days, 1 to kMostRetainedYears; the order of the log counts too (log_order.h), also of accounts and
/// of another station's attempts. The school says how many. Needs manage_accounts.
Stored<DepartedStudents> departed_students(StorageContext& context, const Actor& actor, int years);

/// Accounts::erase() of each who is erasable, and has begun no attempt meanwhile; returns who was erased. Fails if nobody was; a later
/// failure leaves the others as they are.
/// Erases nobody while the clock is in doubt.
Stored<DepartedStudents> erase_departed(StorageContext& context, const Actor& actor, int years, ClockTrust trust = ClockTrust::checked,
                                        const ErasureWatch& watch = {});

}  // namespace cusp::storage
