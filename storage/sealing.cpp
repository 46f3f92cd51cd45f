#include "storage/sealing.h"

#include <sstream>
#include <utility>
#include <vector>

#include "storage/repositories/audit_log.h"
#include "storage/rollback_counter.h"

namespace cusp::storage {
namespace {

/// A password's or PIN's record holds a random salt: equal secrets of two people have different hashes.
std::string secret_seal(const Uuid& id, const std::string& record) {
  if (record.empty()) return "-";
  return hex(Blake2b{}.add_text("cusp secret 1").add_uuid(id).add_text(record).finish());
}

constexpr std::string_view columns_of(SealedTable table) noexcept {
  switch (table) {
    case SealedTable::comments:
      return "session, id, author, at, sequence, tick, text";
    case SealedTable::cohorts:
      return "id, name, created_at";
    case SealedTable::assignments:
      return "id, version, cohort, kind, opens_at, due_at, goes_allowed, author, created_at, sequence";
    case SealedTable::scenario_versions:
      return "id, scenario, number, key, title, json, content_hash, author, published_at, sequence";
  }
  return {};
}

constexpr const char* baseline_action(SealedTable table) noexcept {
  constexpr std::array<const char*, 4> actions = {"comment_sealed", "cohort_sealed", "assignment_sealed",
                                                  "version_sealed"};
  return actions[static_cast<std::size_t>(table)];
}

struct BaselineEntry {
  const char* action;
  Uuid subject;
  std::string detail;
};

/// What stands in the file now, each row with its seal.
Stored<std::vector<BaselineEntry>> seals_of_all(Database& db) {
  std::vector<BaselineEntry> out;
  const auto take = [&](Stored<std::vector<BaselineEntry>> some) -> Stored<void> {
    if (!some) return std::unexpected(some.error());
    out.insert(out.end(), some->begin(), some->end());
    return {};
  };
  auto done = take(db.all(kSealedPeople, [](Row row) {
    return BaselineEntry{"person_sealed", row.uuid(0), text_of(person_seal(row))};
  }));
  if (done) {
    done = take(db.all("SELECT session, links, link FROM session_heads ORDER BY session", [](Row row) {
      return BaselineEntry{"session_sealed", row.uuid(0),
                           "found " + std::to_string(row.integer(1)) + ' ' + hex(row.hash(2))};
    }));
  }
  for (const SealedTable table : kSealedTables) {
    if (!done) break;
    done = take(db.all(select_sealed(table), [&](Row row) {
      return BaselineEntry{baseline_action(table), row.uuid(0), hex(row_seal(db, table, row))};
    }));
  }
  if (!done) return std::unexpected(done.error());
  return out;
}

/// The first entry of sealing, and a seal for all that was there before it.
void seal_what_is_there(StorageContext& context, Transaction& transaction) {
  const auto found = seals_of_all(context.db);
  if (!found) return transaction.refuse(found.error());
  AuditWriter log(context, transaction);
  log.add(UserId{}, "sealing_began", context.station, std::to_string(found->size()));
  for (const BaselineEntry& entry : *found) log.add(UserId{}, entry.action, entry.subject, entry.detail);
  log.finish();
}

constexpr std::string_view incident_of(CounterState state) noexcept {
  constexpr std::array<std::string_view, 4> actions = {"", "counter_missing", "counter_broken", "rolled_back"};
  return actions[static_cast<std::size_t>(state)];
}

constexpr const char* kBegan = "SELECT 1 FROM audit_log WHERE action = 'sealing_began' LIMIT 1";

bool has_began(Transaction& transaction) {
  return transaction.first(kBegan, [](Row) { return true; }).value_or(false);
}

Stored<void> set_counter(StorageContext& context, std::uint64_t entries, const Hash256& link) {
  auto written = write_counter(context.counter_file, *context.key, context.station, entries, link);
  context.counter_failure.reset();
  if (!written) context.counter_failure = written.error();
  return written;
}

/// Under the write lock: what the counter shows joins the log, and the counter follows the log. The counter is written
/// within a transaction that changes nothing: so it is the larger of what several processes would write, and never
/// ahead of a commit.
Stored<void> follow_log(StorageContext& context) {
  bool recorded = false;
  while (true) {
    Transaction transaction(context.db);
    if (!transaction.ok()) return transaction.commit();
    const auto check = check_counter(context);
    if (!check) {
      context.counter_failure = check.error();
      return transaction.commit();
    }
    if (check->state == CounterState::good || recorded) {
      const bool behind = check->entries > check->counted || check->state != CounterState::good;
      if (behind) {
        // A counter that cannot be written lags; the next commit catches up.
        static_cast<void>(set_counter(context, check->entries, check->link));
      } else {
        context.counter_failure.reset();
      }
      return transaction.commit();
    }
    context.incident = incident_of(check->state);
    AuditLog::add(context, transaction, UserId{}, *context.incident, context.station,
                  std::to_string(check->counted) + ' ' + std::to_string(check->entries));
    if (auto done = transaction.commit(); !done) return done;
    recorded = true;
  }
}

}  // namespace

PersonSeal person_seal(Row row) {
  const Uuid id = row.uuid(0);
  const std::string password = row.text(4), pin = row.text(5);
  Blake2b identity;
  identity.add_text("cusp person 1").add_uuid(id).add_u64(row.u64(6));
  if (!password.empty() || !pin.empty()) {
    identity.add_text(password).add_text(pin).add_text(row.text(7)).add_text(row.text(8));
  }
  return {
      row.text(1),          std::to_string(row.integer(2)), std::to_string(row.integer(3)), secret_seal(id, password),
      secret_seal(id, pin), hex(identity.finish())};
}

std::string text_of(const PersonSeal& seal) {
  std::string out;
  for (const std::string& word : seal) out += (out.empty() ? "" : " ") + word;
  return out;
}

std::optional<PersonSeal> person_seal_from(std::string_view detail) {
  std::istringstream in{std::string(detail)};
  PersonSeal seal;
  for (std::string& word : seal) {
    if (!(in >> word)) return std::nullopt;
  }
  return seal;
}

std::string_view name_of(SealedTable table) noexcept {
  constexpr std::array<std::string_view, 4> names = {"comments", "cohorts", "assignments", "scenario_versions"};
  return names[static_cast<std::size_t>(table)];
}

std::string select_sealed(SealedTable table) {
  return "SELECT " + std::string(columns_of(table)) + " FROM " + std::string(name_of(table)) + ' ';
}

Hash256 row_seal(Database& db, SealedTable table, Row row) {
  Blake2b seal;
  seal.add_text(name_of(table)).add_hash(row.content_hash());
  if (table == SealedTable::scenario_versions) {
    const auto files = db.all(
        "SELECT name, blob FROM version_files WHERE version = ?1 ORDER BY name",
        [](Row file) {
          return std::pair{file.text(0), file.hash(1)};
        },
        row.uuid(0));
    for (const auto& [name, blob] : files.value_or(std::vector<std::pair<std::string, Hash256>>{})) {
      seal.add_text(name).add_hash(blob);
    }
  }
  return seal.finish();
}

void log_person(StorageContext& context, Transaction& transaction, UserId actor, std::string_view action, UserId who) {
  std::string one = kSealedPeople;
  one += "WHERE id = ?1";
  const auto seal = transaction.first(one, [](Row row) { return text_of(person_seal(row)); }, who);
  if (seal) AuditLog::add(context, transaction, actor, action, who.uuid, *seal);
}

void log_row(StorageContext& context, Transaction& transaction, UserId actor, std::string_view action,
             SealedTable table, const Uuid& id) {
  const auto seal = transaction.first(
      select_sealed(table) + "WHERE id = ?1",
      [&](Row row) {
        return std::pair{row.uuid(0), hex(row_seal(context.db, table, row))};
      },
      id);
  if (seal) AuditLog::add(context, transaction, actor, action, seal->first, seal->second);
}

void log_session(StorageContext& context, Transaction& transaction, UserId actor, SessionId session,
                 std::string_view event) {
  const auto head = transaction.first(
      "SELECT links, link FROM session_heads WHERE session = ?1",
      [](Row row) { return std::to_string(row.integer(0)) + ' ' + hex(row.hash(1)); }, session);
  if (head) {
    AuditLog::add(context, transaction, actor, "session_sealed", session.uuid, std::string(event) + ' ' + *head);
  }
}

Stored<void> commit_sealed(StorageContext& context, Transaction& transaction) {
  if (auto done = transaction.commit(); !done) return done;
  if (auto followed = follow_log(context); !followed) context.counter_failure = followed.error();
  return {};
}

Stored<void> begin_sealing(StorageContext& context) {
  {
    Transaction transaction(context.db);
    if (!transaction.ok()) return transaction.commit();
    const auto check = check_counter(context);
    if (!check) {
      context.counter_failure = check.error();
      return transaction.commit();
    }
    const bool began = (check->state == CounterState::good && check->counted > 0) || has_began(transaction);
    if (!began) {
      // The counter comes before the first seal: one that is missing beside seals was taken away. One of another
      // database under this name is no incident of this one.
      const bool fresh = check->state == CounterState::missing || check->state == CounterState::broken;
      if (fresh && !set_counter(context, 0, Hash256{})) return transaction.commit();
      if (check->entries == 0) {
        context.incident = "log_damaged";
        AuditLog::add(context, transaction, UserId{}, *context.incident, context.station);
      }
      seal_what_is_there(context, transaction);
    }
    if (auto done = transaction.commit(); !done) return done;
  }
  return follow_log(context);
}

void look_at_counter(StorageContext& context) {
  const auto check = check_counter(context);
  if (!check) {
    context.counter_failure = check.error();
    return;
  }
  if (check->state == CounterState::good) return;
  const auto began = context.db.first(kBegan, [](Row) { return true; });
  if (check->state != CounterState::missing || (began && *began)) context.incident = incident_of(check->state);
}

}  // namespace cusp::storage
