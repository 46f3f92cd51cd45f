// The device page without a window system: what it lists, what it keeps, and the emulated Falcon on its bench.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QAccessible>
#include <QComboBox>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/device/falcon/images.h"
#include "tests/modules.h"
#include "tests/ui/device/eventually.h"
#include "tests/ui/device/shown_parts.h"
#include "tests/ui/session/gate.h"
#include "ui/settings/device_settings.h"
#include "ui/device/device_page.h"
#include "ui/device/falcon_panel.h"
#include "ui/device/inverse_panel.h"
#include "ui/device/self_test_report.h"
#include "ui/device/trim_form.h"
#include "ui/session/background_task.h"
#include "ui/text/falcon_text.h"
#include "ui/widgets/number_field.h"

namespace cusp::test {
namespace {

/// A bus that lists what the test plugs in.
struct Bus {
  std::vector<FoundDevice> hardware;
  bool news = true;
};
class TestWatch final : public DeviceWatch {
 public:
  explicit TestWatch(Bus& bus) : bus_(bus) {}
  std::vector<FoundDevice> list() override { return with_software_devices(bus_.hardware); }
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
  std::unique_ptr<DevicePage> page(Role role) {
    return std::make_unique<DevicePage>(settings, ports, role, nullptr, [this] { return std::make_unique<TestWatch>(bus); });
  }
  DeviceChoice choice() { return DeviceSettings(settings.file()).choice(); }
};

/// Asks the homed Falcon for its force.
bool feel_force(FalconPanel& panel) {
  QPushButton* force = button(panel, QStringLiteral("Feel the force"));
  const bool ready = eventually([&] {
    panel.look();
    return force->isEnabled();
  });
  force->click();
  return ready;
}
/// Nobody holds it: the force goes off by itself, and the panel shows it.
bool force_goes_off(FalconPanel& panel) {
  return eventually([&] {
    panel.look();
    return shows(panel, QStringLiteral("Nothing was changed"));
  });
}

TEST(DevicePage, lists_what_is_plugged_in_and_keeps_what_was_chosen) {
  Desk desk;
  desk.bus.hardware = {{.kind = "falcon", .name = "FT000001", .port = "1-1"}, {.kind = "falcon", .name = "FT000002", .port = "1-2"}};
  auto page = desk.page(Role::instructor);
  ASSERT_EQ(page->listed().size(), 4);
  EXPECT_TRUE(page->listed()[0].contains(QStringLiteral("FT000001")));
  EXPECT_TRUE(page->listed()[1].contains(QStringLiteral("FT000002")));
  EXPECT_EQ(desk.choice().kind, "pointer");
  page->findChildren<QRadioButton*>()[1]->click();
  EXPECT_EQ(desk.choice().kind, "falcon");
  EXPECT_EQ(desk.choice().name, "FT000002");
}

TEST(DevicePage, shows_a_student_who_chooses_the_device) {
  Desk desk;
  EXPECT_TRUE(shows(*desk.page(Role::student), QStringLiteral("Staff choose the device.")));
  EXPECT_FALSE(shows(*desk.page(Role::instructor), QStringLiteral("Staff choose the device.")));
}

TEST(DevicePage, a_device_is_chosen_by_a_screen_reader_as_by_a_click) {
  Desk desk;
  auto page = desk.page(Role::instructor);
  QSignalSpy chosen(page.get(), &DevicePage::chosen);
  const auto buttons = page->findChildren<QRadioButton*>();  // the emulated Falcon, the mouse
  QRadioButton* emulated = nullptr;
  for (QRadioButton* one : buttons)
    if (one->text().contains(QStringLiteral("Emulated"))) emulated = one;
  ASSERT_NE(emulated, nullptr);
  QAccessibleActionInterface* act = QAccessible::queryAccessibleInterface(emulated)->actionInterface();
  ASSERT_NE(act, nullptr);
  act->doAction(QAccessibleActionInterface::toggleAction());
  EXPECT_TRUE(emulated->isChecked());
  EXPECT_EQ(desk.choice().kind, "emulated-falcon");
  EXPECT_EQ(chosen.count(), 1);
  EXPECT_TRUE(page->falcon()->isVisibleTo(page.get()));
}

TEST(DevicePage, a_press_is_not_lost_to_a_device_that_comes_meanwhile) {
  Desk desk;
  auto page = desk.page(Role::instructor);
  const auto rows = page->findChildren<QRadioButton*>();
  const auto other = std::ranges::find_if(rows, [](const QRadioButton* row) { return !row->isChecked(); });
  ASSERT_NE(other, rows.end());
  const QPointer<QRadioButton> pressed = *other;
  pressed->setDown(true);
  desk.bus.hardware = {{.kind = "falcon", .name = "FT000001", .port = "1-1"}};
  desk.bus.news = true;
  page->look();
  ASSERT_FALSE(pressed.isNull());
  pressed->click();
  EXPECT_EQ(desk.choice().kind, "emulated-falcon");
  page->look();
  EXPECT_EQ(page->listed().size(), 3);
}

TEST(DevicePage, one_that_comes_or_goes_is_listed_without_a_click) {
  Desk desk;
  auto page = desk.page(Role::instructor);
  EXPECT_TRUE(shows(*page, QStringLiteral("No Falcon is plugged in")));
  desk.bus.hardware = {{.kind = "falcon", .name = "FT000001", .port = "1-1"}};
  desk.bus.news = true;
  page->look();
  EXPECT_EQ(page->listed().size(), 3);
  EXPECT_FALSE(shows(*page, QStringLiteral("No Falcon is plugged in")));
  desk.bus.hardware.clear();
  desk.bus.news = true;
  page->look();
  EXPECT_EQ(page->listed().size(), 2);
}

TEST(DevicePage, a_bus_that_hangs_holds_the_window_neither_when_it_opens_nor_looks_nor_closes) {
  struct Hanging final : DeviceWatch {
    explicit Hanging(std::shared_ptr<test::Gate> g) : gate(std::move(g)) {}
    std::vector<FoundDevice> list() override {
      gate->pass();
      return with_software_devices({{.kind = "falcon", .name = "FT000001", .port = "1-1"}});
    }
    bool changed() noexcept override { return true; }
    std::shared_ptr<test::Gate> gate;
  };
  Desk desk;
  auto gate = std::make_shared<test::Gate>();
  const DevicePage::MakeWatch background = [gate] {
    return watch_in_background([gate] { return std::make_unique<Hanging>(gate); });
  };
  {
    DevicePage left(desk.settings, desk.ports, Role::instructor, nullptr, background);
    left.show();
    left.look();
    EXPECT_TRUE(shows(left, QStringLiteral("Looking at what is plugged in")));
    left.hide();
  }
  DevicePage page(desk.settings, desk.ports, Role::instructor, nullptr, background);
  page.show();
  EXPECT_FALSE(gate->gave_up());
  gate->open();
  EXPECT_TRUE(test::eventually([&] { return page.listed().size() == 3; }));
  EXPECT_FALSE(shows(page, QStringLiteral("Looking at what is plugged in")));
  page.hide();
  wait_for_dropped_tasks();
  EXPECT_FALSE(gate->gave_up());
}

TEST(DevicePage, a_falcon_that_may_not_be_opened_comes_with_the_line_that_mends_it) {
  Desk desk;
  desk.bus.hardware = {{.kind = "falcon", .name = "1-1", .port = "1-1", .denied = true}};
  auto page = desk.page(Role::instructor);
  bool there = false;
  for (const QLineEdit* line : page->findChildren<QLineEdit*>()) there = there || line->text().contains(QStringLiteral("udevadm"));
  EXPECT_TRUE(there);
}

TEST(DevicePage, a_student_looks_and_feels_and_changes_nothing) {
  Desk desk;
  desk.bus.hardware = {{.kind = "falcon", .name = "FT000001", .port = "1-1"}};
  auto page = desk.page(Role::student);
  for (const QRadioButton* pick : page->findChildren<QRadioButton*>()) EXPECT_EQ(pick->isEnabled(), pick->isChecked());
  EXPECT_TRUE(button(*page, QStringLiteral("Self-test"))->isHidden());
  EXPECT_TRUE(button(*page, QStringLiteral("Weigh the grip"))->isHidden());
  EXPECT_FALSE(button(*page, QStringLiteral("Feel the force"))->isHidden());
  EXPECT_FALSE(button(*page, QStringLiteral("Name the file…"))->isVisibleTo(page.get()));
}

TEST(DevicePage, a_student_changes_no_setting_of_the_inverse3) {
  Desk desk;
  desk.bus.hardware = {{.kind = "inverse3"}};
  const auto page = desk.page(Role::student);
  for (NumberField* field : page->findChild<InversePanel*>()->findChildren<NumberField*>()) EXPECT_FALSE(field->isEnabled());
}

TEST(DevicePage, a_firmware_file_is_checked_before_it_is_kept) {
  Desk desk;
  auto page = desk.page(Role::instructor);
  desk.picked = desk.folder.filePath(QStringLiteral("no.bin"));
  std::ofstream(desk.picked.toStdString()) << "not a firmware";
  button(*page, QStringLiteral("Name the file…"))->click();
  EXPECT_TRUE(desk.choice().firmware.file.empty());
  const auto bytes = test::boot_image();
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

TEST(DevicePage, the_trim_of_each_falcon_is_kept_under_its_name_and_can_be_taken_back) {
  Desk desk;
  desk.bus.hardware = {{.kind = "falcon", .name = "FT000001", .port = "1-1"}, {.kind = "falcon", .name = "FT000002", .port = "1-2"}};
  auto page = desk.page(Role::instructor);
  page->findChildren<QRadioButton*>()[0]->click();
  auto* form = page->findChild<TrimForm*>();
  ASSERT_TRUE(form->isVisibleTo(page.get()));
  const auto numbers = form->findChildren<NumberField*>();  // right, up, nearer, the hand's way, the force
  numbers[3]->setValue(80);
  numbers[4]->setValue(125);
  numbers[1]->setValue(-7);
  const FalconProfile kept = DeviceSettings(desk.settings.file()).profile("FT000001");
  EXPECT_DOUBLE_EQ(kept.scale, 0.8);
  EXPECT_DOUBLE_EQ(kept.calibration.force_gain, 1.25);
  EXPECT_LT(glm::length(kept.centre_m - Vec3(0, -0.007, 0.125)), 1e-12);
  EXPECT_EQ(DeviceSettings(desk.settings.file()).profile("FT000002"), FalconProfile{});
  // What the attempt is made with.
  const FalconSettings driver = settings_for(desk.choice().profile);
  EXPECT_DOUBLE_EQ(driver.workspace.scale, 0.8);
  EXPECT_DOUBLE_EQ(driver.calibration.force_gain, 1.25);
  EXPECT_EQ(driver.workspace.centre_m, kept.centre_m);

  button(*form, QStringLiteral("Undo"))->click();
  button(*form, QStringLiteral("Undo"))->click();
  EXPECT_EQ(form->trim(), (FalconTrim{.scale = 0.8}));
  EXPECT_DOUBLE_EQ(DeviceSettings(desk.settings.file()).profile("FT000001").calibration.force_gain, 1.0);
  page->findChildren<QRadioButton*>()[1]->click();
  EXPECT_EQ(form->trim(), FalconTrim{});
  EXPECT_FALSE(button(*form, QStringLiteral("Undo"))->isEnabled());  // those steps were of the other one
  page->findChildren<QRadioButton*>()[0]->click();
  EXPECT_DOUBLE_EQ(form->trim().scale, 0.8);
}

TEST(DevicePage, the_trim_is_for_staff_and_for_a_real_falcon) {
  Desk desk;
  desk.bus.hardware = {{.kind = "falcon", .name = "FT000001", .port = "1-1"}};
  DeviceSettings(desk.settings.file()).choose("falcon", "FT000001");
  EXPECT_FALSE(desk.page(Role::instructor)->findChild<TrimForm*>()->parentWidget()->isHidden());
  EXPECT_TRUE(desk.page(Role::student)->findChild<TrimForm*>()->parentWidget()->isHidden());
  DeviceSettings(desk.settings.file()).choose("emulated-falcon", {});
  EXPECT_TRUE(desk.page(Role::instructor)->findChild<TrimForm*>()->parentWidget()->isHidden());
}

TEST(DevicePage, a_test_goes_on_while_another_device_comes) {
  Desk desk;
  DeviceSettings(desk.settings.file()).choose("emulated-falcon", {});
  auto page = desk.page(Role::instructor);
  page->show();
  FalconPanel* panel = page->falcon();
  ASSERT_TRUE(feel_force(*panel)) << panel->summary().toStdString();
  panel->look();
  QPushButton* stop = button(*panel, QStringLiteral("Stop"));
  ASSERT_TRUE(stop->isVisibleTo(panel));
  desk.bus.hardware = {{.kind = "inverse3"}};
  desk.bus.news = true;
  page->look();
  ASSERT_EQ(page->listed().size(), 3);
  EXPECT_TRUE(force_goes_off(*panel));
  page->hide();
}

TEST(DevicePage, staff_reach_the_port_of_a_service_that_is_not_found) {
  Desk desk;
  const auto staff = desk.page(Role::instructor), student = desk.page(Role::student);
  EXPECT_TRUE(shows(*staff, QStringLiteral("Port of the service")));
  EXPECT_FALSE(shows(*student, QStringLiteral("Port of the service")));
}

TEST(DevicePage, the_emulated_falcon_homes_answers_and_pushes) {
  Desk desk;
  DeviceSettings(desk.settings.file()).choose("emulated-falcon", {});
  auto page = desk.page(Role::instructor);
  page->show();
  FalconPanel* panel = page->falcon();
  ASSERT_TRUE(feel_force(*panel)) << panel->summary().toStdString();
  EXPECT_EQ(desk.asked.size(), 1);
  EXPECT_TRUE(force_goes_off(*panel));
  page->hide();  // releases it
}

TEST(SelfTestReport, shows_what_was_measured_and_what_it_means_for_exercises) {
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

}  // namespace
}  // namespace cusp::test
