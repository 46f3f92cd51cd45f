/// Backups: whole, of one moment, beside a program that writes on; and what restoring one gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <barrier>
#include <cerrno>
#include <fstream>
#include <functional>
#include <thread>

#include "storage/backup/backup.h"
#include "storage/base/files.h"
#include "tests/refused_calls.h"
#include "tests/storage/school.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

struct BackupTest : ::testing::Test {
  Folder folder;
  std::shared_ptr<std::int64_t> now = std::make_shared<std::int64_t>(kNow);
  std::unique_ptr<Store> store = open(folder / "a.db", quick(now));
  Actor administrator = make_administrator(*store).actor();
  Account lena = make_student(*store);
  ScenarioVersion version = keep(*store);
  fs::path into() { return folder / "backups"; }
  Uuid station() { return store->context().station; }
  Backup make() { return must(make_backup(store->context(), administrator, into())); }
  std::size_t folders() {
    return fs::exists(into()) ? static_cast<std::size_t>(std::distance(fs::directory_iterator(into()), {})) : 0;
  }
  /// What a restore to new.db has left, by name.
  std::vector<std::string> left() {
    std::vector<std::string> out;
    for (const auto& entry : fs::directory_iterator(into().parent_path())) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("new.db") || name.starts_with(".cusp-restore")) out.push_back(name);
    }
    std::ranges::sort(out);
    return out;
  }
  const std::vector<std::string> whole = {"new.db", "new.db.key", "new.db.key-counter"};
};

/// Where link() fails with this errno. False: `work` was not called.
bool without_links(std::uint32_t error, const std::vector<RefusedCall>& more, const std::function<void()>& work) {
  std::vector<RefusedCall> calls = links_refused(error);
  calls.insert(calls.end(), more.begin(), more.end());
  bool refused = false;
  std::thread([&] {
    refused = refuse_calls(calls);
    if (refused) work();
  }).join();
  return refused;
}

TEST_F(BackupTest, restored_is_the_same_school_whole_and_says_so_in_its_log) {
  const SessionId session = complete_session(*store, lena, version);
  const Backup backup = make();
  EXPECT_EQ(backup.sessions, 1u);
  EXPECT_EQ(backup.folder.filename(), "cusp-2026-11-20T09-14-03Z");
  EXPECT_EQ(must(read_backup(backup.folder)).bytes, backup.bytes);

  must(restore_backup(backup, folder / "new.db"));
  const auto restored = open(folder / "new.db");
  must(log_restored(restored->context(), backup));
  EXPECT_FALSE(restored->context().incident);
  EXPECT_TRUE(must(verify_store(restored->context())).intact());
  EXPECT_EQ(must(restored->history.details(lena.actor(), session)).row.score, 81.5);
  must(restored->accounts.sign_in("admin", "correct horse"));
  const auto entries = must(restored->audit.list(administrator, 10));
  EXPECT_TRUE(std::ranges::any_of(entries, [](const AuditEntry& e) { return e.action == "restored"; }));
}

TEST_F(BackupTest, holds_one_moment_while_a_session_goes_on) {
  const SessionId running = must(store->sessions.start(lena.actor(), new_session(lena, version))).id;
  must(store->traces.append(running, second_from(1)));
  const auto other = open(folder / "a.db", quick(now));
  const Backup backup = must(make_backup(other->context(), administrator, into()));
  must(store->traces.append(running, second_from(13)));
  must(store->sessions.finish(running, volume_after(24), "student"));
  must(restore_backup(backup, folder / "new.db"));
  const auto restored = open(folder / "new.db");
  EXPECT_TRUE(must(verify_store(restored->context())).intact());
  EXPECT_EQ(must(restored->traces.inputs(running)).size(), 12u);
}

