#include "device/hid/pedal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/device/hid/descriptors.h"

namespace cusp::device::hid {
namespace {

using test::Bytes;

PedalState state_of(const Bytes& descriptor) { return PedalState(*parse_report_descriptor(descriptor)); }
ControlId button(std::uint16_t number) { return {usage::kButtonPage, number, 0}; }

TEST(Pedal, any_of_a_known_pedals_switches_drills_until_one_is_chosen) {
  PedalState state = state_of(test::vec_descriptor());
  PedalSettings settings;
  EXPECT_EQ(reading_of(state, settings), PedalReading{});
  ASSERT_TRUE(state.take(Bytes{0x04, 0x00}));
  EXPECT_EQ(reading_of(state, settings).pressed, 65535);
  settings.drill = button(2);
  EXPECT_EQ(reading_of(state, settings).pressed, 0);
  ASSERT_TRUE(state.take(Bytes{0x02, 0x00}));
  EXPECT_EQ(reading_of(state, settings).pressed, 65535);
  settings.on = false;
  EXPECT_EQ(reading_of(state, settings), PedalReading{});
}

TEST(Pedal, a_second_switch_runs_the_coolant_and_does_not_drill) {
  PedalState state = state_of(test::vec_descriptor());
  PedalSettings settings;
  settings.coolant = button(1);
  ASSERT_TRUE(state.take(Bytes{0x01, 0x00}));
  EXPECT_EQ(reading_of(state, settings), (PedalReading{0, true}));
  settings.drill = button(3);
  ASSERT_TRUE(state.take(Bytes{0x05, 0x00}));
  EXPECT_EQ(reading_of(state, settings), (PedalReading{65535, true}));
}

TEST(Pedal, a_pedal_that_plays_keyboard_drills_with_its_key_and_with_no_other) {
  PedalState state = state_of(test::keyboard_descriptor());
  PedalSettings settings;
  settings.drill = ControlId{usage::kKeyPage, 0x68, 0};  // F13
  ASSERT_TRUE(state.take(Bytes{0, 0, 0x04, 0, 0, 0, 0, 0}));  // a
  EXPECT_EQ(reading_of(state, settings).pressed, 0);
  ASSERT_TRUE(state.take(Bytes{0, 0, 0x04, 0x68, 0, 0, 0, 0}));
  EXPECT_EQ(reading_of(state, settings).pressed, 65535);
  // Too many keys down: the keyboard reports 01 in every slot, and nothing is known to be down.
  ASSERT_TRUE(state.take(Bytes{0, 0, 1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(reading_of(state, settings).pressed, 0);
  // A modifier is a switch of its own.
  settings.drill = ControlId{usage::kKeyPage, 0xE4, 0};
  ASSERT_TRUE(state.take(Bytes{0x10, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(reading_of(state, settings).pressed, 65535);
}

TEST(Pedal, a_rheostat_rises_evenly_between_its_dead_zones_whichever_way_it_counts) {
  const auto down = PedalCalibration::from(100, 1100, 0.05), up = PedalCalibration::from(1100, 100, 0.05);
  ASSERT_TRUE(down && up);
  EXPECT_EQ(down->pressed(100), 0);
  EXPECT_EQ(down->pressed(150), 0);       // 5 % of 1000
  EXPECT_EQ(down->pressed(600), 32768);   // the middle: half of 65535, rounded
  EXPECT_EQ(down->pressed(1050), 65535);
  EXPECT_EQ(down->pressed(5000), 65535);
  EXPECT_EQ(down->pressed(-5000), 0);
  std::uint16_t last = 0;
  for (int raw = 0; raw <= 1200; ++raw) {
    EXPECT_GE(down->pressed(raw), last);
    last = down->pressed(raw);
    EXPECT_EQ(up->pressed(1200 - raw), down->pressed(raw));
  }
}

TEST(Pedal, a_calibration_of_no_way_or_too_much_dead_zone_is_none) {
  EXPECT_FALSE(PedalCalibration::from(5, 5));
  EXPECT_FALSE(PedalCalibration::from(0, 1, 0.31));
  EXPECT_FALSE(PedalCalibration::from(0, 1, -0.01));
  EXPECT_FALSE(PedalCalibration::from(0, 1, std::nan("")));
  EXPECT_TRUE(PedalCalibration::from(INT32_MIN, INT32_MAX));
}

TEST(Pedal, an_axis_that_has_not_spoken_is_released_though_it_rests_at_its_most) {
  PedalState state = state_of(test::rudder_descriptor());
  PedalSettings settings;
  settings.drill = ControlId{usage::kDesktopPage, 0x31, 0};
  settings.calibration = *PedalCalibration::from(127, 0);  // rests at its most: an unspoken 0 would be full down
  EXPECT_EQ(reading_of(state, settings).pressed, 0);
  ASSERT_TRUE(state.take(Bytes{0, 0, 0x00}));
  EXPECT_EQ(reading_of(state, settings).pressed, 65535);
  state.release();
  EXPECT_EQ(reading_of(state, settings).pressed, 0);
}

TEST(Pedal, reports_that_are_none_of_its_own_change_nothing) {
  PedalState state = state_of(test::signed_axis_descriptor());
  ASSERT_TRUE(state.take(Bytes{0x05, 0x01}));
  EXPECT_TRUE(state.any_switch());
  EXPECT_FALSE(state.take(Bytes{}));
  EXPECT_FALSE(state.take(Bytes{0x05}));        // too short
  EXPECT_FALSE(state.take(Bytes{0x06, 0x00}));  // no such number
  EXPECT_FALSE(state.take(Bytes{0x04, 0x00}));  // one byte of two
  EXPECT_TRUE(state.any_switch());
  ASSERT_TRUE(state.take(Bytes{0x04, 0x10, 0x27}));
  EXPECT_TRUE(state.any_switch());  // another report does not speak for the button
  EXPECT_EQ(state.value({usage::kSimulationPage, 0xC4, 0}), 10000);
}

TEST(Pedal, several_of_one_usage_are_distinguished) {
  Bytes two = {0x05, 0x01, 0x09, 0x04, 0xA1, 0x01, 0x09, 0x36, 0x09, 0x36, 0x15, 0x00, 0x26, 0xFF, 0x00,
               0x75, 0x08, 0x95, 0x02, 0x81, 0x02, 0xC0};
  PedalState state = state_of(two);
  ASSERT_TRUE(state.take(Bytes{10, 20}));
  EXPECT_EQ(state.value({usage::kDesktopPage, 0x36, 0}), 10);
  EXPECT_EQ(state.value({usage::kDesktopPage, 0x36, 1}), 20);
}

TEST(Pedal, a_keyboard_or_a_joystick_never_drills_unasked) {
  EXPECT_TRUE(is_known_pedal(0x05f3, 0x00ff));
  EXPECT_FALSE(is_known_pedal(0x0c45, 0x7403));  // plays keyboard: so do keyboards
  EXPECT_FALSE(is_known_pedal(0x06a3, 0x0763));
}

}  // namespace
}  // namespace cusp::device::hid
