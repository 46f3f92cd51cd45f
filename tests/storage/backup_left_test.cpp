/// What a backup or a restore that was cut off leaves: it holds a secret key, and goes a day later. Records in use stay in their place.
#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "storage/backup/backup.h"
#include "storage/base/files.h"
#include "tests/refused_calls.h"
#include "tests/storage/killed.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// A folder that nobody has written to for two days.
void age(const fs::path& folder) {
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(48);
  for (const auto& file : fs::directory_iterator(folder)) fs::last_write_time(file.path(), long_ago);
  fs::last_write_time(folder, long_ago);
}

struct BackupLeftTest : ::testing::Test {
  Folder folder;
  std::shared_ptr<std::int64_t> now = std::make_shared<std::int64_t>(kNow);
  std::unique_ptr<Store> store = open(folder / "a.db", quick(now));
  Actor administrator = make_administrator(*store).actor();
  fs::path into() { return folder / "backups"; }
  Uuid station() { return store->context().station; }
  Backup make() { return must(make_backup(store->context(), administrator, into())); }
  /// Beside the database; empty if there is none.
  fs::path folder_named(const std::string& prefix) {
    for (const auto& entry : fs::directory_iterator(into().parent_path()))
      if (entry.path().filename().string().starts_with(prefix)) return entry.path();
    return {};
  }
};

TEST_F(BackupLeftTest, that_was_cut_off_goes_a_day_later_for_it_holds_a_key) {
  const Backup cut_off = make();
  const fs::path of_others = into() / "cusp-notes";
  fs::create_directories(of_others);
  std::ofstream(of_others / "read me.txt") << "kept";
  fs::remove(cut_off.folder / "backup.json");
  must(thin_backups(into(), station(), BackupKind::manual, 1, *now));
  EXPECT_TRUE(fs::exists(cut_off.folder)) << "somebody may be writing it";
  for (const fs::path& one : {cut_off.folder, of_others}) age(one);
  must(thin_backups(into(), station(), BackupKind::manual, 1, *now));
  EXPECT_FALSE(fs::exists(cut_off.folder));
  EXPECT_TRUE(fs::exists(of_others));
}

TEST_F(BackupLeftTest, that_is_removed_while_it_is_restored_is_not_restored_without_its_key) {
  const Backup backup = make();
  for (const char* gone : {"backup.json", "station.db.key", "station.db.key-counter"}) fs::remove(backup.folder / gone);
  EXPECT_EQ(code_of(restore_backup(backup, folder / "new.db")), StorageError::not_found);
  EXPECT_EQ(folder_named("new.db"), fs::path());
  EXPECT_EQ(folder_named(".cusp-restore-"), fs::path());
}

TEST_F(BackupLeftTest, with_a_pipe_in_the_place_of_a_file_is_refused_and_waits_for_nobody) {
  for (const char* part : {"backup.json", "station.db", "station.db.key", "station.db.key-counter"}) {
    const Backup backup = make();
    fs::remove(backup.folder / part);
    ASSERT_EQ(::mkfifo((backup.folder / part).c_str(), 0600), 0);
    EXPECT_FALSE(restore_backup(backup, folder / "new.db")) << part;
    EXPECT_EQ(folder_named("new.db"), fs::path()) << part;
    EXPECT_EQ(folder_named(".cusp-restore-"), fs::path()) << part;
  }
  EXPECT_EQ(must(backups_in(into(), station())).size(), 2u) << "a backup is one while its key has not been read";
}

TEST_F(BackupLeftTest, that_was_cut_off_while_it_was_described_goes_a_day_later) {
  const Backup cut_off = make();
  fs::rename(cut_off.folder / "backup.json", cut_off.folder / "backup.json.a1B2c3");
  age(cut_off.folder);
  must(thin_backups(into(), station(), BackupKind::manual, 1, *now));
  EXPECT_FALSE(fs::exists(cut_off.folder));
}

