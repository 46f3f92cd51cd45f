#include "storage/records/sealing.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "storage/records/audit_writer.h"
#include "storage/records/rollback_counter.h"

namespace cusp::storage {
namespace {

constexpr const char* baseline_action(SealedTable table) noexcept {
  constexpr std::array<const char*, 12> actions = {"comment_sealed", "cohort_sealed",    "assignment_sealed",
                                                  "version_sealed", "statement_sealed", "assessment_sealed",
                                                  "withdrawal_sealed", "adjustment_sealed", "other_key_sealed",
                                                  "referred_sealed", "thinning_sealed", "assignment_withdrawal_sealed"};
  return actions[static_cast<std::size_t>(table)];
}

struct BaselineEntry {
  const char* action;
  Uuid subject;
  std::string detail;
};

/// Every sealed row in the file now, each with its seal.
Stored<std::vector<BaselineEntry>> seals_of_all(Database& db) {
  std::vector<BaselineEntry> out;
  const auto take = [&](Stored<std::vector<BaselineEntry>> some) -> Stored<void> {
    if (!some) return std::unexpected(some.error());
    out.insert(out.end(), some->begin(), some->end());
    return {};
  };
  auto done = take(db.all(kSelectSealedAccounts, [](Row row) {
    return BaselineEntry{"person_sealed", row.uuid(0), text_of(account_seal(row))};
  }));
  if (done) {
    done = take(db.all("SELECT session, links, link FROM session_heads ORDER BY session", [](Row row) {
      return BaselineEntry{"session_sealed", row.uuid(0),
                           "found " + std::to_string(row.integer(1)) + ' ' + hex(row.hash(2))};
    }));
  }
  if (!done) return std::unexpected(done.error());
  for (const SealedTable table : kSealedTables) {
    const auto rows = row_seals(db, table);
    if (!rows) return std::unexpected(rows.error());
    for (const RowSeal& row : *rows) out.push_back({baseline_action(table), row.subject, hex(row.seal)});
  }
  return out;
}

/// Writes the entry "sealing_began", and one seal for each older row.
void seal_older_rows(StorageContext& context, Transaction& transaction) {
  const auto found = seals_of_all(context.db);
  if (!found) return transaction.refuse(found.error());
  AuditWriter log(context, transaction);
  log.add({.action = "sealing_began", .subject = context.station, .detail = std::to_string(found->size())});
  for (const BaselineEntry& entry : *found) {
    log.add({.action = entry.action, .subject = entry.subject, .detail = entry.detail});
  }
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

/// nullopt if the counter cannot be checked; context.counter_failure then holds the reason.
std::optional<CounterCheck> checked_counter(StorageContext& context) {
  auto check = check_counter(context);
  if (check) return *check;
  context.counter_failure = std::move(check.error());
  return std::nullopt;
}

/// False if the counter cannot be written; context.counter_failure then holds the reason.
bool set_counter(StorageContext& context, const ChainHead& log) {
  auto written = write_counter(context.counter_file, *context.key, context.station, log);
  context.counter_failure.reset();
  if (!written) context.counter_failure = std::move(written.error());
  return written.has_value();
}

/// Logs what the counter shows, then brings the counter up to the log. The write of the counter stands in a transaction
/// that changes nothing: under its lock no other process commits, so the counter never leads the log.
Stored<void> follow_log(StorageContext& context) {
  bool recorded = false;
  while (true) {
    Transaction transaction(context.db);
    const auto check = transaction.ok() ? checked_counter(context) : std::nullopt;
    if (!check) return transaction.commit();
    if (check->state == CounterState::good || recorded) {
      const bool behind = check->log.links > check->counted || check->state != CounterState::good;
      if (behind) {
        set_counter(context, check->log);
      } else {
        context.counter_failure.reset();
      }
      return transaction.commit();
    }
    const std::string_view incident = incident_of(check->state);
    context.incident = incident;
    log_event(context, transaction,
              {.action = incident,
               .subject = context.station,
               .detail = std::to_string(check->counted) + ' ' + std::to_string(check->log.links)});
    if (auto done = transaction.commit(); !done) return done;
    recorded = true;
  }
}

}  // namespace

void log_account(StorageContext& context, Transaction& transaction, UserId actor, std::string_view action,
                 UserId account) {
  std::string one = kSelectSealedAccounts;
  one += "WHERE id = ?1";
  const auto seal = transaction.first(one, [](Row row) { return text_of(account_seal(row)); }, account);
  if (!seal) return;
  log_event(context, transaction, {.actor = actor, .action = action, .subject = account.uuid, .detail = *seal});
}

void log_row(StorageContext& context, Transaction& transaction, UserId actor, std::string_view action,
             SealedTable table, const Uuid& id) {
  if (!transaction.ok()) return;
  const auto rows = row_seals(context.db, table, id);
  if (!rows) return transaction.refuse(rows.error());
  for (const auto& [subject, seal] : *rows) {
    log_event(context, transaction, {.actor = actor, .action = action, .subject = subject, .detail = hex(seal)});
  }
}

void log_session(StorageContext& context, Transaction& transaction, UserId actor, SessionId session,
                 std::string_view event) {
  const auto head = transaction.first(
      "SELECT links, link FROM session_heads WHERE session = ?1",
      [](Row row) { return std::to_string(row.integer(0)) + ' ' + hex(row.hash(1)); }, session);
  if (!head) return;
  log_event(context, transaction,
            {.actor = actor,
             .action = "session_sealed",
             .subject = session.uuid,
             .detail = std::string(event) + ' ' + *head});
}

Stored<void> commit_sealed(StorageContext& context, Transaction& transaction) {
  if (auto done = transaction.commit(); !done) return done;
  if (auto followed = follow_log(context); !followed) context.counter_failure = followed.error();
  return {};
}

Stored<void> begin_sealing(StorageContext& context) {
  {
    Transaction transaction(context.db);
    const auto check = transaction.ok() ? checked_counter(context) : std::nullopt;
    if (!check) return transaction.commit();
    const bool began = (check->state == CounterState::good && check->counted > 0) || has_began(transaction);
    if (!began) {
      // The counter is written before the first seal: if seals exist and the counter does not, somebody removed it. A
      // counter of another database under this name is no incident of this one.
      const bool fresh = check->state == CounterState::missing || check->state == CounterState::broken;
      if (fresh && !set_counter(context, {})) return transaction.commit();
      if (check->log.links == 0) {
        context.incident = "log_damaged";
        log_event(context, transaction, {.action = "log_damaged", .subject = context.station});
      }
      seal_older_rows(context, transaction);
    }
    if (auto done = transaction.commit(); !done) return done;
  }
  return follow_log(context);
}

void note_counter_incident(StorageContext& context) {
  const auto check = checked_counter(context);
  if (!check || check->state == CounterState::good) return;
  const auto began = context.db.first(kBegan, [](Row) { return true; });
  if (check->state != CounterState::missing || (began && *began)) context.incident = incident_of(check->state);
}

}  // namespace cusp::storage
