#include "storage/retention/departed.h"

#include <string>
#include <string_view>
#include <utility>

#include "storage/retention/log_order.h"

namespace cusp::storage {
namespace {

constexpr std::int64_t kYear_us = 31'557'600'000'000;

/// ?1: gone since; ?2: this station; ?3: first_sequence_since(). A student stays if the log puts an attempt or the account there or later: an
/// attempt of this station by its own number, one of another station by the entry of its first reading, and the account by the entry of its
/// making. session_summaries.released is 0 while the result of an assessment is withheld.
constexpr std::string_view kSelectDeparted =
    "SELECT p.id, max(p.created_at, coalesce((SELECT max(started_at) FROM sessions s WHERE s.student = p.id), 0)) last, "
    "EXISTS (SELECT 1 FROM session_summaries m WHERE m.student = p.id AND (m.released = 0 OR m.state = 'running')) "
    "FROM people p WHERE p.role = 'student' AND p.guest = 0 AND p.number <> 'demo' AND last <= ?1 "
    "AND NOT EXISTS (SELECT 1 FROM sessions s WHERE s.student = p.id AND iif(s.station = ?2, s.sequence, (SELECT min(a.sequence) "
    "FROM audit_log a INDEXED BY seals_of_session WHERE a.action = 'session_sealed' AND substr(a.subject, 1, 6) = substr(s.id, 1, 6) "
    "AND a.subject = s.id)) >= ?3) "
    "AND NOT EXISTS (SELECT 1 FROM audit_log a INDEXED BY audit_by_subject WHERE a.subject = p.id AND a.action = 'account_created' "
    "AND a.action <> 'session_sealed' AND a.sequence >= ?3) AND p.number <> ";

std::string select_departed(std::string_view further) {
  std::string sql(kSelectDeparted);
  sql.append(kErasedNumber).append(further);
  return sql;
}

struct Found {
  UserId id;
  std::int64_t last_utc_us = 0;
  bool waits = false;
};

Found found_in(Row row) { return {row.id<UserId>(0), row.integer(1), row.flag(2)}; }

/// What is older, by date and by the order of the log, is old.
struct AgeLimit {
  std::int64_t age_us = 0, before_utc_us = 0, young_sequence = 0;
};

Stored<AgeLimit> limit_of(StorageContext& context, const Actor& actor, int years) {
  if (auto allowed = require(actor, Action::manage_accounts); !allowed) return std::unexpected(allowed.error());
  if (years < 1 || years > kMostRetainedYears) return fail(StorageError::bad_value, "years");
  const std::int64_t now = context.clock(), age = years * kYear_us, before = now - age;
  const auto young = first_sequence_since(context, before, now);
  if (!young) return std::unexpected(young.error());
  return AgeLimit{age, before, *young};
}

Stored<DepartedStudents> departed_by(StorageContext& context, const AgeLimit& limit) {
  const Snapshot snapshot(context.db);
  const auto found =
      context.db.all(select_departed(" ORDER BY last, p.id"), found_in, limit.before_utc_us, context.station, limit.young_sequence);
  if (!found) return std::unexpected(found.error());
  auto doubt = clock_doubt(context, limit.age_us);
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

/// False if the student has begun an attempt since: erasing many takes minutes, and others work meanwhile.
Stored<bool> is_away(StorageContext& context, const DepartedStudent& student, const AgeLimit& limit) {
  const auto found = context.db.first(select_departed(" AND p.id = ?4"), found_in, student.last_utc_us, context.station,
                                      limit.young_sequence, student.account.id);
  if (!found) return std::unexpected(found.error());
  return *found && !(*found)->waits;
}

}  // namespace

Stored<DepartedStudents> departed_students(StorageContext& context, const Actor& actor, int years) {
  const auto limit = limit_of(context, actor, years);
  if (!limit) return std::unexpected(limit.error());
  return departed_by(context, *limit);
}

Stored<DepartedStudents> erase_departed(StorageContext& context, const Actor& actor, int years, ClockTrust trust, const ErasureWatch& watch) {
  const auto limit = limit_of(context, actor, years);
  if (!limit) return std::unexpected(limit.error());
  auto departed = departed_by(context, *limit);
  if (!departed) return departed;
  if (departed->doubt && trust == ClockTrust::checked) return std::unexpected(*departed->doubt);
  Accounts accounts(context);
  const std::vector<DepartedStudent> chosen = std::exchange(departed->erasable, {});
  for (const DepartedStudent& student : chosen) {
    if (watch && !watch()) {
      departed->stopped = true;
      break;
    }
    const auto away = is_away(context, student, *limit);
    if (away && !*away) continue;
    auto done = away ? accounts.erase(actor, student.account.id) : std::unexpected(away.error());
    if (done) {
      departed->erasable.push_back(student);
      continue;
    }
    if (departed->erasable.empty()) return std::unexpected(std::move(done.error()));
    departed->failed = std::move(done.error());
    break;
  }
  return departed;
}

}  // namespace cusp::storage