#ifdef SYS_unlink  // elsewhere the first call that removes is also the next one's
TEST_F(BackupLeftTest, that_was_removed_in_part_is_none_and_goes_a_day_later) {
  const Backup old = make();
  *now += 1'000'000;
  const Backup newest = make();
  bool refused = false;
  Stored<void> thinned;
  std::thread([&, own = station()] {
    refused = refuse_calls({{SYS_unlinkat, EPERM}});
    if (refused) thinned = thin_backups(into(), own, BackupKind::manual, 1, *now);
  }).join();
  if (!refused) GTEST_SKIP() << "the kernel admits no filter of system calls";
  ASSERT_EQ(code_of(thinned), StorageError::read_only);
  EXPECT_EQ(thinned.error().where, old.folder.string());
  EXPECT_EQ(code_of(read_backup(old.folder)), StorageError::not_found);
  EXPECT_EQ(must(backups_in(into(), station())).size(), 1u);
  age(old.folder);
  must(thin_backups(into(), station(), BackupKind::manual, 1, *now));
  EXPECT_FALSE(fs::exists(old.folder));
  EXPECT_TRUE(fs::exists(newest.folder));
}
#endif

TEST_F(BackupLeftTest, restoring_takes_away_what_a_restore_of_the_name_left_a_day_ago) {
  const Backup backup = make();
  const fs::path left_over = folder / (".cusp-restore-" + Uuid::v7().text()), running = folder / (".cusp-restore-" + Uuid::v7().text()),
                 of_another = folder / (".cusp-restore-" + Uuid::v7().text()), notes = folder / ".cusp-restore-notes";
  for (const fs::path& one : {left_over, running, of_another, notes}) {
    fs::create_directories(one);
    std::ofstream(one / (one == of_another ? "x.db" : "new.db")) << "cut off";
    if (one != running) age(one);
  }
  must(restore_backup(backup, folder / "new.db"));
  EXPECT_FALSE(fs::exists(left_over));
  EXPECT_TRUE(fs::exists(running)) << "somebody may be restoring";
  EXPECT_TRUE(fs::exists(of_another));
  EXPECT_TRUE(fs::exists(notes));
}

TEST_F(BackupLeftTest, a_backup_takes_away_what_a_restore_left_that_was_tried_again_at_once) {
  const fs::path left_over = folder / (".cusp-restore-" + Uuid::v7().text()), running = folder / (".cusp-restore-" + Uuid::v7().text());
  for (const fs::path& one : {left_over, running}) {
    fs::create_directories(one);
    std::ofstream(one / "a.db.key") << "cut off";
    if (one != running) age(one);
  }
  make();
  EXPECT_FALSE(fs::exists(left_over));
  EXPECT_TRUE(fs::exists(running)) << "somebody may be restoring";
}

TEST_F(BackupLeftTest, takes_no_place_of_records_that_a_connection_still_uses) {
  const Account lena = make_student(*store);
  const Backup backup = make();
  const fs::path file = folder / "a.db";
  EXPECT_EQ(code_of(put_aside(file, *now)), StorageError::busy);
  const auto refused = restore_in_place(backup, file, *now, {});
  ASSERT_EQ(code_of(refused), StorageError::busy);
  EXPECT_EQ(refused.error().where, file.string());
  for (const auto& entry : fs::directory_iterator(file.parent_path()))
    EXPECT_EQ(entry.path().string().find("-damaged-"), std::string::npos) << entry.path();
  const SessionId session = complete_session(*store, lena, keep(*store));
  store = open(file, quick(now));
  EXPECT_EQ(must(store->history.details(lena.actor(), session)).row.score, 81.5) << "what was written meanwhile";
  store.reset();
  EXPECT_TRUE(fs::exists(must(restore_in_place(backup, file, *now, {})) / "a.db"));
}

