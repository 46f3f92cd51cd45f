// Panels of pedal and SpaceMouse over devices in memory, and how a SpaceMouse leads a camera. What is waited for is
// progress, never time.
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTemporaryDir>
#include <numbers>

#include "tests/device/hid/desk.h"
#include "tests/modules.h"
#include "tests/ui/device/eventually.h"
#include "tests/ui/device/unwritable_settings.h"
#include "ui/settings/settings.h"
#include "ui/device/hid_settings.h"
#include "ui/device/pedal_panel.h"
#include "ui/device/pedal_text.h"
#include "ui/device/space_mouse_panel.h"
#include "ui/device/space_mouse_turner.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/number_field.h"

namespace cusp::test {
namespace {

using test::bus_of;
using test::Bytes;
using test::Desk;
using test::eventually;

class Panels : public ::testing::Test {
 protected:
  /// A visible button by its text.
  static QPushButton* button(QWidget& panel, const QString& name) {
    for (QPushButton* b : panel.findChildren<QPushButton*>()) {
      if ((b->text().trimmed() == name || b->accessibleName() == name) && b->isVisibleTo(&panel)) return b;
    }
    return nullptr;
  }
  static bool shows(QWidget& panel, const QString& text) {
    for (QLabel* label : panel.findChildren<QLabel*>()) {
      if (label->text().contains(text) && label->isVisibleTo(&panel)) return true;
    }
    return false;
  }

