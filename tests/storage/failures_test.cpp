/// A disk that fills up or fails at every single write of a transaction: nothing half-written, and a code for the cause.
#include <gtest/gtest.h>

#include <cerrno>
#include <utility>

#include "storage/backup/backup.h"
#include "storage/base/files.h"
#include "tests/file_limit.h"
#include "tests/storage/failing_vfs.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

void copy_database(const fs::path& from, const fs::path& to) {
  for (const char* part : {"", "-wal", "-shm", ".key"}) {
    fs::remove(to.string() + part);
    if (fs::exists(from.string() + part)) fs::copy_file(from.string() + part, to.string() + part);
  }
}

class FailuresTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto store = open(folder / "start.db");
    const Account student = make_student(*store);
    session = must(store->sessions.start(student.actor(), new_session(student, keep(*store)))).id;
    must(store->traces.append(session, second_from(1)));
  }
  void TearDown() override { fail_from(Failing::nothing, 0); }

  /// A second that needs several pages.
  static RecordedSecond large_second() {
    RecordedSecond second = second_from(13);
    std::uint32_t noise = 1;
    for (int i = 0; i < 5000; ++i) {
      StepInput input = second.inputs.back();
      for (std::int32_t* at : {&input.x, &input.y, &input.z}) {
        *at = static_cast<std::int32_t>(noise = noise * 1664525u + 1013904223u) / 4;
      }
      second.inputs.push_back(input);
    }
    return second;
  }

  /// Appends while the n-th operation fails; what the file then holds is one second or two, whole, and nothing else.
  /// The code, or nullopt when it went through.
  std::optional<StorageError> append_failing_at(Failing how, int n) {
    const fs::path file = folder / "try.db";
    copy_database(folder / "start.db", file);
    std::optional<StorageError> code;
    {
      StoreOptions options = quick();
      options.database.vfs = failing_vfs();
      fail_from(Failing::nothing, 0);
      const auto store = open(file, options);
      fail_from(how, n);
      if (const auto done = store->traces.append(session, large_second()); !done) code = done.error().code;
      operations = operations_seen();
      fail_from(Failing::nothing, 0);
    }
    const auto store = open(file);
    EXPECT_EQ(must(store->database().integrity_check()), "") << n;
    EXPECT_TRUE(must(verify_session(store->context(), session)).intact()) << n;
    const auto chunks = must(store->traces.chunks(session)).size();
    EXPECT_EQ(must(store->metrics.over_time(session)).size(), chunks) << n;
    if (!code) {
      EXPECT_EQ(chunks, 2u) << n;
    } else if (how == Failing::disk_full) {
      EXPECT_EQ(chunks, 1u) << n;
    }
    // The session continues from there once the disk has space again.
    if (chunks == 1) must(store->traces.append(session, large_second()));
    EXPECT_TRUE(must(verify_session(store->context(), session)).intact()) << n;
    return code;
  }

  Folder folder;
  SessionId session;
  int operations = 0;
};

TEST_F(FailuresTest, a_disk_that_is_full_at_any_write_leaves_the_second_before_whole) {
  ASSERT_FALSE(append_failing_at(Failing::nothing, 0));
  const int all = operations;
  ASSERT_GT(all, 8);
  int refused = 0;
  for (int n = 1; n <= all; ++n) {
    const auto code = append_failing_at(Failing::disk_full, n);
    if (code) {
      EXPECT_EQ(*code, StorageError::disk_full) << n;
      ++refused;
    }
  }
  EXPECT_GT(refused, 8);
}

TEST_F(FailuresTest, a_disk_that_fails_at_any_write_or_sync_leaves_no_half) {
  ASSERT_FALSE(append_failing_at(Failing::nothing, 0));
  const int all = operations;
  for (const Failing how : {Failing::io_error, Failing::once}) {
    int refused = 0;
    for (int n = 1; n <= all; ++n) {
      const auto code = append_failing_at(how, n);
      if (code) {
        EXPECT_EQ(*code, StorageError::io) << n;
        ++refused;
      }
    }
    EXPECT_GT(refused, 8);
  }
}

