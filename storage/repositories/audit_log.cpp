#include "storage/repositories/audit_log.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "storage/records/sealing.h"
#include "storage/records/verify_log.h"
#include "storage/records/current_rights.h"

namespace cusp::storage {

namespace {

constexpr const char* kEntry = "SELECT number, at, sequence, actor, action, subject, detail FROM audit_log ";

AuditEntry entry_in(Row row) {
  return {row.integer(0), row.integer(1), row.integer(2), row.id<UserId>(3), row.text(4), row.uuid(5), row.text(6)};
}

/// The seals of sessions, most entries of all: they have indexes of their own, and the others leave them out.
constexpr std::string_view kSealing = "session_sealed";

/// An entry's place in a list: by time, then by number.
using LogPlace = std::pair<std::int64_t, std::int64_t>;

/// Which places a page may hold: from <= at, and below `before`.
struct LogSpan {
  std::int64_t from_utc_us;
  LogPlace before;
  int limit;
};

/// Of an entry's list, newest first. ?1 from, ?2 and ?3 the place before which it ends, ?4 limit.
constexpr const char* kSpan =
    " AND at >= ?1 AND at <= ?2 AND (at < ?2 OR number < ?3) ORDER BY at DESC, number DESC LIMIT ?4";

/// Each code that the log holds, by one look into the index for each; kSealing in any case.
Stored<std::vector<std::string>> actions_in(Database& db) {
  auto actions = db.all(
      "WITH RECURSIVE codes (code) AS (SELECT '' UNION ALL SELECT (SELECT min(action) FROM audit_log INDEXED BY audit_by_action "
      "WHERE action > code AND action <> 'session_sealed') FROM codes WHERE code IS NOT NULL) SELECT code FROM codes WHERE code <> ''",
      [](Row row) { return row.text(0); });
  if (actions) actions->emplace_back(kSealing);
  return actions;
}

/// Which entries of one kind a page reads, and along which index; ?5 action or actor, ?6 person.
struct IndexedEntries {
  std::string index, where;
};

/// A seal's subject is a session, never a person. Those by the program are left out of seals_by_actor.
IndexedEntries sealing_entries(const std::optional<UserId>& person) {
  const std::string sealing = "action = 'session_sealed'";
  if (!person) return {"seals_by_time", sealing};
  if (*person == UserId{}) return {"seals_by_time", sealing + " AND actor = ?5"};
  return {"seals_by_actor", sealing + " AND actor = ?5 AND actor <> x'00000000000000000000000000000000'"};
}

/// Adds the newest places of one kind of entry.
Stored<void> gather_places(Database& db, const std::string& action, const std::optional<UserId>& person, const LogSpan& span,
                    std::vector<LogPlace>& places) {
  const auto take = [&](const IndexedEntries& entries, const auto&... more) -> Stored<void> {
    const auto found = db.all(
        "SELECT at, number FROM audit_log INDEXED BY " + entries.index + " WHERE " + entries.where + kSpan,
        [](Row row) { return LogPlace{row.integer(0), row.integer(1)}; }, span.from_utc_us, span.before.first, span.before.second,
        span.limit, more...);
    if (!found) return std::unexpected(found.error());
    places.insert(places.end(), found->begin(), found->end());
    return {};
  };
  const std::string other = "action = ?5 AND action <> 'session_sealed'";
  if (action == kSealing) return person ? take(sealing_entries(person), *person) : take(sealing_entries(person));
  if (!person) return take({"audit_by_action", other}, action);
  auto done = take({"audit_by_actor", other + " AND actor = ?6"}, action, *person);
  if (!done || *person == UserId{}) return done;  // a nil subject is nobody
  return take({"audit_by_subject", other + " AND subject = ?6 AND actor <> ?6"}, action, *person);
}

/// The place that ends the list before entry `number`; `to`: the time that ends it.
Stored<LogPlace> place_before(Database& db, std::int64_t number, std::int64_t to_utc_us) {
  constexpr std::int64_t last = INT64_MAX;
  const LogPlace end = to_utc_us == last ? LogPlace{last, last} : LogPlace{to_utc_us - 1, last};
  if (number == last) return end;
  const auto at = db.first("SELECT at FROM audit_log WHERE number <= ?1 ORDER BY number DESC LIMIT 1",
                           [](Row row) { return row.integer(0); }, number);
  if (!at) return std::unexpected(at.error());
  return std::min(end, LogPlace{at->value_or(INT64_MIN), number});
}

}  // namespace

Stored<void> AuditLog::add(const AuditEvent& event) {
  Transaction transaction(c_.db);
  log_event(c_, transaction, event);
  return commit_sealed(c_, transaction);
}

Stored<void> AuditLog::add_if_allowed(const AuditEvent& event, Action action) {
  Transaction transaction(c_.db);
  require_now(transaction, event.actor, action);
  log_event(c_, transaction, event);
  return commit_sealed(c_, transaction);
}

Stored<std::vector<AuditEntry>> AuditLog::list(const Actor& actor, int limit, std::int64_t before_number, const AuditFilter& filter) {
  if (auto allowed = require(actor, Action::see_audit_log); !allowed) return std::unexpected(allowed.error());
  const bool all = filter.actions.empty() && !filter.person && !filter.from_utc_us && !filter.to_utc_us;
  if (all) return c_.db.all(std::string(kEntry) + "WHERE number < ?1 ORDER BY number DESC LIMIT ?2", entry_in, before_number, limit);
  const Snapshot snapshot(c_.db);
  const auto actions = filter.actions.empty() ? actions_in(c_.db) : filter.actions;
  if (!actions) return std::unexpected(actions.error());
  const auto before = place_before(c_.db, before_number, filter.to_utc_us.value_or(INT64_MAX));
  if (!before) return std::unexpected(before.error());
  std::vector<LogPlace> places;
  for (const std::string& action : *actions) {
    const LogSpan span{filter.from_utc_us.value_or(INT64_MIN), *before, limit};
    if (auto done = gather_places(c_.db, action, filter.person, span, places); !done) return std::unexpected(done.error());
  }
  std::ranges::sort(places, std::greater());
  if (places.size() > static_cast<std::size_t>(limit)) places.resize(static_cast<std::size_t>(limit));
  std::vector<AuditEntry> page;
  for (const LogPlace& place : places) {
    auto entry = c_.db.first(std::string(kEntry) + "WHERE number = ?1", entry_in, place.second);
    if (!entry) return std::unexpected(entry.error());
    if (*entry) page.push_back(std::move(**entry));
  }
  return page;
}

Stored<Verification> AuditLog::verify(const Actor& actor, const std::function<void(std::int64_t number)>& each) {
  if (auto allowed = require(actor, Action::see_audit_log); !allowed) return std::unexpected(allowed.error());
  const Snapshot snapshot(c_.db);
  return follow_audit_log(c_, c_.station, [&each](const AuditEntry& entry) { each(entry.number); });
}

}  // namespace cusp::storage
