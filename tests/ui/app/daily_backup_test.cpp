// The daily backup, where its folder takes nothing.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/app/desktop.h"

namespace cusp::test {
namespace {

TEST(DailyBackup, that_failed_is_shown_to_the_administrator_and_tried_again_after_an_hour) {
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
  now = now.addSecs(2 * 60);
  EXPECT_TRUE(desktop.keep_daily_backup());
  EXPECT_TRUE(QTest::qWaitFor([&in_the_way] { return !QDir(in_the_way.fileName()).isEmpty(); }, 60'000));
}

}  // namespace
}  // namespace cusp::test