TEST_F(FailuresTest, a_refused_write_names_its_cause) {
  ASSERT_FALSE(append_failing_at(Failing::nothing, 0));
  const int all = operations;
  const std::pair<Failing, StorageError> causes[] = {{Failing::over_quota, StorageError::quota_exceeded},
                                                     {Failing::too_large, StorageError::file_too_large},
                                                     {Failing::io_error, StorageError::io}};
  for (const auto& [how, cause] : causes) {
    int refused = 0;
    for (int n = 1; n <= all; ++n) {
      const auto code = append_failing_at(how, n);
      if (!code) continue;
      EXPECT_EQ(*code, cause) << n;
      ++refused;
    }
    EXPECT_GT(refused, 8);
  }
}

TEST_F(FailuresTest, a_limit_on_the_size_of_files_is_no_full_disk) {
  const fs::path file = folder / "start.db";
  const auto store = open(file);
  const auto done = with_files_up_to(fs::file_size(file.string() + "-wal") + 16384,
                                     [&] { return store->traces.append(session, large_second()); });
  EXPECT_EQ(code_of(done), StorageError::file_too_large);
  must(store->traces.append(session, large_second()));
}

TEST_F(FailuresTest, a_backup_that_cannot_be_written_names_its_own_file_and_leaves_nothing) {
  const std::pair<Failing, StorageError> causes[] = {{Failing::disk_full, StorageError::disk_full},
                                                     {Failing::over_quota, StorageError::quota_exceeded},
                                                     {Failing::too_large, StorageError::file_too_large},
                                                     {Failing::io_error, StorageError::io}};
  StoreOptions options = quick();
  options.database.vfs = failing_vfs();
  fail_from(Failing::nothing, 0);
  const auto store = open(folder / "start.db", options);
  const fs::path into = folder / "backups";
  for (const auto& [how, cause] : causes) {
    fail_from(how, 1);  // the database itself is only read
    const auto done = make_backup(store->context(), std::nullopt, into);
    fail_from(Failing::nothing, 0);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, cause);
    EXPECT_TRUE(done.error().where.starts_with(into.string())) << done.error().where;
    EXPECT_FALSE(fs::exists(into));
  }
  must(make_backup(store->context(), std::nullopt, into));
}

TEST_F(FailuresTest, a_restore_that_cannot_be_written_names_the_new_file_and_leaves_nothing) {
  const Backup backup = must(make_backup(open(folder / "start.db")->context(), std::nullopt, folder / "backups"));
  ASSERT_GT(backup.bytes, 65536u);
  const auto done = with_files_up_to(65536, [&] { return restore_backup(backup, folder / "new.db"); });
  ASSERT_EQ(code_of(done), StorageError::file_too_large);
  EXPECT_EQ(done.error().where, (folder / "new.db").string());
  EXPECT_FALSE(fs::exists(folder / "new.db"));
  must(restore_backup(backup, folder / "new.db"));
}

TEST(FailureCodes, an_errno_names_the_cause_and_not_always_a_full_disk) {
  EXPECT_EQ(error_from_errno(ENOSPC), StorageError::disk_full);
  EXPECT_EQ(error_from_errno(EDQUOT), StorageError::quota_exceeded);
  EXPECT_EQ(error_from_errno(EFBIG), StorageError::file_too_large);
  EXPECT_EQ(error_from_errno(ENOMEM), StorageError::out_of_memory);
  EXPECT_EQ(error_from_errno(EROFS), StorageError::read_only);
  EXPECT_EQ(error_from_errno(EACCES), StorageError::read_only);
  EXPECT_EQ(error_from_errno(ENOENT), StorageError::not_found);
  EXPECT_EQ(error_from_errno(EEXIST), StorageError::duplicate);
  EXPECT_EQ(error_from_errno(EIO), StorageError::io);
  EXPECT_TRUE(out_of_space(StorageError::quota_exceeded));
  EXPECT_FALSE(out_of_space(StorageError::file_too_large));
}

