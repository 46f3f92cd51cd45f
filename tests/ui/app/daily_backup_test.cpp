// The daily backup: where its folder takes nothing, and where the window closes meanwhile.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "storage/backup/backup.h"
#include "storage/base/locked_folder.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/app/desktop.h"
#include "ui/drill/drill_screen.h"
#include "ui/session/background_task.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/busy.h"

namespace cusp::test {
namespace {

enum class Again : std::uint8_t { after_an_hour, once_the_clock_is_set_back };

/// A backup to a folder in whose place a file lies, which then goes.
void fail_and_try(Again again) {
  test::DeskRecords records;
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  QFile in_the_way(folder.filePath(QStringLiteral("backups")));
  ASSERT_TRUE(in_the_way.open(QIODevice::WriteOnly));
  in_the_way.close();
  settings.set_backup_folder(in_the_way.fileName());
  QDateTime now(QDate(2026, 11, 20), QTime(10, 0));
  Ports ports = Ports::of_the_system();
  ports.now = [&now] { return now; };
  Desktop desktop(settings, ports, records.file());
  desktop.start();
  desktop.show();
  ASSERT_TRUE(desktop.keep_daily_backup());
  const auto shows_failure = [&desktop, &records] {
    desktop.sign_in(records.administrator());
    const auto labels = desktop.findChildren<QLabel*>();
    return std::ranges::any_of(labels, [](const QLabel* label) { return label->text().contains(QStringLiteral("The daily backup failed.")); });
  };
  ASSERT_TRUE(QTest::qWaitFor(shows_failure, 60'000));
  ASSERT_TRUE(in_the_way.remove());
  now = now.addSecs(59 * 60);
  EXPECT_FALSE(desktop.keep_daily_backup());
  if (again == Again::after_an_hour) now = now.addSecs(2 * 60);
  if (again == Again::once_the_clock_is_set_back) now = now.addYears(-1);
  EXPECT_TRUE(desktop.keep_daily_backup());
  EXPECT_TRUE(QTest::qWaitFor([&in_the_way] { return !QDir(in_the_way.fileName()).isEmpty(); }, 60'000));
}

TEST(DailyBackup, that_failed_is_shown_to_the_administrator_and_tried_again_after_an_hour) { fail_and_try(Again::after_an_hour); }

TEST(DailyBackup, that_failed_under_a_clock_that_was_ahead_is_tried_again_once_that_is_set_back) {
  fail_and_try(Again::once_the_clock_is_set_back);
}

TEST(DailyBackup, that_failed_is_shown_at_once_to_an_administrator_who_is_signed_in) {
  test::DeskRecords records;
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  QFile in_the_way(folder.filePath(QStringLiteral("backups")));
  ASSERT_TRUE(in_the_way.open(QIODevice::WriteOnly));
  settings.set_backup_folder(in_the_way.fileName());
  Desktop desktop(settings, Ports::of_the_system(), records.file());
  desktop.start();
  desktop.show();
  desktop.sign_in(records.administrator());
  ASSERT_TRUE(desktop.keep_daily_backup());
  const auto shows_failure = [&desktop] {
    const auto labels = desktop.findChildren<QLabel*>();
    return std::ranges::any_of(labels, [](const QLabel* label) { return label->text().contains(QStringLiteral("The daily backup failed.")); });
  };
  EXPECT_TRUE(QTest::qWaitFor(shows_failure, 60'000));
}

struct DailyBackupFolder : testing::Test {
  DailyBackupFolder() {
    settings.set_backup_folder(folder.filePath(QStringLiteral("backups")));
    desktop.emplace(settings, Ports::of_the_system(), records.file());
    desktop->start();
    desktop->show();
  }
  ~DailyBackupFolder() override {
    desktop.reset();
    wait_for_dropped_tasks();  // before the records go
  }

  test::DeskRecords records;
  const QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  std::optional<Desktop> desktop;
};

TEST_F(DailyBackupFolder, is_read_in_the_background_and_holds_up_no_window_that_closes) {
  ASSERT_TRUE(desktop->keep_daily_backup());
  ASSERT_TRUE(QTest::qWaitFor([this] { return desktop->keep_daily_backup(); }, 60'000)) << "whether one is due is not known at once";
  EXPECT_TRUE(desktop->close());
  desktop.reset();
  wait_for_dropped_tasks();
  EXPECT_EQ(backups_in(settings.backup_folder(records.file()), std::nullopt)->size(), 1u);
}

TEST_F(DailyBackupFolder, is_the_one_that_another_window_has_chosen_since) {
  const QString elsewhere = folder.filePath(QStringLiteral("elsewhere"));
  QFile file(settings.file());
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("[records]\nbackup_folder=" + elsewhere.toUtf8() + '\n');
  file.close();
  ASSERT_TRUE(desktop->keep_daily_backup());
  EXPECT_TRUE(QTest::qWaitFor([&elsewhere] { return !QDir(elsewhere).isEmpty(); }, 60'000));
}

TEST_F(DailyBackupFolder, is_left_alone_while_somebody_drills_and_beside_no_other_picture) {
  desktop->push(new DrillScreen(Ports::of_the_system()));
  EXPECT_FALSE(desktop->keep_daily_backup());
  desktop->back();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  auto* report = new QWidget;  // that somebody leaves open overnight
  new ToothView(report);
  desktop->push(report);
  EXPECT_TRUE(desktop->keep_daily_backup());
}

/// A desktop whose daily backup is being made, and waits for the folder. Its outcome reaches the window in a later turn of the event loop.
struct ClosingOverDailyBackup : DailyBackupFolder {
  ClosingOverDailyBackup() {
    const auto into = settings.backup_folder(records.file());
    std::filesystem::create_directory(into);
    held.emplace(into, FolderLock::alone);
    EXPECT_TRUE(desktop->keep_daily_backup());
    EXPECT_TRUE(QTest::qWaitFor([this] { return desktop->makes_daily_backup(); }, 60'000));
  }
  ~ClosingOverDailyBackup() override { held.reset(); }

  std::optional<LockedFolder> held;
  QPushButton* leave_out() const {
    for (QPushButton* one : desktop->page()->findChildren<QPushButton*>())
      if (one->accessibleName() == QStringLiteral("Close without the backup")) return one;
    return nullptr;
  }
};

TEST_F(ClosingOverDailyBackup, waits_until_it_is_made_and_shows_that) {
  EXPECT_FALSE(desktop->close());
  EXPECT_TRUE(desktop->isVisible());
  const auto* busy = desktop->page()->findChild<Busy*>();
  ASSERT_NE(busy, nullptr);
  EXPECT_TRUE(busy->running());
  EXPECT_FALSE(desktop->close()) << "once more";
  EXPECT_EQ(desktop->page()->findChild<Busy*>(), busy) << "the page stays";
  held.reset();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !desktop->isVisible(); }, 60'000));
  EXPECT_FALSE(QDir(folder.filePath(QStringLiteral("backups"))).isEmpty());
}

TEST_F(ClosingOverDailyBackup, ends_at_once_without_it_if_somebody_wants_that) {
  EXPECT_FALSE(desktop->close());
  ASSERT_NE(leave_out(), nullptr);
  leave_out()->click();
  EXPECT_FALSE(desktop->isVisible());
}

TEST_F(ClosingOverDailyBackup, shows_how_far_it_is_above_the_button_and_keeps_the_place_for_it) {
  EXPECT_FALSE(desktop->close());
  QWidget* page = desktop->page();
  auto* busy = page->findChild<Busy*>();
  ASSERT_NE(busy, nullptr);
  ASSERT_NE(leave_out(), nullptr);
  busy->show();
  page->resize(800, 600);
  page->layout()->activate();
  const int bar_ends = busy->mapTo(page, QPoint(0, busy->height())).y(), button_begins = leave_out()->mapTo(page, QPoint()).y();
  EXPECT_LE(bar_ends, button_begins);
  EXPECT_TRUE(busy->sizePolicy().retainSizeWhenHidden()) << "the button would move under whoever presses it";
}

}  // namespace
}  // namespace cusp::test