TEST_F(BackupLeftTest, takes_the_place_of_the_file_that_a_link_leads_to) {
  const Backup backup = make();
  const fs::path real = folder / "disk" / "b.db", link = folder / "b.db";
  fs::create_directories(real.parent_path());
  must(restore_backup(backup, real));
  fs::create_symlink("disk/b.db", link);
  const auto half = fs::file_size(real) / 2;
  fs::resize_file(real, half);
  const fs::path aside = must(restore_in_place(backup, link, *now, {}));
  EXPECT_TRUE(fs::equivalent(aside.parent_path(), real.parent_path()));
  EXPECT_EQ(fs::file_size(aside / "b.db"), half);
  EXPECT_TRUE(fs::exists(aside / "b.db.key"));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(must(verify_store(open(link, quick(now))->context())).intact());
}

/// Kills a process that calls `restore` with work on the copy, when the copy's first file takes its name by a hard link. False where the
/// kernel admits no filter.
bool is_killed_at_its_first_name(const std::function<void(const FinishRestored&)>& restore) {
  const Killed killed = kill_after(2, 0, [&](const std::function<bool()>& step) {
    restore([&](const fs::path&) -> Stored<void> {
      refuse_calls(links_refused(kKills));
      return {};
    });
    static_cast<void>(step());
  });
  return killed.by_signal && killed.steps == 0;
}

/// A restore in place that is killed once nothing stands at the database's name any more.
struct RestoreKilled : BackupLeftTest {
  const Account lena = make_student(*store);
  const SessionId session = complete_session(*store, lena, keep(*store));
  const Backup backup = make();
  const fs::path file = folder / "a.db";
  std::uintmax_t half = 0;

  /// False where the kernel admits no filter.
  bool is_killed() {
    store.reset();
    half = fs::file_size(file) / 2;
    fs::resize_file(file, half);
    return is_killed_at_its_first_name([&](const FinishRestored& finish) { static_cast<void>(restore_in_place(backup, file, *now, finish)); });
  }
  void expect_restored() {
    store = open(file, quick(now));
    EXPECT_EQ(must(store->history.details(lena.actor(), session)).row.score, 81.5);
    EXPECT_FALSE(store->context().incident);
    EXPECT_TRUE(must(verify_store(store->context())).intact());
    EXPECT_EQ(fs::file_size(folder_named("a.db-damaged-") / "a.db"), half) << "nothing is lost";
    EXPECT_TRUE(fs::exists(folder_named("a.db-damaged-") / "a.db.key"));
    EXPECT_EQ(folder_named(".cusp-restore-"), fs::path());
  }
};

TEST_F(RestoreKilled, between_the_old_database_and_the_new_is_finished_by_the_next_start) {
  if (!is_killed()) GTEST_SKIP() << "the kernel admits no filter of system calls";
  ASSERT_FALSE(fs::exists(file));
  ASSERT_TRUE(fs::exists(folder_named(".cusp-restore-") / "a.db"));
  expect_restored();
}

TEST_F(RestoreKilled, while_it_moved_the_old_key_is_finished_by_the_next_start) {
  if (!is_killed()) GTEST_SKIP() << "the kernel admits no filter of system calls";
  fs::rename(folder_named("a.db-damaged-") / "a.db.key", file.string() + ".key");
  expect_restored();
}

TEST_F(RestoreKilled, while_the_new_key_took_its_name_is_finished_by_the_next_start) {
  if (!is_killed()) GTEST_SKIP() << "the kernel admits no filter of system calls";
  const std::string copy = (folder_named(".cusp-restore-") / "a.db").string();
  fs::rename(copy + ".key-counter", file.string() + ".key-counter");
  fs::create_hard_link(copy + ".key", file.string() + ".key");
  expect_restored();
}

