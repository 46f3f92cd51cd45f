#include "storage/store.h"

#include "storage/backup/half_restored.h"
#include "storage/base/files.h"
#include "storage/records/audit_writer.h"
#include "storage/records/rollback_counter.h"
#include "storage/records/sealing.h"

namespace cusp::storage {
namespace {

Stored<StationKey> read_or_make_key(const std::filesystem::path& file) {
  auto content = read_private_file(file);
  if (!content) return std::unexpected(content.error());
  if (!*content) {
    const StationKey key = StationKey::make();
    auto written = write_private_file(file, std::string(key.secret_key.begin(), key.secret_key.end()));
    if (written) return key;
    if (written.error().code != StorageError::duplicate) return std::unexpected(written.error());
    content = read_private_file(file);
    if (!content) return std::unexpected(content.error());
  }
  const auto key = station_key_from(content->value_or(""));
  if (!key) return fail(StorageError::corrupt, file.string(), "key");
  return *key;
}

/// Whether the file is there and has lost every byte: the counter, which the station's key has signed, counted entries. Another program that
/// makes the file now writes its counter after its file: the counter is read first.
bool is_emptied(const std::filesystem::path& file, const std::filesystem::path& key_file) {
  const auto counter = read_counter(counter_file_of(key_file));
  if (!counter || !*counter || (*counter)->log.links == 0) return false;
  const auto content = read_private_file(key_file);
  const auto key = content ? station_key_from(content->value_or("")) : std::nullopt;
  if (!key || key->id() != (*counter)->key) return false;
  std::error_code error;
  return std::filesystem::file_size(file, error) == 0 && !error;
}

/// Station row and key, under the database's write lock: processes that start together agree on both.
Stored<void> ready_station(StorageContext& context, const std::filesystem::path& key_file) {
  Transaction transaction(context.db);
  auto station = transaction.first("SELECT id FROM station", [](Row row) { return row.uuid(0); });
  if (!station) {
    station = Uuid::v7();
    transaction.run("INSERT INTO station (one, id, next_sequence) VALUES (1, ?1, 1)", *station);
  }
  context.station = *station;
  if (transaction.ok()) {
    auto key = read_or_make_key(key_file);
    if (key) {
      context.key = *key;
    } else {
      transaction.refuse(std::move(key.error()));
    }
  }
  if (transaction.ok()) {
    remove_left_writes(key_file);  // second names of the secret
    const Hash256 id = context.key->id();
    transaction.run("INSERT OR IGNORE INTO station_keys (id, public_key, added_at) VALUES (?1, ?2, ?3)", id,
                    context.key->public_key, context.clock());
    if (transaction.ok() && context.db.changes() > 0) {
      log_event(context, transaction,
                {.action = "station_key_added", .subject = context.station, .detail = hex(id)});
    }
  }
  return transaction.commit();
}

}  // namespace

std::filesystem::path station_key_file(const std::filesystem::path& database) {
  std::error_code ignored;
  const std::filesystem::path own = behind_links(database).string() + ".key", linked = database.string() + ".key";
  return !std::filesystem::exists(own, ignored) && std::filesystem::exists(linked, ignored) ? linked : own;
}

std::optional<Uuid> station_beside(const std::filesystem::path& database) {
  const auto counter = read_counter(counter_file_of(station_key_file(database)));
  return counter && *counter ? std::optional((*counter)->station) : std::nullopt;
}

Store::Store(StorageContext context)
    : context_{std::move(context)},
      audit{context_},
      blobs{context_},
      accounts{context_},
      cohorts{context_},
      scenarios{context_},
      assignments{context_},
      device_tests{context_},
      sessions{context_},
      traces{context_},
      metrics{context_},
      grades{context_},
      comments{context_},
      statements{context_},
      history{context_},
      key_states{context_} {}

Stored<std::unique_ptr<Store>> Store::open(const std::filesystem::path& file, StoreOptions options) {
  // Key, counter and lock file of one database are the same under each name that leads to it.
  const std::filesystem::path real = behind_links(file);
  // A restore that was killed leaves no database at the name, as before a first start.
  if (auto finished = finish_half_done(real); !finished) return std::unexpected(finished.error());
  const auto key_file = options.key_file.empty() ? station_key_file(file) : options.key_file;
  // SQLite would begin a new file there: nobody would miss the records, and the first to come would be the administrator.
  if (options.database.access == DatabaseOptions::Access::create && is_emptied(real, key_file)) return fail(StorageError::corrupt, real.string());
  auto database = Database::open(real, options.database);
  if (!database) return std::unexpected(database.error());
  auto store = std::make_unique<Store>(
      StorageContext{std::move(*database), std::move(options.clock), options.cost, Uuid{}, std::nullopt});
  StorageContext& context = store->context();
  if (options.tries) context.tries = std::move(options.tries);
  context.key_file = key_file;
  context.counter_file = counter_file_of(key_file);
  if (context.db.read_only()) {
    const auto station = context.db.first("SELECT id FROM station", [](Row row) { return row.uuid(0); });
    if (!station) return std::unexpected(station.error());
    context.station = station->value_or(Uuid{});
    note_counter_incident(context);
    return store;
  }
  if (auto ready = ready_station(context, key_file); !ready) return std::unexpected(ready.error());
  if (auto sealed = begin_sealing(context); !sealed) return std::unexpected(sealed.error());
  if (options.mark_interrupted) {
    if (auto marked = store->sessions.mark_interrupted(); !marked) return std::unexpected(marked.error());
  }
  return store;
}

}  // namespace cusp::storage