TEST_F(BackupTest, and_what_is_restored_from_it_are_readable_by_their_owner_alone) {
  const Umask usual(022);
  const Backup backup = make();
  EXPECT_EQ(mode_of(backup.folder), 0700u);
  for (const auto& entry : fs::directory_iterator(backup.folder)) EXPECT_EQ(mode_of(entry.path()), 0600u) << entry.path();
  must(restore_backup(backup, folder / "new.db", [](const fs::path& database) -> Stored<void> {
    EXPECT_EQ(mode_of(database.parent_path()), 0700u);
    return {};
  }));
  for (const std::string& name : left()) EXPECT_EQ(mode_of(folder / name), 0600u) << name;
  EXPECT_EQ(left(), whole);
  store.reset();
  EXPECT_EQ(mode_of(must(put_aside(folder / "new.db", *now))), 0700u);
}

TEST_F(BackupTest, needs_the_right_and_leaves_nothing_where_it_fails) {
  EXPECT_EQ(code_of(make_backup(store->context(), lena.actor(), into())), StorageError::not_allowed);
  EXPECT_EQ(folders(), 0u);
  std::ofstream(folder / "file") << "no folder";
  EXPECT_FALSE(make_backup(store->context(), administrator, folder / "file" / "backups"));
  fs::remove(store->context().key_file);
  fs::create_directory(store->context().key_file);
  EXPECT_FALSE(make_backup(store->context(), administrator, into()));
  EXPECT_FALSE(fs::exists(into()));
}

TEST_F(BackupTest, of_one_second_have_folders_of_their_own_and_the_oldest_go_first) {
  make();
  make();
  EXPECT_EQ(folders(), 2u);
  *now += 86'400'000'000;
  const Backup newest = make();
  ASSERT_EQ(must(backups_in(into(), station())).size(), 3u);
  EXPECT_EQ(must(backups_in(into(), station())).front().folder, newest.folder);
  must(thin_backups(into(), station(), BackupKind::manual, 1, *now));
  ASSERT_EQ(must(backups_in(into(), station())).size(), 1u);
  EXPECT_EQ(must(backups_in(into(), station())).front().folder, newest.folder);
  EXPECT_TRUE(must(backups_in(folder / "nowhere", station())).empty());
}