  QTemporaryDir folder;
  Settings settings{folder.filePath("Cusp.ini")};
  Desk desk;
};

TEST_F(Panels, a_rheostat_is_calibrated_by_pressing_it_and_stays_so) {
  auto rudder = desk.plug("/dev/hidraw1", 0x06a3, 0x0763, test::rudder_descriptor());
  hid::PedalReader reader(bus_of(desk));
  reader.start();
  PedalPanel panel(reader, &settings);
  panel.show();
  EXPECT_TRUE(eventually([&] {
    panel.look();
    return panel.findChild<QComboBox*>()->count() == 2;
  }));
  EXPECT_EQ(panel.summary(), "No foot pedal is connected");
  auto* box = panel.findChild<QComboBox*>();
  box->setCurrentIndex(1);
  Q_EMIT box->activated(1);
  ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
  panel.look();
  EXPECT_TRUE(shows(panel, "calibrate it"));  // it drives nothing unasked

  desk.send(rudder, {0, 0, 120});
  ASSERT_TRUE(eventually([&] { return reader.view().reports == 1; }));
  button(panel, "Calibrate")->click();
  ASSERT_TRUE(shows(panel, "take the foot off"));
  button(panel, "Next")->click();
  ASSERT_TRUE(shows(panel, "all the way down"));
  EXPECT_FALSE(button(panel, "Next")->isEnabled());
  desk.send(rudder, {0, 0, 20});
  ASSERT_TRUE(eventually([&] { return button(panel, "Next")->isEnabled(); }));
  button(panel, "Next")->click();
  EXPECT_FALSE(button(panel, "Take it over")->isEnabled()) << "the foot is on it";
  desk.send(rudder, {0, 0, 120});
  ASSERT_TRUE(eventually([&] { return button(panel, "Take it over")->isEnabled(); }));
  button(panel, "Take it over")->click();
  EXPECT_EQ(reader.settings().drill, (hid::ControlId{hid::usage::kDesktopPage, 0x31, 0}));
  EXPECT_EQ(reader.settings().calibration.released_raw(), 120);
  EXPECT_EQ(reader.settings().calibration.pressed_raw(), 20);
  desk.send(rudder, {0, 0, 20});
  ASSERT_TRUE(eventually([&] { return reader.view().reading.pressed == 65535; }));
  panel.look();
  EXPECT_TRUE(shows(panel, "100"));
  EXPECT_EQ(HidSettings(settings.file()).pedal(), reader.settings());

  panel.findChild<NumberField*>()->setValue(20);
  EXPECT_DOUBLE_EQ(HidSettings(settings.file()).pedal().calibration.dead_zone(), 0.2);
  desk.unplug(rudder);
  EXPECT_TRUE(eventually([&] {
    panel.look();
    return panel.summary() == "No foot pedal is connected";
  }));
}

TEST_F(Panels, a_foot_on_the_pedal_at_the_first_step_does_not_turn_its_ends_round) {
  auto rudder = desk.plug("/dev/hidraw1", 0x06a3, 0x0763, test::rudder_descriptor());
  hid::PedalReader reader(bus_of(desk));
  reader.start();
  PedalPanel panel(reader, &settings);
  panel.show();
  ASSERT_TRUE(eventually([&] {
    panel.look();
    return panel.findChild<QComboBox*>()->count() == 2;
  }));
  Q_EMIT panel.findChild<QComboBox*>()->activated(1);
  ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
  desk.send(rudder, {0, 0, 20});  // pressed
  ASSERT_TRUE(eventually([&] { return reader.view().reports == 1; }));
  panel.look();
  button(panel, "Calibrate")->click();
  button(panel, "Next")->click();
  desk.send(rudder, {0, 0, 120});
  ASSERT_TRUE(eventually([&] { return button(panel, "Next")->isEnabled(); }));
  desk.send(rudder, {0, 0, 20});  // held down, as the step asks
  ASSERT_TRUE(eventually([&] { return !button(panel, "Next")->isEnabled(); }));
  EXPECT_TRUE(shows(panel, "If it is down, it was pressed at the first step"));
  desk.send(rudder, {0, 0, 120});
  ASSERT_TRUE(eventually([&] { return button(panel, "Next")->isEnabled(); }));
  button(panel, "Next")->click();
  EXPECT_FALSE(button(panel, "Take it over")->isEnabled());
  EXPECT_TRUE(shows(panel, "If the foot is off, the pedal was pressed at the first step"));
  button(panel, "Take it over")->click();
  EXPECT_EQ(reader.settings().drill, hid::ControlId{}) << "nothing is taken over";
  EXPECT_EQ(HidSettings(settings.file()).pedal().calibration, hid::PedalCalibration::of_switch());
}

TEST_F(Panels, a_key_that_is_held_at_the_first_step_is_named_and_calibrates_once_it_was_released) {
  const Bytes up{0, 0, 0, 0, 0, 0, 0, 0}, down{0, 0, 0x68, 0, 0, 0, 0, 0};
  auto keyboard = desk.plug("/dev/hidraw1", 0x0c45, 0x7403, test::keyboard_descriptor());
  hid::PedalReader reader(bus_of(desk));
  reader.start();
  PedalPanel panel(reader, &settings);
  panel.show();
  ASSERT_TRUE(eventually([&] {
    panel.look();
    return panel.findChild<QComboBox*>()->count() == 2;
  }));
  Q_EMIT panel.findChild<QComboBox*>()->activated(1);
  ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
  desk.send(keyboard, down);
  ASSERT_TRUE(eventually([&] { return reader.view().reports == 1; }));
  panel.look();
  button(panel, "Calibrate")->click();
  button(panel, "Next")->click();
  EXPECT_TRUE(shows(panel, "F13 was down at the first step"));
  EXPECT_FALSE(button(panel, "Next")->isEnabled());
  desk.send(keyboard, up);
  ASSERT_TRUE(eventually([&] { return button(panel, "Next")->isEnabled(); }));
  desk.send(keyboard, down);
  ASSERT_TRUE(eventually([&] { return !button(panel, "Next")->isEnabled(); }));
  EXPECT_TRUE(shows(panel, "If it is down, it was pressed at the first step"));
  desk.send(keyboard, up);
  ASSERT_TRUE(eventually([&] { return reader.view().reports == 4; }));
  button(panel, "Cancel")->click();
  button(panel, "Calibrate")->click();
  button(panel, "Next")->click();
  desk.send(keyboard, down);
  ASSERT_TRUE(eventually([&] { return button(panel, "Next")->isEnabled(); }));
  button(panel, "Next")->click();
  desk.send(keyboard, up);
  ASSERT_TRUE(eventually([&] { return button(panel, "Take it over")->isEnabled(); }));
  button(panel, "Take it over")->click();
  EXPECT_EQ(reader.settings().drill, (hid::ControlId{hid::usage::kKeyPage, 0x68, 0}));
  EXPECT_EQ(reader.settings().calibration, hid::PedalCalibration::of_switch());
}

TEST_F(Panels, a_switch_that_is_released_is_not_taken_for_the_coolant) {
  auto pedal = desk.plug("/dev/hidraw1", 0x05f3, 0x00ff, test::vec_descriptor());
  hid::PedalReader reader(bus_of(desk));
  reader.start();
  PedalPanel panel(reader, &settings);
  panel.show();
  ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
  desk.send(pedal, {0x04, 0x00});  // the foot rests on the switch that drills
  ASSERT_TRUE(eventually([&] { return reader.view().reports == 1; }));
  panel.look();
  button(panel, "Choose the switch for the coolant")->click();
  desk.send(pedal, {0x00, 0x00});
  ASSERT_TRUE(eventually([&] { return reader.view().reports == 2; }));
  panel.look();
  EXPECT_FALSE(reader.settings().coolant);
  desk.send(pedal, {0x01, 0x00});
  ASSERT_TRUE(eventually([&] { return reader.settings().coolant.has_value(); }));
  EXPECT_EQ(*reader.settings().coolant, (hid::ControlId{hid::usage::kButtonPage, 1, 0}));
}

TEST_F(Panels, a_known_pedal_needs_no_calibration_and_gets_a_switch_for_the_coolant) {
  auto pedal = desk.plug("/dev/hidraw1", 0x05f3, 0x00ff, test::vec_descriptor());
  hid::PedalReader reader(bus_of(desk));
  reader.start();
  PedalPanel panel(reader, &settings);
  panel.show();
  ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
  panel.look();
  EXPECT_TRUE(shows(panel, "Any switch of it"));
  button(panel, "Choose the switch for the coolant")->click();
  ASSERT_TRUE(shows(panel, "runs the coolant"));
  desk.send(pedal, {0x01, 0x00});
  ASSERT_TRUE(eventually([&] { return reader.settings().coolant.has_value(); }));
  EXPECT_EQ(*reader.settings().coolant, (hid::ControlId{hid::usage::kButtonPage, 1, 0}));
  ASSERT_TRUE(eventually([&] { return reader.view().reading == PedalReading{0, true}; }));
  panel.look();
  button(panel, "No switch for the coolant")->click();
  EXPECT_FALSE(reader.settings().coolant);
  panel.findChild<QCheckBox*>()->click();
  EXPECT_FALSE(HidSettings(settings.file()).pedal().on);
}

TEST_F(Panels, what_a_pedal_types_while_it_is_calibrated_presses_no_button) {
  desk.plug("/dev/hidraw1", 0x05f3, 0x00ff, test::vec_descriptor());
  hid::PedalReader reader(bus_of(desk));
  reader.start();
  PedalPanel panel(reader, &settings);
  panel.show();
  panel.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
  ASSERT_TRUE(eventually([&] { return reader.view().connected; }));
  panel.look();
  for (const char* begins : {"Calibrate", "Choose the switch for the coolant"}) {
    QPushButton* begin = button(panel, begins);
    ASSERT_NE(begin, nullptr);
    begin->setFocus();
    begin->click();
    ASSERT_NE(QApplication::focusWidget(), nullptr);
    EXPECT_EQ(qobject_cast<QPushButton*>(QApplication::focusWidget()), nullptr) << begins;
    button(panel, "Cancel")->click();
    EXPECT_EQ(QApplication::focusWidget(), begin) << begins;
  }
}

TEST_F(Panels, a_pedal_that_may_not_be_opened_comes_with_the_line_that_mends_it) {
  desk.plug("/dev/hidraw1", 0x05f3, 0x00ff, test::vec_descriptor())->denied = true;
  hid::PedalReader reader(bus_of(desk));
  reader.start();
  PedalPanel panel(reader, nullptr);
  panel.show();
  EXPECT_TRUE(eventually([&] {
    panel.look();
    return shows(panel, "may not open it");
  }));
  EXPECT_TRUE(button(panel, "Copy"));
}

TEST_F(Panels, a_space_mouse_takes_its_rest_only_from_a_hand_that_is_off) {
  auto mouse = desk.plug("/dev/hidraw1", 0x256f, 0xc635, test::space_mouse_descriptor());
  hid::SpaceMouseReader reader(bus_of(desk));
  reader.start();
  SpaceMousePanel panel(reader, &settings);
  panel.show();
  const auto view = [&] { return reader.view(std::chrono::steady_clock::now()); };
  ASSERT_TRUE(eventually([&] { return view().connected; }));
  panel.look();
  desk.send(mouse, test::words(1, {300, 0, 0}));
  ASSERT_TRUE(eventually([&] { return view().raw[0] == 300; }));
  button(panel, "Hand is off: take this as rest")->click();
  EXPECT_TRUE(shows(panel, "Take the hand off first"));
  desk.send(mouse, test::words(1, {12, -3, 0}));
  ASSERT_TRUE(eventually([&] { return view().raw[0] == 12; }));
  button(panel, "Hand is off: take this as rest")->click();
  EXPECT_EQ(HidSettings(settings.file()).space_mouse().rest[0], 12);
  EXPECT_EQ(reader.settings().rest[1], -3);
}

TEST_F(Panels, what_no_file_takes_of_a_pedal_holds_until_the_program_ends_and_is_reported) {
  Settings lost(unwritable_settings(folder));
  for (Settings* over : {&settings, &lost}) {
    hid::PedalReader reader(bus_of(desk));
    PedalPanel panel(reader, over);
    EXPECT_EQ(band_text(panel), QString());
    panel.findChild<QCheckBox*>()->click();
    EXPECT_EQ(band_text(panel).startsWith(kUnkept), over == &lost) << band_text(panel).toStdString();
    EXPECT_EQ(HidSettings(over->file()).pedal(), reader.settings());
  }
}

TEST_F(Panels, what_no_file_takes_of_a_space_mouse_is_reported) {
  Settings lost(unwritable_settings(folder));
  for (Settings* over : {&settings, &lost}) {
    hid::SpaceMouseReader reader(bus_of(desk));
    SpaceMousePanel panel(reader, over);
    panel.findChild<QSlider*>()->setValue(250);
    EXPECT_EQ(band_text(panel).startsWith(kUnkept), over == &lost) << band_text(panel).toStdString();
    EXPECT_DOUBLE_EQ(HidSettings(over->file()).space_mouse().speed, 2.5);
  }
}

TEST_F(Panels, a_space_mouse_reports_that_it_leads_a_view) {
  auto mouse = desk.plug("/dev/hidraw1", 0x256f, 0xc635, test::space_mouse_descriptor());
  hid::SpaceMouseReader reader(bus_of(desk));
  reader.start();
  ToothView view;
  view.show();
  view.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&view));
  SpaceMouseTurner turner(view, reader);
  bool moved = false;
  QObject::connect(&turner, &SpaceMouseTurner::moved, &view, [&moved] { moved = true; });
  ASSERT_TRUE(eventually([&] { return reader.view(std::chrono::steady_clock::now()).connected; }));
  EXPECT_FALSE(moved);
  EXPECT_TRUE(eventually([&] {
    desk.send(mouse, test::words(1, {300, 0, 0}));  // as while it is held
    return moved;
  }));
}