#ifdef SYS_unlink
TEST_F(RestoreKilled, while_it_removed_its_folder_has_restored_the_database_and_brings_nothing_back) {
  store.reset();
  half = fs::file_size(file) / 2;
  fs::resize_file(file, half);
  const Killed killed = kill_after(2, 0, [&](const std::function<bool()>& step) {
    static_cast<void>(restore_in_place(backup, file, *now, [](const fs::path&) -> Stored<void> {
      refuse_calls({{SYS_unlinkat, kKills}});
      return {};
    }));
    static_cast<void>(step());
  });
  if (!killed.by_signal || killed.steps > 0) GTEST_SKIP() << "the kernel admits no filter of system calls";
  ASSERT_NE(folder_named(".cusp-restore-"), fs::path());
  for (const char* ending : {"", ".key", ".key-counter"}) fs::rename(file.string() + ending, (folder / "elsewhere.db").string() + ending);
  EXPECT_FALSE(must(open(file, quick(now))->accounts.has_administrator())) << "a first start";
  EXPECT_EQ(fs::file_size(folder_named("a.db-damaged-") / "a.db"), half);
}
#endif

TEST_F(RestoreKilled, whose_copy_is_gone_gives_the_old_database_its_name_back) {
  if (!is_killed()) GTEST_SKIP() << "the kernel admits no filter of system calls";
  fs::remove(folder_named(".cusp-restore-") / "a.db");
  EXPECT_FALSE(Store::open(file, quick(now)));
  EXPECT_EQ(fs::file_size(file), half);
  EXPECT_TRUE(fs::exists(file.string() + ".key"));
}

/// A restore to a new name that is killed there.
struct NewNameKilled : BackupLeftTest {
  const Account lena = make_student(*store);
  const SessionId session = complete_session(*store, lena, keep(*store));
  const Backup backup = make();
  fs::path file;

  /// False where the kernel admits no filter. Then come as many of the calls that name the copy: counter, key and database each get
  /// their name by a hard link, then lose the old one.
  bool is_killed(int calls, const std::string& name = "new.db") {
    store.reset();
    file = folder / (name + std::to_string(calls));
    if (!is_killed_at_its_first_name([&](const FinishRestored& finish) { static_cast<void>(restore_backup(backup, file, finish)); })) return false;
    const std::string copy = (folder_named(".cusp-restore-") / file.filename()).string();
    for (const char* ending : {".key-counter", ".key", ""}) {
      if (calls-- > 0) fs::create_hard_link(copy + ending, file.string() + ending);
      if (calls-- > 0) fs::remove(copy + ending);
    }
    return true;
  }
  void expect_restored() {
    StoreOptions options = quick(now);
    options.database.access = DatabaseOptions::Access::existing;
    store = open(file, options);
    EXPECT_EQ(must(store->history.details(lena.actor(), session)).row.score, 81.5);
    EXPECT_FALSE(store->context().incident);
    EXPECT_EQ(must(store->accounts.sign_in("admin", "correct horse")).id, administrator.id);
    EXPECT_TRUE(must(verify_store(store->context())).intact());
  }
};

TEST_F(NewNameKilled, between_its_names_is_finished_by_the_next_start) {
  for (const int calls : {1, 2, 3, 4}) {
    SCOPED_TRACE(calls);
    if (!is_killed(calls)) GTEST_SKIP() << "the kernel admits no filter of system calls";
    ASSERT_FALSE(fs::exists(file));
    expect_restored();
    EXPECT_EQ(folder_named(".cusp-restore-"), fs::path());
  }
}

TEST_F(NewNameKilled, between_its_names_is_finished_by_the_next_restore_which_names_that) {
  for (const int calls : {1, 2, 3, 4}) {
    SCOPED_TRACE(calls);
    if (!is_killed(calls)) GTEST_SKIP() << "the kernel admits no filter of system calls";
    const auto again = restore_backup(backup, file);
    ASSERT_EQ(code_of(again), StorageError::duplicate);
    EXPECT_EQ(again.error().detail, "finished");
    EXPECT_EQ(again.error().where, file.string());
    EXPECT_EQ(folder_named(".cusp-restore-"), fs::path());
    expect_restored();
  }
}

TEST_F(NewNameKilled, between_its_names_stays_until_then_beside_records_with_a_shorter_name) {
  if (!is_killed(2, "a.db.old")) GTEST_SKIP() << "the kernel admits no filter of system calls";
  age(folder_named(".cusp-restore-"));
  store = open(folder / "a.db", quick(now));
  make();
  expect_restored();
}

