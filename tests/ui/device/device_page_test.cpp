// The device page without a window system: what it lists, what it keeps, and the emulated Falcon on its bench.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/device/falcon/images.h"
#include "ui/app/device_settings.h"
#include "ui/device/device_page.h"
#include "ui/device/falcon_panel.h"
#include "ui/device/falcon_words.h"
#include "ui/device/self_test_report.h"

namespace cusp {
namespace {

/// A bus that says what it is told.
struct Bus {
  std::vector<FoundDevice> hardware;
  bool news = true;
};
class ToldWatch final : public DeviceWatch {
 public:
  explicit ToldWatch(Bus& bus) : bus_(bus) {}
  std::vector<FoundDevice> list() override { return with_those_of_no_hardware(bus_.hardware); }
  bool changed() noexcept override { return std::exchange(bus_.news, false); }

 private:
  Bus& bus_;
};

struct Desk {
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  Bus bus;
  Ports ports;
  QString picked;
  QStringList asked;

  Desk() {
    ports.now = [] { return QDateTime(QDate(2026, 11, 20), QTime(10, 0), Qt::UTC); };
    ports.ask = [this](QWidget*, const Question& question, const std::function<void(bool)>& then) {
      asked << question.what;
      then(true);
    };
    ports.pick_file = [this](QWidget*, const FileWish&, const std::function<void(const QString&)>& then) { then(picked); };
  }
  std::unique_ptr<DevicePage> page(bool staff) {
    return std::make_unique<DevicePage>(settings, ports, staff, nullptr, [this] { return std::make_unique<ToldWatch>(bus); });
  }
  DeviceChoice choice() { return DeviceSettings(settings.file()).choice(); }
};

QPushButton* button(QWidget& in, const QString& text) {
  for (QPushButton* b : in.findChildren<QPushButton*>())
    if (b->text().trimmed() == text) return b;
  return nullptr;
}
bool says(QWidget& in, const QString& part) {
  for (const QLabel* label : in.findChildren<QLabel*>())
    if (label->isVisibleTo(&in) && label->text().contains(part)) return true;
  return false;
}

TEST(DevicePage, lists_what_is_plugged_in_and_keeps_what_was_chosen) {
  Desk desk;
  desk.bus.hardware = {{.kind = "falcon", .name = "FT000001", .port = "1-1"}, {.kind = "falcon", .name = "FT000002", .port = "1-2"}};
  auto page = desk.page(true);
  ASSERT_EQ(page->listed().size(), 4);
  EXPECT_TRUE(page->listed()[0].contains(QStringLiteral("FT000001")));
  EXPECT_TRUE(page->listed()[1].contains(QStringLiteral("FT000002")));
  EXPECT_EQ(desk.choice().kind, "pointer");
  page->findChildren<QRadioButton*>()[1]->click();
  EXPECT_EQ(desk.choice().kind, "falcon");
  EXPECT_EQ(desk.choice().name, "FT000002");
}

TEST(DevicePage, one_that_comes_or_goes_is_listed_without_a_click) {
  Desk desk;
  auto page = desk.page(true);
  EXPECT_TRUE(says(*page, QStringLiteral("No Falcon is plugged in")));
  desk.bus.hardware = {{.kind = "falcon", .name = "FT000001", .port = "1-1"}};
  desk.bus.news = true;
  page->look();
  EXPECT_EQ(page->listed().size(), 3);
  EXPECT_FALSE(says(*page, QStringLiteral("No Falcon is plugged in")));
  desk.bus.hardware.clear();
  desk.bus.news = true;
  page->look();
  EXPECT_EQ(page->listed().size(), 2);
}

TEST(DevicePage, a_falcon_that_may_not_be_opened_comes_with_the_line_that_mends_it) {
  Desk desk;
  desk.bus.hardware = {{.kind = "falcon", .name = "1-1", .port = "1-1", .denied = true}};
  auto page = desk.page(true);
  bool there = false;
  for (const QLineEdit* line : page->findChildren<QLineEdit*>()) there = there || line->text().contains(QStringLiteral("udevadm"));
  EXPECT_TRUE(there);
}

TEST(DevicePage, a_student_looks_and_feels_and_changes_nothing) {
  Desk desk;
  desk.bus.hardware = {{.kind = "falcon", .name = "FT000001", .port = "1-1"}};
  auto page = desk.page(false);
  for (const QRadioButton* pick : page->findChildren<QRadioButton*>()) EXPECT_EQ(pick->isEnabled(), pick->isChecked());
  EXPECT_TRUE(button(*page, QStringLiteral("Self-test"))->isHidden());
  EXPECT_TRUE(button(*page, QStringLiteral("Weigh the grip"))->isHidden());
  EXPECT_FALSE(button(*page, QStringLiteral("Feel the force"))->isHidden());
  EXPECT_FALSE(button(*page, QStringLiteral("Name the file…"))->isVisibleTo(page.get()));
}

TEST(DevicePage, a_firmware_file_is_checked_before_it_is_kept) {
  Desk desk;
  auto page = desk.page(true);
  desk.picked = desk.folder.filePath(QStringLiteral("no.bin"));
  std::ofstream(desk.picked.toStdString()) << "not a firmware";
  button(*page, QStringLiteral("Name the file…"))->click();
  EXPECT_TRUE(desk.choice().firmware.file.empty());
  const auto bytes = testing::boot_image();
  desk.picked = desk.folder.filePath(QStringLiteral("yes.bin"));
  std::ofstream(desk.picked.toStdString(), std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  button(*page, QStringLiteral("Name the file…"))->click();
  const FirmwareChoice kept = desk.choice().firmware;
  EXPECT_EQ(kept.file, desk.picked.toStdString());
  EXPECT_EQ(kept.sha256.size(), 64u);
  EXPECT_TRUE(read_firmware(kept));
  // Another file under the same name is not used.
  std::ofstream(desk.picked.toStdString(), std::ios::app | std::ios::binary) << "xx";
  EXPECT_FALSE(read_firmware(kept));
}

TEST(DevicePage, the_emulated_falcon_homes_answers_and_pushes) {
  Desk desk;
  DeviceSettings(desk.settings.file()).choose("emulated-falcon", {});
  auto page = desk.page(true);
  page->show();
  FalconPanel* panel = page->falcon();
  QPushButton* force = button(*panel, QStringLiteral("Feel the force"));
  for (int i = 0; i < 20000 && !force->isEnabled(); ++i) {
    QTest::qWait(1);
    panel->look();
  }
  ASSERT_TRUE(force->isEnabled()) << panel->summary().toStdString();
  force->click();
  EXPECT_EQ(desk.asked.size(), 1);
  // Nobody holds it: the force goes off by itself, and it is said.
  for (int i = 0; i < 20000 && !says(*panel, QStringLiteral("Nothing was changed")); ++i) {
    QTest::qWait(1);
    panel->look();
  }
  EXPECT_TRUE(says(*panel, QStringLiteral("Nothing was changed")));
  page->hide();  // lets go of it
}

TEST(SelfTestReport, says_what_was_measured_and_what_it_means_for_exercises) {
  falcon::SelfTestResult found;
  falcon::MotionFit fit;
  fit.mass_kg = 0.2;
  fit.damping_ns_per_m = 2.0;
  fit.delay_ms = 1.5;
  found.axes = {fit, fit, fit};
  found.least_counts = {1, 1, 1};
  FalconProfile before, after;
  after.damping_ns_per_m = found.damping_ns_per_m();
  after.delay_ms = found.delay_ms();
  const auto json = nlohmann::json::parse(
      self_test_report({"falcon", "FT1", "room-2", "ab", QDateTime(QDate(2026, 11, 20), QTime(10, 0), Qt::UTC)}, found, after, {}).toStdString());
  EXPECT_EQ(json["device"]["name"], "FT1");
  EXPECT_DOUBLE_EQ(json["axes"]["y_up"]["damping_ns_per_m"], 2.0);
  EXPECT_DOUBLE_EQ(json["taken_over"]["delay_ms"], 1.5);
  // More damping than is assumed allows more, even with more delay: at scale 1/2 half of (4 + 2) / 2.0 ms is 1.5 N/mm,
  // half of (0.5 + 2) / 1.5 ms is 0.83.
  EXPECT_NEAR(allowed_stiffness(before).n_per_mm, 0.5 * 2.5 / 1.5, 1e-9);
  EXPECT_TRUE(allowed_stiffness(before).assumed);
  EXPECT_NEAR(allowed_stiffness(after).n_per_mm, 0.5 * (2.0 / 0.5 + 2.0) / 2.0, 1e-9);
  EXPECT_FALSE(allowed_stiffness(after).assumed);
  EXPECT_NEAR(json["scenes_may_use_n_per_mm"], 1.5, 1e-9);
}

TEST(FalconWords, every_phase_and_every_end_has_its_sentence) {
  for (int phase = 0; phase <= static_cast<int>(falcon::Phase::failed); ++phase) {
    falcon::SessionState state;
    state.phase = static_cast<falcon::Phase>(phase);
    EXPECT_FALSE(phase_text(state).isEmpty()) << phase;
  }
  for (int end = static_cast<int>(falcon::TrialEnd::stopped); end <= static_cast<int>(falcon::TrialEnd::out_of_room); ++end)
    EXPECT_FALSE(end_text(static_cast<falcon::TrialEnd>(end)).isEmpty()) << end;
}

}  // namespace
}  // namespace cusp
