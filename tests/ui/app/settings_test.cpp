// What the desktop remembers.

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <chrono>

#include "device/hid/hid_station.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/device/hid_settings.h"
#include "ui/device/space_mouse_turner.h"
#include "ui/settings/settings.h"
#include "ui/student/briefing.h"
#include "ui/student/start_page.h"
#include "ui/view/tooth_view.h"

namespace cusp::test {
namespace {

TEST(SettingsTest, are_read_back_as_they_were_set_and_nonsense_is_brought_into_range) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("Cusp.ini"));
  {
    Settings settings(file);
    EXPECT_EQ(settings.scheme(), ColourScheme::system);
    EXPECT_EQ(settings.scale_percent(), 100);
    settings.set_scheme(ColourScheme::dark);
    settings.set_language(QStringLiteral("de"));
    settings.set_scale_percent(900);
  }
  const Settings again(file);
  EXPECT_EQ(again.scheme(), ColourScheme::dark);
  EXPECT_EQ(again.language().toStdString(), "de");
  EXPECT_EQ(again.scale_percent(), 200);
}

TEST(SettingsTest, what_is_no_number_counts_as_missing) {
  const QTemporaryDir folder;
  QFile file(folder.filePath(QStringLiteral("Cusp.ini")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("[sound]\nvolume=loud\n[station]\nidle_minutes=15 min\n");
  file.close();
  const Settings settings(file.fileName());
  EXPECT_EQ(settings.volume_percent(), Settings::kUsualVolumePercent);
  EXPECT_EQ(settings.idle_minutes(), Settings::kUsualIdleMinutes) << "0 never signs out";
}

TEST(SettingsTest, what_a_student_sets_on_pedal_and_space_mouse_ends_at_the_sign_out_and_what_staff_set_stays) {
  test::DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  hid::HidStation station([] { return std::unique_ptr<hid::HidBus>(); });
  Desktop desktop(settings, Ports::of_the_system(), records.file());
  desktop.use_hid(station);
  desktop.start();
  desktop.show();
  const auto switch_both_off = [&] {
    desktop.shell()->show_page(QStringLiteral("device"));
    for (QCheckBox* box : desktop.shell()->findChildren<QCheckBox*>()) {
      if (box->text() == u"The pedal drives the handpiece" || box->text() == u"The SpaceMouse leads the view of the tooth") box->click();
    }
    EXPECT_FALSE(station.pedal().settings().on);
    EXPECT_FALSE(station.space_mouse().settings().on);
    desktop.sign_out();
  };
  desktop.sign_in(lena);
  switch_both_off();
  EXPECT_TRUE(station.pedal().settings().on);
  EXPECT_TRUE(station.space_mouse().settings().on);
  desktop.sign_in(records.administrator());
  switch_both_off();
  EXPECT_FALSE(station.pedal().settings().on);
  EXPECT_FALSE(station.space_mouse().settings().on);
  EXPECT_FALSE(HidSettings(settings.file()).pedal().on);
}

TEST(SpaceMouse, leads_the_view_of_the_ideal_preparation_too) {
  test::DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  hid::HidStation station([] { return std::unique_ptr<hid::HidBus>(); });
  Desktop desktop(settings, Ports::of_the_system(), records.file());
  desktop.use_hid(station);
  desktop.start();
  desktop.show();
  desktop.sign_in(lena);
  Exercise exercise;
  exercise.scenario = *load_builtin("channel-1");
  exercise.scenario.specimen.voxel_mm = 0.4;  // so that it grows at once
  auto* start = qobject_cast<StartPage*>(desktop.shell()->page());
  ASSERT_NE(start, nullptr);
  Q_EMIT start->briefing_wanted(exercise);
  auto* briefing = qobject_cast<Briefing*>(desktop.page());
  ASSERT_NE(briefing, nullptr);
  EXPECT_EQ(briefing->findChild<SpaceMouseTurner*>(), nullptr);
  ASSERT_NE(briefing->watch_button(), nullptr);
  briefing->watch_button()->click();
  EXPECT_NE(briefing->findChild<SpaceMouseTurner*>(), nullptr);
}

TEST(SpaceMouse, that_leads_a_view_puts_the_idle_lock_off) {
  test::DeskRecords records;
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  ASSERT_TRUE(settings.set_idle_minutes(15));
  std::chrono::milliseconds now{0};
  Ports ports = Ports::of_the_system();
  ports.since_boot = [&now] { return now; };
  hid::HidStation station([] { return std::unique_ptr<hid::HidBus>(); });
  Desktop desktop(settings, ports, records.file());
  desktop.use_hid(station);
  desktop.start();
  desktop.show();
  desktop.sign_in(records.student("1", "Lena Brandt"));
  auto* page = new QWidget;
  new ToothView(page);
  desktop.push(page);
  auto* turner = page->findChild<SpaceMouseTurner*>();
  ASSERT_NE(turner, nullptr);
  now += std::chrono::minutes(14);
  Q_EMIT turner->moved();
  now += std::chrono::minutes(14);
  QLineEdit field;
  QTest::keyClick(&field, Qt::Key_A);
  EXPECT_EQ(field.text(), QStringLiteral("a")) << "a key after 28 minutes without input reaches nobody";
}

TEST(SettingsTest, the_database_is_where_the_option_or_the_environment_says) {
  EXPECT_EQ(database_path(QStringLiteral("/tmp/x.db")), "/tmp/x.db");
  qputenv("CUSP_DB", "/tmp/y.db");
  EXPECT_EQ(database_path({}), "/tmp/y.db");
  qunsetenv("CUSP_DB");
  EXPECT_EQ(database_path({}).filename(), "cusp.db");
}

}  // namespace
}  // namespace cusp::test