TEST_F(NewNameKilled, before_its_first_name_leaves_the_name_free) {
  if (!is_killed(0)) GTEST_SKIP() << "the kernel admits no filter of system calls";
  StoreOptions options = quick(now);
  options.database.access = DatabaseOptions::Access::existing;
  EXPECT_EQ(code_of(Store::open(file, options)), StorageError::not_found);
  must(restore_backup(backup, file));
  expect_restored();
}

TEST_F(NewNameKilled, after_its_last_name_has_restored_the_database) {
  for (const int calls : {5, 6}) {
    SCOPED_TRACE(calls);
    if (!is_killed(calls)) GTEST_SKIP() << "the kernel admits no filter of system calls";
    const auto again = restore_backup(backup, file);
    EXPECT_EQ(code_of(again), StorageError::duplicate);
    EXPECT_EQ(again.error().detail, "") << "nothing was left to finish";
    expect_restored();
    make();
    const fs::path left = folder_named(".cusp-restore-");
    EXPECT_FALSE(fs::exists(left / file.filename())) << "a second name of the database";
    age(left);
    make();
    EXPECT_FALSE(fs::exists(left));
  }
}

TEST_F(NewNameKilled, before_its_first_name_claims_no_key_that_comes_later) {
  if (!is_killed(0)) GTEST_SKIP() << "the kernel admits no filter of system calls";
  std::ofstream(file.string() + ".key") << "another";
  const auto again = restore_backup(backup, file);
  EXPECT_EQ(code_of(again), StorageError::duplicate);
  EXPECT_EQ(again.error().where, file.string() + ".key");
  EXPECT_FALSE(fs::exists(file));
}

/// An old FUSE driver: neither hard links nor RENAME_NOREPLACE.
TEST(NewNames, are_free_or_whole_files_after_a_process_was_killed_that_took_them_on_a_drive_without_links) {
  const Folder folder;
  const fs::path file = folder / "new.db.key";
  std::vector<RefusedCall> calls = links_refused(EPERM);
  calls.push_back({SYS_renameat2, EINVAL});
#ifdef SYS_rename
  calls.push_back({SYS_rename, kKills});
#endif
#ifdef SYS_renameat
  calls.push_back({SYS_renameat, kKills});
#endif
  const Killed killed = kill_after(2, 0, [&](const std::function<bool()>& step) {
    refuse_calls(calls);
    static_cast<void>(write_private_file(file, "secret"));
    static_cast<void>(step());
  });
  if (!killed.by_signal || killed.steps > 0) GTEST_SKIP() << "the kernel admits no filter of system calls";
  EXPECT_FALSE(fs::exists(file)) << "an empty key refuses the next start";
  must(write_private_file(file, "secret"));
  EXPECT_EQ(must(read_private_file(file)), "secret");
}

TEST(NewFolders, are_on_the_disk_before_anything_is_written_into_them) {
  const Folder folder;
  // Of all that the function calls, nothing but a sync kills the process.
  const Killed killed = kill_after(2, 0, [&](const std::function<bool()>& step) {
    if (!refuse_calls({{SYS_fsync, kKills}})) static_cast<void>(step());
    static_cast<void>(make_private_folder(folder / "backup"));
  });
  if (killed.steps > 0) GTEST_SKIP() << "the kernel admits no filter of system calls";
  EXPECT_TRUE(killed.by_signal) << "a stick that is pulled out would lose a whole backup";
  EXPECT_TRUE(fs::is_directory(folder / "backup"));
}

TEST_F(BackupLeftTest, a_first_start_beside_records_that_a_person_put_aside_is_a_first_start) {
  store.reset();
  must(put_aside(folder / "a.db", *now));
  EXPECT_FALSE(must(open(folder / "a.db", quick(now))->accounts.has_administrator()));
}

}  // namespace
}  // namespace cusp::test
