#include "device/hid/pedal_finder.h"

#include <gtest/gtest.h>

#include "tests/device/hid/descriptors.h"

namespace cusp::device::hid {
namespace {

using test::Bytes;

struct Lesson {
  explicit Lesson(const Bytes& descriptor) : state(*parse_report_descriptor(descriptor)) {}
  void rest(const Bytes& report) {
    state.take(report);
    finder.rest(state.controls());
  }
  void press(const Bytes& report) {
    state.take(report);
    finder.press(state.controls());
  }
  std::optional<FoundControl> released(const Bytes& report) {
    state.take(report);
    return finder.released(state.controls());
  }
  PedalState state;
  PedalFinder finder;
};

TEST(PedalFinder, learns_the_switch_that_was_pressed) {
  Lesson lesson(test::vec_descriptor());
  lesson.rest({0x00, 0x00});
  EXPECT_FALSE(lesson.finder.found());
  lesson.press({0x04, 0x00});
  const auto found = lesson.finder.found();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id, (ControlId{usage::kButtonPage, 3, 0}));
  EXPECT_EQ(found->calibration, PedalCalibration::of_switch());
}

TEST(PedalFinder, learns_a_key_that_nobody_knew_before) {
  Lesson lesson(test::keyboard_descriptor());
  lesson.rest({0, 0, 0, 0, 0, 0, 0, 0});
  lesson.press({0, 0, 0x68, 0, 0, 0, 0, 0});
  lesson.press({0, 0, 0, 0, 0, 0, 0, 0});  // released again before the finder polled
  const auto found = lesson.finder.found();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id, (ControlId{usage::kKeyPage, 0x68, 0}));
  EXPECT_EQ(found->kind, ControlKind::key);
  EXPECT_EQ(found->calibration.pressed(1), 65535);
  EXPECT_EQ(found->calibration.pressed(0), 0);
}

TEST(PedalFinder, learns_the_axis_that_went_furthest_and_its_two_ends) {
  Lesson lesson(test::rudder_descriptor());
  const auto report = [](std::uint32_t rudder, std::uint32_t x, std::uint32_t y) {
    const std::uint32_t bits = rudder | x << 9 | y << 16;
    return Bytes{static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8), static_cast<std::uint8_t>(bits >> 16)};
  };
  lesson.rest(report(256, 127, 120));
  lesson.press(report(300, 127, 60));   // the rudder gives a little: 44 of 511
  lesson.press(report(250, 127, 10));
  lesson.press(report(256, 127, 90));   // the furthest place counts, not the last
  const auto found = lesson.finder.found(0.05);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id, (ControlId{usage::kDesktopPage, 0x31, 0}));
  EXPECT_EQ(found->calibration, *PedalCalibration::from(120, 10, 0.05));
}

TEST(PedalFinder, takes_a_switch_or_a_key_once_the_foot_is_off_again) {
  Lesson pedal(test::vec_descriptor());
  pedal.rest({0x00, 0x00});
  EXPECT_FALSE(pedal.released({0x00, 0x00})) << "nothing has moved";
  pedal.press({0x04, 0x00});
  EXPECT_FALSE(pedal.released({0x04, 0x00}));
  EXPECT_EQ(pedal.released({0x00, 0x00})->calibration, PedalCalibration::of_switch());
  Lesson key(test::keyboard_descriptor());
  key.rest({0, 0, 0, 0, 0, 0, 0, 0});
  key.press({0, 0, 0x68, 0, 0, 0, 0, 0});
  EXPECT_FALSE(key.released({0, 0, 0x68, 0, 0, 0, 0, 0}));
  EXPECT_EQ(key.released({0, 0, 0, 0, 0, 0, 0, 0})->calibration, PedalCalibration::of_switch());
}

TEST(PedalFinder, sees_a_key_that_was_down_at_rest_go_up_although_the_controls_omit_it_then) {
  const Bytes up{0, 0, 0, 0, 0, 0, 0, 0}, down{0, 0, 0x68, 0, 0, 0, 0, 0};
  Lesson lesson(test::keyboard_descriptor());
  lesson.rest(down);
  lesson.press(down);
  EXPECT_FALSE(lesson.finder.found());
  ASSERT_TRUE(lesson.finder.down_at_rest());
  EXPECT_EQ(lesson.finder.down_at_rest()->id, (ControlId{usage::kKeyPage, 0x68, 0}));
  lesson.press(up);
  ASSERT_TRUE(lesson.finder.found());
  EXPECT_EQ(lesson.finder.found()->calibration, *PedalCalibration::from(1, 0, 0.0));
  EXPECT_FALSE(lesson.released(up)) << "the foot was on it at rest";
  lesson.rest(up);
  lesson.press(down);
  EXPECT_FALSE(lesson.finder.down_at_rest());
  EXPECT_EQ(lesson.released(up)->calibration, PedalCalibration::of_switch());
}

TEST(PedalFinder, takes_no_switch_that_was_down_at_rest_but_one_that_opens_when_pressed) {
  Lesson lesson(test::vec_descriptor());
  lesson.rest({0x04, 0x00});
  lesson.press({0x00, 0x00});
  ASSERT_TRUE(lesson.finder.found());
  EXPECT_FALSE(lesson.released({0x00, 0x00}));
  EXPECT_EQ(lesson.released({0x04, 0x00})->calibration, *PedalCalibration::from(1, 0, 0.0));
}

TEST(PedalFinder, takes_an_axis_that_is_back_where_it_rested_and_lets_it_drill_at_neither_value) {
  const auto y = [](std::uint8_t value) { return Bytes{0, 0, value}; };
  Lesson lesson(test::rudder_descriptor());
  lesson.rest(y(120));
  lesson.press(y(20));
  EXPECT_FALSE(lesson.released(y(20)));
  EXPECT_FALSE(lesson.released(y(99))) << "21 of 100";
  const auto worn = lesson.released(y(101));
  ASSERT_TRUE(worn);
  EXPECT_EQ(worn->calibration, *PedalCalibration::from(101, 20));
  EXPECT_EQ(worn->calibration.pressed(120), 0);
  EXPECT_EQ(lesson.released(y(127))->calibration, *PedalCalibration::from(120, 20)) << "a foot lay on it lightly at rest";
  Lesson turned(test::rudder_descriptor());
  turned.rest(y(20));  // the foot is on it
  turned.press(y(120));
  EXPECT_FALSE(turned.released(y(120)));
}

TEST(PedalFinder, an_axis_that_hardly_moved_was_not_meant) {
  Lesson lesson(test::rudder_descriptor());
  lesson.rest({0, 1, 64});
  lesson.press({10, 1, 70});
  EXPECT_FALSE(lesson.finder.found());
}

TEST(PedalFinder, an_axis_that_had_not_spoken_begins_where_it_is_first_heard_of) {
  Lesson lesson(test::rudder_descriptor());
  lesson.finder.rest(lesson.state.controls());
  lesson.press({0, 0xFE, 127});  // all three speak for the first time, the brakes at their most
  lesson.press({0, 0xFE, 5});
  const auto found = lesson.finder.found();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->calibration.released_raw(), 127);
  EXPECT_EQ(found->calibration.pressed_raw(), 5);
}

}  // namespace
}  // namespace cusp::device::hid