TEST_F(BackupTest, that_a_wrong_clock_dated_in_the_future_goes_before_what_is_made_since) {
  *now += 400 * std::int64_t{86'400'000'000};
  make();
  *now -= 400 * std::int64_t{86'400'000'000};
  const Backup fresh = make();
  must(thin_backups(into(), station(), BackupKind::manual, 1, *now));
  const auto left = must(backups_in(into(), station()));
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left.front().folder, fresh.folder);
}

TEST_F(BackupTest, of_another_station_in_the_same_folder_are_neither_listed_nor_removed) {
  const Backup own = make();
  const auto other = open(folder / "b.db", quick(now));
  const Backup foreign = must(make_backup(other->context(), make_administrator(*other).actor(), into()));
  must(thin_backups(into(), station(), BackupKind::manual, 0, *now));
  EXPECT_FALSE(fs::exists(own.folder));
  EXPECT_EQ(must(read_backup(foreign.folder)).station, other->context().station);
  EXPECT_TRUE(must(backups_in(into(), station())).empty());
}

TEST_F(BackupTest, an_unfinished_folder_is_none) {
  const Backup backup = make();
  fs::remove(backup.folder / "backup.json");
  EXPECT_TRUE(must(backups_in(into(), station())).empty());
  EXPECT_EQ(code_of(read_backup(backup.folder)), StorageError::not_found);
  std::ofstream(backup.folder / "backup.json") << R"({"cusp_backup": 2})";
  EXPECT_EQ(code_of(read_backup(backup.folder)), StorageError::not_found);
}

TEST_F(BackupTest, restoring_overwrites_nothing) {
  const Backup backup = make();
  for (const char* name : {"x.db", "y.db.key", "z.db.key-counter"}) std::ofstream(folder / name) << "kept";
  for (const char* name : {"x.db", "y.db", "z.db"}) {
    EXPECT_EQ(code_of(restore_backup(backup, folder / name)), StorageError::duplicate) << name;
  }
  EXPECT_EQ(fs::file_size(folder / "x.db"), 4u);
  EXPECT_FALSE(fs::exists(folder / "y.db"));
}

TEST_F(BackupTest, restored_by_several_at_once_is_there_once_and_whole) {
  complete_session(*store, lena, version);
  const Backup backup = make();
  constexpr std::size_t kAtOnce = 6;
  std::vector<Stored<void>> done(kAtOnce);
  std::barrier<> start(static_cast<std::ptrdiff_t>(kAtOnce));
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < kAtOnce; ++i) {
    threads.emplace_back([&, i] {
      start.arrive_and_wait();
      done[i] = restore_backup(backup, folder / "new.db");
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::ranges::count_if(done, [](const Stored<void>& one) { return one.has_value(); }), 1);
  for (const Stored<void>& one : done) {
    if (!one) {
      EXPECT_EQ(one.error().code, StorageError::duplicate) << one.error().where << ": " << one.error().detail;
    }
  }
  EXPECT_EQ(left(), whole);
  EXPECT_TRUE(must(verify_store(open(folder / "new.db")->context())).intact());
}

TEST_F(BackupTest, what_another_restores_meanwhile_stays) {
  const Backup backup = make();
  const fs::path file = folder / "new.db";
  EXPECT_EQ(code_of(restore_backup(backup, file, [&](const fs::path&) { return restore_backup(backup, file); })), StorageError::duplicate);
  EXPECT_EQ(left(), whole);
  const auto restored = open(file);
  EXPECT_FALSE(restored->context().incident);
  EXPECT_TRUE(must(verify_store(restored->context())).intact());
}

TEST_F(BackupTest, with_a_damaged_key_is_not_restored) {
  const Backup backup = make();
  for (const std::string& content : {std::string("short"), std::string(64, 'x')}) {
    std::ofstream(backup.folder / "station.db.key", std::ios::binary) << content;
    EXPECT_EQ(code_of(restore_backup(backup, folder / "new.db")), StorageError::corrupt) << content;
    EXPECT_TRUE(left().empty()) << left().front();
  }
}

TEST_F(BackupTest, that_holds_another_number_of_sessions_than_its_description_is_not_restored) {
  complete_session(*store, lena, version);
  Backup backup = make();
  for (const std::uint64_t sessions : {0u, 2u}) {
    backup.sessions = sessions;
    const auto done = restore_backup(backup, folder / "new.db");
    ASSERT_EQ(code_of(done), StorageError::corrupt) << sessions;
    EXPECT_EQ(done.error().detail, "sessions");
    EXPECT_EQ(done.error().where, backup.folder.string());
    EXPECT_TRUE(left().empty()) << left().front();
  }
}

TEST_F(BackupTest, leaves_no_file_where_the_work_after_restoring_fails) {
  const Backup backup = make();
  const auto done = restore_backup(backup, folder / "new.db", [](const fs::path& database) -> Stored<void> {
    return fail(StorageError::disk_full, database.string());
  });
  ASSERT_EQ(code_of(done), StorageError::disk_full);
  EXPECT_EQ(done.error().where, (folder / "new.db").string());
  EXPECT_TRUE(left().empty()) << left().front();
}

TEST_F(BackupTest, is_made_and_restored_on_a_drive_without_hard_links) {
  complete_session(*store, lena, version);
  struct Drive {
    std::uint32_t error;
    std::vector<RefusedCall> more;
  };
  int drives = 0;
  // FAT; a share without links; FUSE; AFS, which links within one folder alone; an old FUSE driver, which has no RENAME_NOREPLACE either.
  for (const Drive& drive : {Drive{EPERM, {}}, Drive{EOPNOTSUPP, {}}, Drive{ENOSYS, {}}, Drive{EXDEV, {}}, Drive{EPERM, {{SYS_renameat2, EINVAL}}}}) {
    SCOPED_TRACE(drives);
    const fs::path file = folder / ("new.db" + std::to_string(drives++));
    Stored<Backup> backup = fail(StorageError::io, "not made");
    Stored<void> restored, again, taken;
    const bool ran = without_links(drive.error, drive.more, [&] {
      backup = make_backup(store->context(), administrator, into());
      if (backup) restored = restore_backup(*backup, file);
      if (backup) again = restore_backup(*backup, file);
      taken = write_private_file(file.string() + ".key", "another");
    });
    if (!ran) GTEST_SKIP() << "the kernel admits no filter of system calls";
    must(backup);
    must(restored);
    EXPECT_EQ(code_of(again), StorageError::duplicate);
    EXPECT_EQ(code_of(taken), StorageError::duplicate);
    EXPECT_TRUE(must(verify_store(open(file)->context())).intact());
  }
}

TEST_F(BackupTest, damaged_records_are_put_aside_whole_and_a_backup_takes_their_place) {
  const SessionId session = complete_session(*store, lena, version);
  const Backup backup = make();
  store.reset();
  const fs::path file = folder / "a.db";
  const auto size = fs::file_size(file);
  fs::resize_file(file, size / 2);
  const fs::path aside = must(put_aside(file, *now));
  EXPECT_EQ(aside.filename(), "a.db-damaged-2026-11-20T09-14-03Z");
  EXPECT_EQ(fs::file_size(aside / "a.db"), size / 2);
  EXPECT_TRUE(fs::exists(aside / "a.db.key"));
  EXPECT_FALSE(fs::exists(file));
  must(restore_backup(backup, file));
  store = open(file, quick(now));
  must(log_restored(store->context(), backup));
  EXPECT_FALSE(store->context().incident);
  EXPECT_EQ(must(store->history.details(lena.actor(), session)).row.score, 81.5);
  EXPECT_TRUE(must(verify_store(store->context())).intact());
}

TEST_F(BackupTest, takes_the_place_of_damaged_records_once_its_copy_is_whole) {
  const SessionId session = complete_session(*store, lena, version);
  const Backup backup = make();
  store.reset();
  const fs::path file = folder / "a.db";
  const auto size = fs::file_size(file) / 2;
  fs::resize_file(file, size);
  const auto beside = [&] {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(file.parent_path())) names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
  };
  const std::vector<std::string> before = beside();
  const auto refused = restore_in_place(backup, file, *now, [&](const fs::path& copy) -> Stored<void> {
    EXPECT_EQ(fs::file_size(file), size) << "whoever is killed here leaves the records in their place";
    EXPECT_TRUE(fs::exists(file.string() + ".key"));
    return fail(StorageError::disk_full, copy.string());
  });
  EXPECT_EQ(code_of(refused), StorageError::disk_full);
  EXPECT_EQ(refused.error().where, file.string());
  EXPECT_EQ(beside(), before);
  EXPECT_EQ(fs::file_size(file), size);

  const fs::path aside = must(restore_in_place(backup, file, *now, [&](const fs::path& copy) { return log_restored(open(copy, quick(now))->context(), backup); }));
  EXPECT_EQ(aside.filename(), "a.db-damaged-2026-11-20T09-14-03Z");
  EXPECT_EQ(fs::file_size(aside / "a.db"), size);
  EXPECT_TRUE(fs::exists(aside / "a.db.key"));
  store = open(file, quick(now));
  EXPECT_FALSE(store->context().incident);
  EXPECT_EQ(must(store->history.details(lena.actor(), session)).row.score, 81.5);
  EXPECT_TRUE(must(verify_store(store->context())).intact());
}

TEST_F(BackupTest, what_was_put_aside_comes_back_where_nothing_took_its_place) {
  store.reset();
  const fs::path file = folder / "a.db";
  const fs::path aside = must(put_aside(file, *now));
  std::ofstream(file.string() + ".key") << "another";
  EXPECT_EQ(code_of(take_back(aside, file)), StorageError::duplicate);
  EXPECT_TRUE(fs::exists(aside / "a.db"));
  fs::remove(file.string() + ".key");
  must(take_back(aside, file));
  EXPECT_FALSE(fs::exists(aside));
  EXPECT_TRUE(must(verify_store(open(file, quick(now))->context())).intact());
  EXPECT_EQ(code_of(put_aside(folder / "nowhere.db", *now)), StorageError::not_found);
}

TEST_F(BackupTest, all_in_a_folder_are_listed_where_no_station_is_known) {
  const Backup backup = make();
  EXPECT_EQ(must(backups_in(into(), Uuid::v7())).size(), 0u);
  const auto all = must(backups_in(into(), std::nullopt));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].folder, backup.folder);
}

