// Work on the records beside the window's store: the same people, clock and cost, on another thread.
#include "ui/session/records_task.h"

#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <thread>

#include "tests/modules.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

struct RecordsTask : ::testing::Test {
  Folder folder;
  static NewAccount anna() {
    return {.number = "anna", .name = "Anna Weber", .role = Role::administrator, .password = "correct horse", .pin = {}};
  }
};

TEST_F(RecordsTask, WhatTheTaskWritesTheWindowReads) {
  const auto window = open(folder / "cusp.db");
  std::atomic<std::thread::id> where{};
  with_own_store(*window, [&where](OwnStore own) {
    where = std::this_thread::get_id();
    ASSERT_TRUE(own.has_value());
    EXPECT_TRUE((*own)->accounts.create_first_administrator(anna()).has_value());
  });
  wait_for_dropped_tasks();
  EXPECT_NE(where.load(), std::this_thread::get_id());
  EXPECT_EQ(must(window->accounts.sign_in("anna", "correct horse")).created_utc_us, kNow) << "the clock is the window's";
}

TEST_F(RecordsTask, AWindowThatOnlyReadsGetsAStoreThatOnlyReads) {
  const Account chief = make_administrator(*open(folder / "cusp.db"));
  StoreOptions options = quick();
  options.database.access = DatabaseOptions::Access::read_only;
  const auto window = open(folder / "cusp.db", options);
  std::optional<bool> made;
  with_own_store(*window, [&](OwnStore own) {
    ASSERT_TRUE(own.has_value());
    made = (*own)->accounts.create(chief.actor(), {.number = "1", .name = "Lena", .role = Role::student, .password = {}, .pin = {}}).has_value();
  });
  wait_for_dropped_tasks();
  EXPECT_EQ(made, false);
}

TEST_F(RecordsTask, WrongTriesOfAWindowThatOnlyReadsAddUp) {
  make_administrator(*open(folder / "cusp.db"));
  StoreOptions options = quick();
  options.database.access = DatabaseOptions::Access::read_only;
  const auto window = open(folder / "cusp.db", options);
  std::optional<StorageError> last;
  for (int i = 0; i < 6; ++i) {
    with_own_store(*window, [&](OwnStore own) { last = (*own)->accounts.sign_in("admin", "a wrong guess").error().code; });
    wait_for_dropped_tasks();
  }
  EXPECT_EQ(last, StorageError::locked);
}

TEST_F(RecordsTask, TheTaskSignsWithTheKeyOfTheWindow) {
  StoreOptions options = quick();
  options.key_file = folder / "apart.key";
  const auto window = open(folder / "cusp.db", options);
  const RecordsBeside records = records_of(*window);
  const OwnStore own = open_beside(records), reading = open_beside(records.for_reading());
  ASSERT_TRUE(own && reading);
  EXPECT_EQ((*own)->context().key->id(), window->context().key->id());
  EXPECT_FALSE(std::filesystem::exists(folder / "cusp.db.key"));
  EXPECT_TRUE((*reading)->database().read_only());
  EXPECT_FALSE((*own)->database().read_only());
}

TEST_F(RecordsTask, RecordsThatAreGoneAreReportedToTheWork) {
  const auto window = open(folder / "cusp.db");
  std::filesystem::rename(folder / "cusp.db", folder / "elsewhere.db");
  std::optional<bool> opened;
  with_own_store(*window, [&opened](OwnStore own) { opened = own.has_value(); });
  wait_for_dropped_tasks();
  EXPECT_EQ(opened, false);
}

}  // namespace
}  // namespace cusp::test
