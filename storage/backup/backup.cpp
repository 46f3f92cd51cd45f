#include "storage/backup/backup.h"

#include <algorithm>

#include "storage/backup/half_restored.h"
#include "storage/backup/kept_backups.h"
#include "storage/base/files.h"
#include "storage/base/process.h"
#include "storage/records/rollback_counter.h"
#include "storage/records/sealing.h"
#include "storage/records/audit_writer.h"
#include "storage/records/current_rights.h"
#include "storage/sqlite/hold_alone.h"

namespace cusp::storage {
namespace {

namespace fs = std::filesystem;

/// "cusp-2026-11-20T09-14-03Z": no file system refuses it, and names sort by time.
std::string name_at(const std::string& what, std::int64_t utc_us) {
  std::string time = iso_utc(utc_us);
  std::ranges::replace(time, ':', '-');
  return what + '-' + time;
}

/// A new folder in `into`, named for `what` and the time. Only its owner can enter it.
Stored<fs::path> new_folder(const fs::path& into, const std::string& what, std::int64_t utc_us) {
  std::error_code error;
  fs::create_directories(into, error);
  if (error) return std::unexpected(failure_from(error, into));
  for (int n = 1; n < 1000; ++n) {
    const fs::path folder = into / (name_at(what, utc_us) + (n == 1 ? std::string() : "-" + std::to_string(n)));
    const auto made = make_private_folder(folder);
    if (made) return folder;
    if (made.error().code != StorageError::duplicate) return std::unexpected(made.error());
  }
  return fail(StorageError::duplicate, into.string());
}

Stored<void> copy_private(const fs::path& from, const fs::path& to) {
  const auto content = read_private_file(from);
  if (!content) return std::unexpected(content.error());
  // A file opened for reading may have none; a counter may be gone, which its incident names.
  return *content ? write_private_file(to, **content) : Stored<void>{};
}

bool concerns_disk(StorageError code) noexcept {
  return out_of_space(code) || code == StorageError::file_too_large || code == StorageError::read_only ||
         code == StorageError::io || code == StorageError::not_found;
}

/// The whole of the connection's database as of one moment, in a file that only its owner can read. If `goes_on` answers false, part of it.
Stored<void> copy_database(Database& from, const fs::path& to, std::function<bool()> goes_on = {}) {
  static_cast<void>(make_private_file(to));  // if none can be made, SQLite reports why
  // An absolute path: SQLite would take a name that begins with "file:" for a URI.
  std::error_code ignored;
  const StatementWatch watch(from, std::move(goes_on));
  auto done = from.run("VACUUM INTO ?1", fs::absolute(to, ignored).string());
  // SQLite names the source, which is only read.
  if (!done && concerns_disk(done.error().code)) done.error().where = to.string();
  return done;
}

struct Pages {
  std::size_t used = 0, bytes = 1;  // `bytes` of one
};
Pages pages_of(Database& db) {
  const auto pages = db.first(
      "SELECT page_count - freelist_count, page_size FROM pragma_page_count(), pragma_freelist_count(), pragma_page_size()",
      [](Row row) { return Pages{row.u64(0), row.u64(1)}; });
  return pages ? pages->value_or(Pages{}) : Pages{};
}

/// disk_full before anything is written: a copy that fills the disk holds up every attempt that is recorded there meanwhile.
Stored<void> check_room(Database& db, const fs::path& into) {
  std::error_code error;
  fs::path there = fs::absolute(into, error);
  while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  const fs::space_info disk = fs::space(there, error);
  const Pages pages = pages_of(db);
  // Some network drives know no sizes.
  if (error || disk.capacity == 0 || disk.available / pages.bytes >= pages.used) return {};
  return fail(StorageError::disk_full, into.string());
}

/// Reports pages: SQLite does not count what it has copied, but the file grows.
Stored<void> copy_by_pages(Database& from, const fs::path& to, WorkSteps& steps) {
  const Pages pages = pages_of(from);
  steps.begin(pages.used);
  if (!steps.go_on()) return fail(StorageError::stopped, to.string());
  auto done = copy_database(from, to, [&] {
    std::error_code error;
    const auto bytes = fs::file_size(to, error);
    if (!error) steps.set_done(bytes / pages.bytes);
    return steps.go_on();
  });
  if (done) steps.end();
  return done;
}

/// Opening for writing syncs the file, for it changes its first page. Returns how many sessions it holds.
Stored<std::uint64_t> check_copy(const fs::path& file, const DatabaseOptions& options, std::function<bool()> goes_on = {}) {
  auto copy = Database::open(file, options);
  if (!copy) return std::unexpected(copy.error());
  const StatementWatch watch(*copy, std::move(goes_on));
  const auto damage = copy->integrity_check();
  if (!damage) return std::unexpected(damage.error());
  if (!damage->empty()) return fail(StorageError::corrupt, file.string(), *damage);
  const auto sessions = copy->first("SELECT count(*) FROM sessions", [](Row row) { return row.u64(0); });
  if (!sessions) return std::unexpected(sessions.error());
  return sessions->value_or(0);
}

/// The counter first: it may lag behind the log and never leads.
Stored<Backup> fill(StorageContext& context, const fs::path& folder, BackupKind kind, std::int64_t now, WorkSteps& steps) {
  if (auto done = copy_private(context.counter_file, counter_file_of(folder / kBackupKey)); !done) return std::unexpected(done.error());
  if (auto done = copy_private(context.key_file, folder / kBackupKey); !done) return std::unexpected(done.error());
  if (auto done = copy_by_pages(context.db, folder / kBackupDatabase, steps); !done) return std::unexpected(done.error());
  const auto sessions = check_copy(folder / kBackupDatabase,
                                   {.access = DatabaseOptions::Access::existing, .on_network_drive = admits_network_drive},
                                   [&steps] { return steps.go_on(); });
  if (!sessions) return std::unexpected(sessions.error());
  if (!steps.go_on()) return fail(StorageError::stopped, folder.string());
  std::error_code error;
  const auto bytes = fs::file_size(folder / kBackupDatabase, error);
  if (error) return std::unexpected(failure_from(error, folder));
  const Backup backup{folder, context.station, now, *sessions, bytes, kind, next_order(context, folder.parent_path())};
  if (auto done = write_description(backup); !done) return std::unexpected(done.error());
  return backup;
}

/// corrupt if the file is there and holds no whole key.
Stored<void> check_key_file(const fs::path& file) {
  const auto content = read_private_file(file);
  if (!content) return std::unexpected(content.error());
  if (*content && !station_key_from(**content)) return fail(StorageError::corrupt, file.string());
  return {};
}

Stored<void> copy_back(const Backup& backup, const fs::path& file) {
  const fs::path key = file.string() + ".key";
  if (auto good = check_key_file(backup.folder / kBackupKey); !good) return good;
  auto from = Database::open(backup.folder / kBackupDatabase,
                             {.access = DatabaseOptions::Access::read_only, .on_network_drive = admits_network_drive});
  if (!from) return std::unexpected(from.error());
  const auto damage = from->integrity_check();
  if (!damage) return std::unexpected(damage.error());
  if (!damage->empty()) return fail(StorageError::corrupt, backup.folder.string(), *damage);
  if (auto done = copy_database(*from, file); !done) return done;
  if (auto done = copy_private(counter_file_of(backup.folder / kBackupKey), counter_file_of(key)); !done) return done;
  if (auto done = copy_private(backup.folder / kBackupKey, key); !done) return done;
  const auto sessions = check_copy(file, {.access = DatabaseOptions::Access::existing});
  if (!sessions) return std::unexpected(sessions.error());
  if (*sessions != backup.sessions) return fail(StorageError::corrupt, backup.folder.string(), "sessions");
  // Who removes a backup begins with its description: if that is there, so was the key.
  if (const auto whole = read_backup(backup.folder); !whole) return std::unexpected(whole.error());
  return {};
}

}  // namespace

Stored<Backup> make_backup(StorageContext& context, const std::optional<Actor>& actor, const fs::path& into, const WorkWatch& watch) {
  if (actor) {
    if (auto allowed = require(*actor, Action::manage_station); !allowed) return std::unexpected(allowed.error());
  }
  std::error_code ignored;
  const bool is_new = fs::symlink_status(into, ignored).type() == fs::file_type::not_found;
  const std::int64_t now = context.clock();
  for (const fs::path& left : abandoned_in(into)) remove_copy(left);  // thin_backups() reports what stays
  if (auto room = check_room(context.db, into); !room) return std::unexpected(room.error());
  const auto folder = new_folder(into, "cusp", now);
  const auto take_back_all = [&] {
    if (folder) remove_copy(*folder);
    if (is_new) fs::remove(into, ignored);  // only if it is empty
  };
  if (!folder) {
    take_back_all();
    return std::unexpected(folder.error());
  }
  WorkSteps steps(watch);
  auto backup = fill(context, *folder, actor ? BackupKind::manual : BackupKind::daily, now, steps);
  if (!backup) {
    take_back_all();
    if (steps.stopped()) return fail(StorageError::stopped, into.string());
    return backup;
  }
  if (context.db.read_only()) return backup;
  Transaction transaction(context.db);
  if (actor) require_now(transaction, actor->id, Action::manage_station);
  log_event(context, transaction,
            {.actor = actor ? actor->id : UserId{}, .action = "backed_up", .subject = context.station,
             .detail = std::to_string(backup->sessions)});
  if (auto done = commit_sealed(context, transaction); !done) {
    take_back_all();
    return std::unexpected(done.error());
  }
  // A restore that succeeded at the second try is the last one of its name.
  remove_left_restores(context.db.file());
  return backup;
}

namespace {

/// The copy in a folder beside the new file, which goes in the end. `take_name` gives it its name there.
Stored<void> restore_beside(const Backup& backup, const fs::path& file, const FinishRestored& finish, const FinishRestored& take_name) {
  std::error_code error;
  const fs::path parent = fs::absolute(file, error).parent_path();
  if (!fs::is_directory(parent, error)) return fail(StorageError::not_found, parent.string(), "folder");
  remove_left_restores(file);  // each holds a secret key
  const fs::path folder = parent / (std::string(kRestoring) + Uuid::v7().text());
  if (auto made = make_private_folder(folder); !made) return fail(made.error().code, file.string(), made.error().detail);
  const fs::path fresh = folder / file.filename();
  auto done = copy_back(backup, fresh);
  if (done && finish) done = finish(fresh);
  if (done) done = take_name(fresh);
  // Without a database at the name, the next start needs the note.
  if (!is_half_done(folder, file)) {
    take_note_back(fresh);
    remove_copy(folder);
  }
  // People know the name that they gave, not the folder.
  if (!done && done.error().where.starts_with(folder.string())) done.error().where = file.string();
  return done;
}

}  // namespace

Stored<void> restore_backup(const Backup& backup, const fs::path& file, const FinishRestored& finish) {
  const auto finished = finish_half_done(file);
  if (finished && *finished) return fail(StorageError::duplicate, file.string(), "finished");
  // While another restore takes the names, one of them is a duplicate.
  if (!finished && finished.error().code != StorageError::busy) return std::unexpected(finished.error());
  if (auto free = nothing_beside(file); !free) return free;
  return restore_beside(backup, file, finish, [&file](const fs::path& fresh) -> Stored<void> {
    const ProcessMark mark(lock_of_half_done(fresh));
    if (auto noted = note_half_done(fresh, file, {}, mark.text()); !noted) return noted;
    auto named = name_restored(fresh, file);
    if (!named) take_note_back(fresh);
    return named;
  });
}

namespace {

/// `before_move` is called with the new folder while no connection can begin to use the file.
Stored<fs::path> move_aside(const fs::path& file, std::int64_t utc_us, const std::function<Stored<void>(const fs::path&)>& before_move) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return fail(StorageError::not_found, file.string());
  const auto alone = hold_alone(file);
  if (!alone) return std::unexpected(alone.error());
  const auto folder = new_folder(fs::absolute(file, error).parent_path(), file.filename().string() + std::string(kAside), utc_us);
  if (!folder) return folder;
  auto moved = before_move(*folder);
  if (moved) moved = move_away(file, *folder / file.filename());
  if (moved) return folder;
  fs::remove(*folder, error);  // only if it is empty
  return std::unexpected(moved.error());
}

}  // namespace

