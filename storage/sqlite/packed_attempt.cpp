#include "storage/sqlite/packed_attempt.h"

#include <sqlite3.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <vector>

namespace cusp::storage {
namespace {

using Attempts = std::vector<PackedAttempt>;

constexpr int kWithoutVersion = 9, kWithoutKind = 10;  // arguments

std::uint64_t at_most(std::int64_t value, std::uint64_t most) noexcept {
  return value < 0 ? 0 : std::min(static_cast<std::uint64_t>(value), most);
}

PackedAttempt attempt_of(sqlite3_value** values, int count) noexcept {
  PackedAttempt a;
  a.started_utc_us = sqlite3_value_int64(values[0]);
  const void* student = sqlite3_value_blob(values[1]);
  const auto bytes = static_cast<std::size_t>(sqlite3_value_bytes(values[1]));
  if (student != nullptr) std::memcpy(a.student.bytes.data(), student, std::min(bytes, a.student.bytes.size()));
  a.score = sqlite3_value_double(values[2]);
  const bool no_mark = sqlite3_value_type(values[3]) == SQLITE_NULL;
  a.pass_mark = no_mark ? std::numeric_limits<double>::quiet_NaN() : sqlite3_value_double(values[3]);
  const std::int64_t version = count > kWithoutVersion ? sqlite3_value_int64(values[kWithoutVersion]) : 0;
  a.rest = at_most(sqlite3_value_int64(values[4]), PackedAttempt::kMostElapsedUs) << PackedAttempt::kElapsedBit |
           at_most(version, PackedAttempt::kMostVersion) << PackedAttempt::kVersionBit |
           at_most(sqlite3_value_int64(values[5]), PackedAttempt::kMostAttempt) << PackedAttempt::kAttemptBit |
           (sqlite3_value_int64(values[6]) != 0 ? PackedAttempt::kPassed : 0) |
           (sqlite3_value_int64(values[7]) != 0 ? PackedAttempt::kScripted : 0) |
           (sqlite3_value_int64(values[8]) != 0 ? PackedAttempt::kReleased : 0) |
           (count > kWithoutKind && sqlite3_value_int64(values[kWithoutKind]) != 0 ? PackedAttempt::kAssessment : 0);
  return a;
}

/// SQLite keeps a pointer for each group, null at first.
void add(sqlite3_context* context, int count, sqlite3_value** values) {
  auto** group = static_cast<Attempts**>(sqlite3_aggregate_context(context, sizeof(Attempts*)));
  if (group == nullptr) return sqlite3_result_error_nomem(context);
  try {
    if (*group == nullptr) *group = new Attempts;
    (*group)->push_back(attempt_of(values, count));
  } catch (const std::bad_alloc&) {
    sqlite3_result_error_nomem(context);
  }
}

/// SQLite calls it for every group, after a failure too.
void finish(sqlite3_context* context) {
  auto** group = static_cast<Attempts**>(sqlite3_aggregate_context(context, 0));
  if (group == nullptr || *group == nullptr) return sqlite3_result_null(context);
  const std::unique_ptr<Attempts> attempts(*group);
  std::ranges::sort(*attempts, [](const PackedAttempt& a, const PackedAttempt& b) { return std::memcmp(&a, &b, sizeof a) < 0; });
  sqlite3_result_blob64(context, attempts->data(), attempts->size() * sizeof(PackedAttempt), SQLITE_TRANSIENT);
}

}  // namespace

void add_pack_attempts(sqlite3* connection) noexcept {
  for (const int arguments : {kWithoutVersion, kWithoutKind, kWithoutKind + 1}) {
    sqlite3_create_function_v2(connection, "pack_attempts", arguments, SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_DIRECTONLY, nullptr,
                               nullptr, add, finish, nullptr);
  }
}

}  // namespace cusp::storage
