/// When attempts ended, and cohort and dates of their assignments: what an export adds to the rows of a list.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "storage/summary/history.h"

namespace cusp::storage {

struct AttemptDates {
  std::optional<std::int64_t> finished_utc_us{};  // or first graded as it stood; none: neither
  std::string cohort{};                           // of the assignment; empty without one
  std::optional<std::int64_t> opens_utc_us{}, due_utc_us{};  // of the assignment
};

/// Of each row, in this order. Rights are the caller's.
Stored<std::vector<AttemptDates>> dates_of(Database& db, const std::vector<HistoryRow>& rows);

}  // namespace cusp::storage