TEST(SpaceMouseLeads, a_full_turn_of_the_cap_is_a_quarter_turn_a_second) {
  const Camera camera = Camera::about({0, 0, 0}, 5.0);
  hid::SpaceMouseMotion motion;
  motion.turn = {0, 1, 0};
  EXPECT_NEAR(std::remainder(led(camera, motion, 1.0, 1.0).yaw() - camera.yaw(), 2 * std::numbers::pi),
              -std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(std::remainder(led(camera, motion, 2.0, 0.25).yaw() - camera.yaw(), 2 * std::numbers::pi),
              -std::numbers::pi / 4, 1e-12);
}

TEST(SpaceMouseLeads, pulled_to_the_user_the_tooth_comes_nearer_and_pushed_right_it_goes_right) {
  const Camera camera = Camera::about({0, 0, 0}, 5.0);
  hid::SpaceMouseMotion motion;
  motion.move = {0, 0, 1};
  EXPECT_NEAR(led(camera, motion, 1.0, 1.0).distance_mm(), camera.distance_mm() / std::numbers::e, 1e-9);
  motion.move = {1, 0, 0};
  const auto before = camera.project({0, 0, 0}, {800, 600}), after = led(camera, motion, 1.0, 0.5).project({0, 0, 0}, {800, 600});
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(after->x - before->x, 0.25 * 600, 1.0);  // half the shorter side a second
  motion.move = {0, 1, 0};
  EXPECT_LT(led(camera, motion, 1.0, 0.5).project({0, 0, 0}, {800, 600})->y, before->y);
  motion.move = {};
  EXPECT_EQ(led(camera, motion, 3.0, 1.0), camera);
}

TEST(PedalText, controls_have_names_that_people_know) {
  EXPECT_EQ(control_name({hid::usage::kButtonPage, 2, 0}, hid::ControlKind::button), "Switch 2");
  EXPECT_EQ(control_name({hid::usage::kKeyPage, 0x68, 0}, hid::ControlKind::key), "Key F13");
  EXPECT_EQ(control_name({hid::usage::kKeyPage, 0x05, 0}, hid::ControlKind::key), "Key B");
  EXPECT_EQ(control_name({hid::usage::kSimulationPage, 0xC4, 0}, hid::ControlKind::axis), "Accelerator");
  EXPECT_EQ(control_name({hid::usage::kDesktopPage, 0x35, 1}, hid::ControlKind::axis), "Axis Rz (2)");
}

}  // namespace
}  // namespace cusp::test