TEST(FailureCodes, a_status_of_sqlite_names_the_cause) {
  constexpr int kNoMemory = 7, kFull = 13, kProtocol = 15, kIoNoMemory = 3082;  // sqlite.org/rescode.html
  EXPECT_EQ(failure_of(nullptr, kFull).code, StorageError::disk_full);
  EXPECT_EQ(failure_of(nullptr, kNoMemory).code, StorageError::out_of_memory);
  EXPECT_EQ(failure_of(nullptr, kIoNoMemory).code, StorageError::out_of_memory);
  EXPECT_EQ(failure_of(nullptr, kProtocol).code, StorageError::busy);
}

TEST(FailureCodes, a_missing_table_is_a_bad_statement_and_no_failed_disk) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  EXPECT_EQ(code_of(store->database().run("SELECT * FROM nothing_of_this_name")), StorageError::bad_statement);
}

TEST(FailureCodes, a_file_that_a_folder_blocks_is_no_full_disk) {
  const Folder folder;
  std::filesystem::create_directory(folder / "taken");
  EXPECT_EQ(code_of(write_private_file(folder / "missing" / "key", "secret")), StorageError::not_found);
  EXPECT_EQ(code_of(write_private_file(folder / "taken", "secret")), StorageError::duplicate);
}

TEST_F(FailuresTest, a_new_file_on_a_failing_disk_is_whole_or_not_there_and_can_be_made_again) {
  const auto attempt = [&](Failing how, int n) {
    const fs::path file = folder / "new.db";
    for (const char* part : {"", "-wal", "-shm", "-journal", ".key"}) fs::remove(file.string() + part);
    StoreOptions options = quick();
    options.database.vfs = failing_vfs();
    fail_from(how, n);
    const bool made = Store::open(file, options).has_value();
    operations = operations_seen();
    fail_from(Failing::nothing, 0);
    const auto store = open(file);
    EXPECT_EQ(must(store->database().integrity_check()), "") << n;
    EXPECT_TRUE(must(verify_audit_log(store->context())).intact()) << n;
    EXPECT_EQ(must(store->database().first("PRAGMA page_size", [](Row row) { return row.integer(0); })), 8192) << n;
    return made;
  };
  ASSERT_TRUE(attempt(Failing::nothing, 0));
  const int all = operations;
  for (const Failing how : {Failing::disk_full, Failing::io_error}) {
    EXPECT_FALSE(attempt(how, 1));
    for (int n = 2; n <= all; n += 7) attempt(how, n);
  }
}

TEST_F(FailuresTest, after_sqlite_has_rolled_back_nothing_more_is_written) {
  // As after a read that failed and that the caller took for "none".
  const auto store = open(folder / "start.db", quick());
  const auto names = [&] { return must(store->database().all("SELECT name FROM people ORDER BY id", [](Row row) { return row.text(0); })); };
  const auto before = names();
  ASSERT_FALSE(before.empty());
  Transaction transaction(store->database());
  transaction.run("UPDATE people SET name = 'first'");
  must(store->database().run("ROLLBACK"));
  transaction.run("UPDATE people SET name = 'alone'");
  const Stored<void> done = transaction.commit();
  EXPECT_EQ(code_of(done), StorageError::io);
  EXPECT_EQ(names(), before);
}

TEST_F(FailuresTest, a_file_that_another_holds_is_busy_and_nothing_is_lost) {
  StoreOptions options = quick();
  options.database.busy_timeout_ms = 1;
  const auto one = open(folder / "start.db", options);
  const auto two = open(folder / "start.db", options);
  {
    Transaction holds(one->database());
    EXPECT_EQ(code_of(two->traces.append(session, second_from(13))), StorageError::busy);
  }
  must(two->traces.append(session, second_from(13)));
}

}  // namespace
}  // namespace cusp::test
