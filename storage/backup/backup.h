/// Backups: database, station key and rollback counter of one moment, in a folder of their own, checked after writing.
/// Other connections write on meanwhile. A folder without its description is no backup: it was not finished.
/// Thread: the context's own; a large database takes seconds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "storage/base/rights.h"
#include "storage/base/watch.h"
#include "storage/records/context.h"

namespace cusp::storage {

/// Written last: a folder without it is no backup.
inline constexpr const char* kBackupDescription = "backup.json";

/// Each kind has a rotation of its own.
enum class BackupKind : std::uint8_t {
  daily,   // the program made it by itself; a description that names no kind is older, and counts as one
  manual,  // somebody with the right asked for it
};

struct Backup {
  std::filesystem::path folder{};
  Uuid station{};
  std::int64_t made_utc_us = 0;
  std::uint64_t sessions = 0;
  std::uint64_t bytes = 0;  // of the database
  BackupKind kind = BackupKind::manual;
  std::uint64_t order = 0;  // a newer one of the station has a greater one, whatever the clock said; 0: an older program made it
};

/// A new folder in `into`, which is made at need. Needs manage_station, at the end as the records have it then; without an actor the
/// program makes its daily one.
/// disk_full where the disk has no room for a copy: nothing is written. The copy is opened, checked for damage and synced. After a failure
/// no part of it is left, nor `into` if it was made for it.
/// Removes what a backup there, or restore_backup() of the database, left when it was cut off more than a day ago. `watch`: pages of the
/// copy, then all of all while it is checked. stopped, as any failure, leaves no entry in the log.
Stored<Backup> make_backup(StorageContext& context, const std::optional<Actor>& actor, const std::filesystem::path& into,
                           const WorkWatch& watch = {});

/// Of this station, or of every one without a station, newest first: several may share a folder. Those of one station stand by Backup::order,
/// which a wrong clock does not change. Empty if the folder does not exist; a drive that does not answer is a failure.
Stored<std::vector<Backup>> backups_in(const std::filesystem::path& into, const std::optional<Uuid>& station);
/// not_found unless the folder holds a whole backup.
Stored<Backup> read_backup(const std::filesystem::path& folder);
/// Removes all of this station and kind but the newest `keep` ones, and what a backup that was cut off left more than a day ago: it holds
/// a secret key. Of daily ones with about the same date half of `keep` stay at most. Without an order those dated after `now_utc_us` count as the
/// oldest; what a link leads to stays, and does not count. One that cannot be removed stops no other, and what is left of it is no backup; the
/// failure names the first.
Stored<void> thin_backups(const std::filesystem::path& into, const Uuid& station, BackupKind kind, std::size_t keep, std::int64_t now_utc_us);

/// Work on the new database and what lies beside it, before they get their names. It closes what it opens.
using FinishRestored = std::function<Stored<void>(const std::filesystem::path& database)>;

/// Writes the backup's database to a new file, with key and counter beside it. duplicate if one of them, or a log or journal, exists,
/// or if one of them comes meanwhile: nothing is overwritten or removed. duplicate, detail "finished": an earlier restore was killed
/// between two names, and this call has given the rest of its files theirs. not_found if the backup is removed meanwhile. corrupt if the
/// backup or its key is damaged; detail "sessions": the database holds another number of them than `backup`. A failure, also of
/// `finish`, leaves no new file; what a restore of the same name that was cut off left more than a day ago goes. log_restored() belongs
/// into `finish`, or follows in the store of the new file. After a program that is killed between two names, Store::open() finishes,
/// too.
Stored<void> restore_backup(const Backup& backup, const std::filesystem::path& file, const FinishRestored& finish = {});
/// The same where a database stands that cannot be read: it moves as by put_aside() once the copy is whole, so that a program that is
/// killed before leaves it in its place; after one that is killed later, Store::open() finishes. Returns the folder that holds it. busy if
/// a connection of any process uses the file. After a failure all is where it was. Follows links.
Stored<std::filesystem::path> restore_in_place(const Backup& backup, const std::filesystem::path& name, std::int64_t utc_us,
                                               const FinishRestored& finish);
/// Moves a database that cannot be read, with its log, index, key and counter, to a new folder beside it; nothing is deleted. Returns
/// the folder, "station.db-damaged-2026-11-20T09-14-03Z". busy and failures as above.
Stored<std::filesystem::path> put_aside(const std::filesystem::path& file, std::int64_t utc_us);
/// Moves back what put_aside() moved there. duplicate if something stands in its place.
Stored<void> take_back(const std::filesystem::path& folder, const std::filesystem::path& file);
/// The entry "restored" of the audit log.
Stored<void> log_restored(StorageContext& context, const Backup& backup);

}  // namespace cusp::storage