TEST_F(BackupTest, is_not_restored_beside_a_log_or_journal_that_is_left_over) {
  const Backup backup = make();
  for (const char* ending : {"-wal", "-shm", "-journal"}) {
    const fs::path beside = (folder / "new.db").string() + ending;
    std::ofstream(beside) << "of another database";
    const auto done = restore_backup(backup, folder / "new.db");
    ASSERT_EQ(code_of(done), StorageError::duplicate) << ending;
    EXPECT_EQ(done.error().where, beside.string());
    EXPECT_EQ(left(), std::vector<std::string>{beside.filename().string()});
    fs::remove(beside);
  }
}

TEST_F(BackupTest, that_the_log_cannot_name_is_not_left) {
  const auto other = open(folder / "a.db", quick(now));
  must(store->database().run("PRAGMA busy_timeout = 0"));
  Transaction held(other->database());
  EXPECT_EQ(code_of(make_backup(store->context(), administrator, into())), StorageError::busy);
  EXPECT_EQ(folders(), 0u);
}

TEST_F(BackupTest, with_the_stations_key_is_not_left_to_who_was_switched_off_at_another_window) {
  const Actor second = must(store->accounts.create(administrator, {.number = "b", .name = "B", .role = Role::administrator, .password = "correct horse"})).actor();
  const auto other = open(folder / "a.db", quick(now));
  must(other->accounts.set_role(administrator, second.id, Role::instructor));
  EXPECT_EQ(code_of(make_backup(store->context(), second, into())), StorageError::not_allowed);
  must(other->accounts.disable(administrator, second.id));
  EXPECT_EQ(code_of(make_backup(store->context(), second, into())), StorageError::disabled);
  EXPECT_EQ(folders(), 0u);
  EXPECT_NE(must(store->audit.list(administrator, 1)).at(0).action, "backed_up");
  must(make_backup(store->context(), std::nullopt, into()));
}

TEST_F(BackupTest, is_a_folder_and_no_file) {
  const Backup backup = make();
  EXPECT_EQ(code_of(read_backup(backup.folder / "station.db")), StorageError::not_found);
}

TEST_F(BackupTest, is_made_in_a_folder_whose_name_looks_like_a_uri) {
  const fs::path before = fs::current_path();
  fs::current_path(folder / ".");
  const auto backup = make_backup(store->context(), administrator, "file:x");
  fs::current_path(before);
  EXPECT_EQ(must(backup).sessions, 0u);
}

TEST_F(BackupTest, a_damaged_one_is_not_restored) {
  complete_session(*store, lena, version);
  const Backup backup = make();
  std::fstream file(backup.folder / "station.db", std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(backup.bytes / 2));
  file << std::string(8192, 'x');
  file.close();
  const auto restored = restore_backup(backup, folder / "new.db");
  ASSERT_FALSE(restored);
  EXPECT_EQ(restored.error().code, StorageError::corrupt);
  EXPECT_FALSE(fs::exists(folder / "new.db"));
}

}  // namespace
}  // namespace cusp::test
