#include "storage/retention/departed.h"

#include <string>

namespace cusp::storage {
namespace {

constexpr std::int64_t kYear_us = 31'557'600'000'000;

/// ?1: gone since. session_summaries.released is 0 while the result of an assessment is withheld.
const std::string kSelectDeparted =
    "SELECT p.id, max(p.created_at, coalesce((SELECT max(started_at) FROM sessions s WHERE s.student = p.id), 0)) last, "
    "EXISTS (SELECT 1 FROM session_summaries m WHERE m.student = p.id AND (m.released = 0 OR m.state = 'running')) "
    "FROM people p WHERE p.role = 'student' AND p.guest = 0 AND p.number <> 'demo' "
    "AND p.number <> " +
    std::string(kErasedNumber) + " AND last <= ?1 ORDER BY last, p.id";

struct Found {
  UserId id;
  std::int64_t last_utc_us = 0;
  bool waits = false;
};

}  // namespace

Stored<DepartedStudents> departed_students(StorageContext& context, const Actor& actor, int years) {
  if (auto allowed = require(actor, Action::manage_accounts); !allowed) return std::unexpected(allowed.error());
  if (years < 1 || years > kMostRetainedYears) return fail(StorageError::bad_value, "years");
  const Snapshot snapshot(context.db);
  const auto found = context.db.all(kSelectDeparted, [](Row row) {
    return Found{row.id<UserId>(0), row.integer(1), row.flag(2)};
  }, context.clock() - years * kYear_us);
  if (!found) return std::unexpected(found.error());
  auto doubt = clock_doubt(context);
  if (!doubt) return std::unexpected(doubt.error());
  Accounts accounts(context);
  DepartedStudents out;
  out.doubt = std::move(*doubt);
  for (const Found& one : *found) {
    const auto account = accounts.find(one.id);
    if (!account) return std::unexpected(account.error());
    (one.waits ? out.waiting : out.erasable).push_back({*account, one.last_utc_us});
  }
  return out;
}

Stored<DepartedStudents> erase_departed(StorageContext& context, const Actor& actor, int years, ClockTrust trust) {
  auto departed = departed_students(context, actor, years);
  if (!departed) return departed;
  if (departed->doubt && trust == ClockTrust::checked) return std::unexpected(*departed->doubt);
  Accounts accounts(context);
  std::vector<DepartedStudent>& going = departed->erasable;
  for (auto student = going.begin(); student != going.end(); ++student) {
    auto done = accounts.erase(actor, student->account.id);
    if (done) continue;
    if (student == going.begin()) return std::unexpected(std::move(done.error()));
    departed->failed = std::move(done.error());
    going.erase(student, going.end());
    break;
  }
  return departed;
}

}  // namespace cusp::storage
