#include <algorithm>
#include <charconv>
#include <map>
#include <sstream>

#include "storage/exchange/exchange.h"
#include "storage/exchange/merge.h"
#include "storage/exchange/trust.h"
#include "storage/records/audit_writer.h"
#include "storage/records/packed_attempts.h"
#include "storage/records/sealing.h"
#include "storage/records/current_rights.h"

namespace cusp::storage {
namespace {

/// The station's key among those that the file's rows name; every other one is kept for verification alone.
void merge_keys(Merge& merge, const Hash256& signer) {
  const auto keys = merge.taken(merge.from.db.all(
      "SELECT id, public_key FROM station_keys WHERE id IN (SELECT key FROM session_heads "
      "UNION SELECT key FROM statements WHERE station = ?1 UNION SELECT key FROM thinned_traces)",
      [](Row row) { return std::pair{row.hash(0), row.hash(1)}; }, merge.out.description.station));
  for (const auto& [id, bytes] : keys) {
    if (key_id(bytes) != id) return merge.refuse(StorageError::differs, "station_keys", hex(id));
    if (id == signer) continue;
    const auto known = other_key(merge.transaction, id);
    if (known && known->station != merge.out.description.station) return merge.refuse(StorageError::differs, "station_keys", hex(id));
    if (!known) keep_former_key(merge.context, merge.transaction, merge.actor.id, {merge.out.description.station, bytes});
  }
}

/// A row a microsecond for 285 years. Above it the station's own numbers would end at 2^63, and it could write no more.
constexpr std::int64_t kMostSequence = std::int64_t{1} << 53;

/// Numbers of this station rise above those of the file: what is written here next comes after what was read.
void raise_sequence(Transaction& transaction) {
  transaction.run(
      "UPDATE main.station SET next_sequence = max(next_sequence, 1 + (SELECT coalesce(max(n), 0) FROM (SELECT max(sequence) n FROM source.sessions "
      "UNION ALL SELECT max(sequence) FROM source.session_events UNION ALL SELECT max(sequence) FROM source.grades "
      "UNION ALL SELECT max(sequence) FROM source.scenario_versions UNION ALL SELECT max(sequence) FROM source.assignments "
      "UNION ALL SELECT max(sequence) FROM source.comments UNION ALL SELECT max(sequence) FROM source.statements "
      "UNION ALL SELECT max(sequence) FROM source.version_withdrawals UNION ALL SELECT max(sequence) FROM source.adjustments "
      "UNION ALL SELECT max(sequence) FROM source.assignment_withdrawals)))");
  const auto next = transaction.first("SELECT next_sequence FROM main.station", [](Row row) { return row.integer(0); });
  if (next && *next > kMostSequence) transaction.refuse({StorageError::differs, "station", "next_sequence"});
}

void check_trust(Transaction& transaction, const StorageContext& context, const CheckedExchange& file) {
  const ExchangeDescription& d = file.description;
  const Hash256 key = key_id(file.public_key);
  if (d.station == context.station) return transaction.refuse({StorageError::not_allowed, "own_file"});
  const auto known = other_key(transaction, key);
  if (!known || known->role == KeyRole::former) return transaction.refuse({StorageError::unknown_key, d.station.text(), hex(key)});
  if (known->role == KeyRole::revoked) return transaction.refuse({StorageError::revoked_key, d.station.text(), hex(key)});
  if (known->station != d.station) return transaction.refuse({StorageError::differs, "other_keys", hex(key)});
  if (d.kind == ExchangeKind::office && known->role != KeyRole::office) transaction.refuse({StorageError::not_allowed, "office_file"});
}

/// What the log says of the files under one key: "exchange_file_known KEY NUMBER HASH", "exchange_read_in KEY NUMBER HASH".
struct FilesKnown {
  std::map<std::size_t, Hash256> known;
  std::size_t newest_read = 0;
  bool read = false;  // this very file
};

FilesKnown files_known(Merge& merge, const Hash256& key, std::size_t number) {
  FilesKnown out;
  if (!merge.ok()) return out;
  const auto entries = merge.taken(merge.db().all(
      "SELECT action, detail FROM main.audit_log INDEXED BY audit_by_subject WHERE subject = ?1 AND action IN ('exchange_file_known', 'exchange_read_in') "
      "AND action <> 'session_sealed'",
      [](Row row) { return std::pair{row.text(0), row.text(1)}; }, merge.out.description.station));
  for (const auto& [action, detail] : entries) {
    std::istringstream in(detail);
    std::string of_key, hash;
    std::size_t n = 0;
    in >> of_key >> n >> hash;
    const auto content = hash_from_hex(hash);
    if (!content || of_key != hex(key)) continue;
    out.known[n] = *content;
    if (action != "exchange_read_in") continue;
    out.newest_read = std::max(out.newest_read, n);
    out.read = out.read || n == number;
  }
  return out;
}

/// Refuses a file whose station has given out another one under the same number: it stands on an old copy.
void place_among_files(Merge& merge, const CheckedExchange& file) {
  const Hash256 key = key_id(file.public_key);
  const std::size_t number = file.description.number();
  const FilesKnown files = files_known(merge, key, number);
  std::vector<Hash256> all = file.description.earlier;
  all.push_back(file.hash);
  for (std::size_t n = 1; n <= all.size() && merge.ok(); ++n) {
    const auto known = files.known.find(n);
    if (known != files.known.end() && known->second != all[n - 1]) {
      return merge.refuse(StorageError::put_back, file.description.station.text(), std::to_string(n));
    }
    if (known != files.known.end()) continue;
    log_event(merge.context, merge.transaction,
              {.actor = merge.actor.id, .action = "exchange_file_known", .subject = file.description.station,
               .detail = hex(key) + ' ' + std::to_string(n) + ' ' + hex(all[n - 1])});
  }
  merge.out.outcome = files.newest_read > number ? ReadOutcome::late : files.read ? ReadOutcome::again : ReadOutcome::read;
}

void merge_all(Merge& merge, const CheckedExchange& file) {
  raise_sequence(merge.transaction);
  merge_keys(merge, key_id(file.public_key));
  merge_people(merge);
  merge_versions(merge);
  merge_rows(merge, SealedTable::cohorts, "cohort_sealed");
  merge_rows(merge, SealedTable::assignments, "assignment_sealed");
  merge_rows(merge, SealedTable::assessments, "assessment_sealed");
  merge_rows(merge, SealedTable::version_withdrawals, "withdrawal_sealed");
  merge_rows(merge, SealedTable::assignment_withdrawals, "assignment_withdrawal_sealed");
  merge_rows(merge, SealedTable::adjustments, "adjustment_sealed");
  if (file.description.kind == ExchangeKind::office) {
    merge_members(merge);
  } else {
    merge_sessions(merge);
  }
  merge_statements(merge);
  if (merge.goes_on()) follow_graded(merge.transaction, merge.changed);
}

void log_read_in(Merge& merge, const CheckedExchange& file) {
  if (merge.out.outcome == ReadOutcome::again && merge.out.counts.none()) return;
  log_event(merge.context, merge.transaction,
            {.actor = merge.actor.id, .action = "exchange_read_in", .subject = file.description.station,
             .detail = hex(key_id(file.public_key)) + ' ' + std::to_string(file.description.number()) + ' ' + hex(file.hash)});
}

Stored<ReadIn> merge_file(StorageContext& context, StorageContext& from, const Actor& actor, const CheckedExchange& file, WorkSteps& steps) {
  ReadIn out{.description = file.description, .key = key_id(file.public_key)};
  Transaction transaction(context.db);
  require_now(transaction, actor.id, Action::manage_station);
  Merge merge{context, transaction, from, actor, out, steps};
  check_trust(transaction, context, file);
  if (merge.ok()) {
    const std::filesystem::path& place = from.db.file();
    if (auto same = check_attached(merge.db(), place, file.description, steps); !same) transaction.refuse(failure_in_file(same.error(), place));
  }
  place_among_files(merge, file);
  for (const Uuid& id : merge.taken(from.db.all("SELECT id FROM referred", [](Row row) { return row.uuid(0); }))) merge.referred.insert(id);
  if (merge.ok()) merge_all(merge, file);
  log_read_in(merge, file);
  if (auto done = commit_sealed(context, transaction); !done) return std::unexpected(done.error());
  return out;
}

/// Attached as `source` while it lives.
class Attached {
 public:
  Attached(Database& db, const std::filesystem::path& file) : db_{db}, done_{db.attach_source(file)} {}
  ~Attached() {
    if (done_) db_.detach_source();
  }
  Attached(const Attached&) = delete;
  Attached& operator=(const Attached&) = delete;
  const Stored<void>& done() const noexcept { return done_; }

