// The daily backup in the background: when one is made, and that of several windows one makes it.
#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <array>
#include <filesystem>
#include <future>

#include "storage/backup/backup.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/admin/backup_work.h"
#include "ui/text/failure_text.h"

namespace cusp::test {
namespace {

struct DailyBackupWork : testing::Test {
  BackgroundTask begin(std::promise<Stored<BackedUp>>& promise, std::shared_ptr<WorkProgress> progress = {}) {
    return back_up(records_of(records.store()), into, std::nullopt, [&promise](Stored<BackedUp> made) { promise.set_value(std::move(made)); }, std::move(progress));
  }
  Stored<BackedUp> daily(std::shared_ptr<WorkProgress> progress = {}) {
    std::promise<Stored<BackedUp>> promise;
    auto made = promise.get_future();
    const BackgroundTask task = begin(promise, std::move(progress));
    return made.get();
  }
  std::size_t folders() const { return backups_in(into, std::nullopt)->size(); }

  DeskRecords records;
  const QTemporaryDir folder;
  const std::filesystem::path into = folder.filePath(QStringLiteral("daily")).toStdString();
};

TEST_F(DailyBackupWork, makes_one_a_day_after_the_last) {
  const auto first = daily();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->by, BackedUp::By::this_call);
  records.now_us += kBackupEveryUs - 1;
  const auto same = daily();
  ASSERT_TRUE(same);
  EXPECT_EQ(same->by, BackedUp::By::earlier);
  EXPECT_EQ(same->backup.folder, first->backup.folder);
  records.now_us += 1;
  const auto next = daily();
  ASSERT_TRUE(next);
  EXPECT_EQ(next->by, BackedUp::By::this_call);
  EXPECT_EQ(folders(), 2u);
}

TEST_F(DailyBackupWork, makes_one_also_where_an_administrator_made_one_today) {
  ASSERT_TRUE(make_backup(records.store().context(), records.administrator().actor(), into));
  const auto made = daily();
  ASSERT_TRUE(made);
  EXPECT_EQ(made->by, BackedUp::By::this_call);
}

TEST_F(DailyBackupWork, of_several_windows_that_start_at_once_makes_the_very_first_one_once) {
  std::array<std::promise<Stored<BackedUp>>, 6> promises;
  std::array<BackgroundTask, 6> tasks;
  for (std::size_t i = 0; i < tasks.size(); ++i) tasks[i] = begin(promises[i]);
  for (auto& promise : promises) {
    const auto made = promise.get_future().get();
    EXPECT_TRUE(made) << made.error().where << ": " << made.error().detail;
  }
  EXPECT_EQ(folders(), 1u);
}

TEST_F(DailyBackupWork, leaves_no_folder_behind_where_it_was_stopped) {
  const auto progress = std::make_shared<WorkProgress>();
  progress->stop = true;
  const auto stopped = daily(progress);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, StorageError::stopped);
  EXPECT_FALSE(std::filesystem::exists(into));
}

TEST_F(DailyBackupWork, of_today_is_found_without_counting_a_page) {
  ASSERT_TRUE(daily());
  const auto progress = std::make_shared<WorkProgress>();
  ASSERT_TRUE(daily(progress));
  EXPECT_EQ(progress->all, 0u) << "the window that closes would wait for it";
}

TEST_F(DailyBackupWork, that_its_folder_does_not_take_is_refused_by_the_name_of_that_and_not_of_the_records) {
  const QString blocks = folder.filePath(QStringLiteral("a file"));
  ASSERT_TRUE(QFile(blocks).open(QIODevice::WriteOnly));
  const std::filesystem::path blocked = (blocks + QStringLiteral("/backups")).toStdString();
  const auto made = make_backup(records.store().context(), std::nullopt, blocked);
  ASSERT_FALSE(made);
  const Message message = describe_backup_failure(made.error(), blocked);
  EXPECT_EQ(message.what.toStdString(), "The folder for backups cannot be written.");
  EXPECT_TRUE(message.more.contains(blocks)) << message.more.toStdString();
  for (const std::filesystem::path& where : {blocked, blocked / "cusp-2026-11-20T09-14-03Z" / "station.db"})
    EXPECT_EQ(describe_backup_failure({StorageError::disk_full, where.string()}, blocked).what.toStdString(), "The drive for backups is full.");
  const StorageFailure of_records{StorageError::read_only, records.file().string(), {}};
  EXPECT_EQ(describe_backup_failure(of_records, records.file().parent_path()).line(), describe(of_records).line());
}

}  // namespace
}  // namespace cusp::test