Stored<fs::path> put_aside(const fs::path& file, std::int64_t utc_us) {
  return move_aside(file, utc_us, [](const fs::path&) { return Stored<void>{}; });
}

Stored<void> take_back(const fs::path& folder, const fs::path& file) {
  if (auto free = nothing_beside(file); !free) return free;
  if (auto moved = move_home(folder / file.filename(), file); !moved) return moved;
  std::error_code ignored;
  fs::remove(folder, ignored);
  return {};
}

Stored<fs::path> restore_in_place(const Backup& backup, const fs::path& name, std::int64_t utc_us, const FinishRestored& finish) {
  std::error_code ignored;
  // A link that was moved would leave the damaged files where they are, and leads nowhere from another folder.
  const fs::path file = fs::is_symlink(name, ignored) ? behind_links(name) : name;
  fs::path aside;
  const auto take_place = [&](const fs::path& fresh) -> Stored<void> {
    const ProcessMark mark(lock_of_half_done(fresh));
    auto moved = move_aside(file, utc_us, [&](const fs::path& folder) { return note_half_done(fresh, file, folder, mark.text()); });
    if (!moved) return std::unexpected(moved.error());
    aside = *moved;
    auto named = name_restored(fresh, file);
    if (!named) static_cast<void>(take_back(aside, file));
    return named;
  };
  if (auto done = restore_beside(backup, file, finish, take_place); !done) return std::unexpected(done.error());
  return aside;
}

Stored<void> log_restored(StorageContext& context, const Backup& backup) {
  Transaction transaction(context.db);
  log_event(context, transaction,
            {.action = "restored", .subject = context.station, .detail = std::to_string(backup.made_utc_us)});
  return commit_sealed(context, transaction);
}

}  // namespace cusp::storage
