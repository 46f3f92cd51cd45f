// The station's page: backups and verification in the background, and when a daily backup is due.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QPushButton>
#include <QTest>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/admin/station_page.h"

namespace cusp::test {
namespace {

constexpr int kPatienceMs = 60'000;

class Station : public testing::Test {
 protected:
  Station() {
    admin = records.administrator();
    records.attempt(records.student("4711", "Lena Brandt"), "channel-1", 81, 60);
    ports.pick_file = [this](QWidget*, const FileWish& wish, std::function<void(const QString&)> then) {
      asked_for_folder = wish.what == FileWish::What::folder;
      then(chosen);
    };
  }
  std::unique_ptr<StationPage> page() {
    return std::make_unique<StationPage>(records.store(), admin.actor(), settings, ports);
  }
  static bool waited(const StationPage& page) {
    return QTest::qWaitFor([&] { return !page.working(); }, kPatienceMs);
  }

  DeskRecords records;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  Account admin;
  Ports ports;
  QString chosen = folder.filePath(QStringLiteral("stick"));
  bool asked_for_folder = false;
};

TEST_F(Station, MakesABackupWhereItWasAskedTo) {
  const auto shown = page();
  shown->choose_folder();
  EXPECT_TRUE(asked_for_folder);
  shown->back_up();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("made and checked"))) << shown->message().toStdString();
  const auto all = backups_in(chosen.toStdString(), records.store().context().station);
  ASSERT_TRUE(all);
  ASSERT_EQ(all->size(), 1u);
  EXPECT_EQ(all->front().sessions, 1u);
}

TEST_F(Station, SaysWhyNoBackupWasMade) {
  chosen = folder.filePath(QStringLiteral("a file/backups"));
  QFile file(folder.filePath(QStringLiteral("a file")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  const auto shown = page();
  shown->choose_folder();
  shown->back_up();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("No backup was made"))) << shown->message().toStdString();
}

TEST_F(Station, VerifiesAndNamesWhatWasChanged) {
  const auto shown = page();
  shown->verify();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("whole"))) << shown->message().toStdString();
  ASSERT_TRUE(records.store().database().run("UPDATE grades SET score = 100"));
  shown->verify();
  ASSERT_TRUE(waited(*shown));
  EXPECT_TRUE(shown->message().contains(QStringLiteral("grades"))) << shown->message().toStdString();
}

TEST_F(Station, ABackupIsDueADayAfterTheLast) {
  const std::filesystem::path into = folder.filePath(QStringLiteral("daily")).toStdString();
  const Uuid station = records.store().context().station;
  EXPECT_TRUE(backup_is_due(into, station, kMorning));
  const auto made = make_backup(records.store().context(), std::nullopt, into);
  ASSERT_TRUE(made);
  EXPECT_FALSE(backup_is_due(into, station, made->made_utc_us + kBackupEveryUs - 1));
  EXPECT_TRUE(backup_is_due(into, station, made->made_utc_us + kBackupEveryUs));
}

}  // namespace
}  // namespace cusp::test