 private:
  Database& db_;
  Stored<void> done_;
};

Stored<ReadIn> attach_and_merge(StorageContext& context, StorageContext& from, const Actor& actor, const CheckedExchange& file, WorkSteps& steps) {
  const Attached source(context.db, from.db.file());
  if (!source.done()) return std::unexpected(source.done().error());
  return merge_file(context, from, actor, file, steps);
}

Stored<ReadIn> read_in_steps(StorageContext& context, const Actor& actor, const std::filesystem::path& file, WorkSteps& steps) {
  if (auto allowed = require(actor, Action::manage_station); !allowed) return std::unexpected(allowed.error());
  if (!context.key) return std::unexpected(context.db.unwritable());
  auto opened = open_exchange(file);
  if (!opened) return std::unexpected(opened.error());
  StorageContext from{std::move(*opened), context.clock, context.cost, context.station, std::nullopt};
  const Snapshot snapshot(from.db);
  const auto checked = read_description(from.db);
  if (!checked) return std::unexpected(failure_in_file(checked.error(), file));
  if (auto same = check_schema(context.db, file); !same) return std::unexpected(failure_in_file(same.error(), file));
  if (auto good = check_content(from.db, checked->description, steps); !good) return std::unexpected(failure_in_file(good.error(), file));
  auto done = attach_and_merge(context, from, actor, *checked, steps);
  // The log holds the old pages until then, or as many as a failure has undone: on a full disk nothing else would fit. Another connection may
  // hold it open: the next checkpoint takes it.
  static_cast<void>(context.db.run("PRAGMA wal_checkpoint(TRUNCATE)"));
  return done;
}

}  // namespace

std::string_view key_of(ReadOutcome outcome) noexcept {
  constexpr std::array<std::string_view, 3> keys = {"read", "again", "late"};
  return keys[static_cast<std::size_t>(outcome)];
}

Stored<ReadIn> read_in(StorageContext& context, const Actor& actor, const std::filesystem::path& file, const WorkWatch& watch) {
  WorkSteps steps(watch);
  auto done = read_in_steps(context, actor, file, steps);
  if (!done && steps.stopped()) return fail(StorageError::stopped, file.string());
  return done;
}

}  // namespace cusp::storage
