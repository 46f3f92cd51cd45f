#include "device/hid/space_mouse.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/device/hid/descriptors.h"

namespace cusp::device::hid {
namespace {

using namespace std::chrono_literals;
using test::Bytes;
using test::words;

const SpaceMouseState::Time kNow{std::chrono::hours(1)};
constexpr SpaceMouseSettings kPlain{.dead_zone = 0.0};

TEST(SpaceMouse, split_reports_and_one_combined_are_equal) {
  SpaceMouseState split, one;
  ASSERT_TRUE(split.take(words(1, {10, -20, 30}), kNow));
  ASSERT_TRUE(split.take(words(2, {-350, 350, 7}), kNow));
  ASSERT_TRUE(one.take(words(1, {10, -20, 30, -350, 350, 7}), kNow));
  EXPECT_EQ(split.raw(), one.raw());
  EXPECT_EQ(one.raw(), (std::array<std::int16_t, 6>{10, -20, 30, -350, 350, 7}));
}

TEST(SpaceMouse, its_axes_become_right_up_and_to_the_user) {
  SpaceMouseState state;
  state.take(words(1, {350, 350, 350}), kNow);
  const auto motion = state.motion(kPlain, kNow);
  EXPECT_EQ(motion.move, (std::array<double, 3>{1, -1, 1}));  // the device's z goes down
  state.take(words(2, {-175, 350, 350}), kNow);
  EXPECT_EQ(state.motion(kPlain, kNow).turn, (std::array<double, 3>{-0.5, -1, 1}));
}

TEST(SpaceMouse, the_dead_zone_and_the_rest_are_taken_off_and_the_full_way_stays_full) {
  SpaceMouseState state;
  SpaceMouseSettings settings{.dead_zone = 0.1};
  settings.rest[0] = 20;
  state.take(words(1, {20 + 35, 0, 0}), kNow);
  EXPECT_TRUE(state.motion(settings, kNow).still());  // 35 of 350: the edge of the dead zone
  state.take(words(1, {370, 0, 0}), kNow);
  EXPECT_DOUBLE_EQ(state.motion(settings, kNow).move[0], 1.0);
  state.take(words(1, {20 - 192, 0, 0}), kNow);  // -0.5486 of the way, less 0.1, over 0.9
  EXPECT_NEAR(state.motion(settings, kNow).move[0], -(192.0 / 350.0 - 0.1) / 0.9, 1e-12);
}

TEST(SpaceMouse, silence_while_deflected_is_a_release_and_buttons_stay) {
  SpaceMouseState state;
  state.take(words(1, {350, 0, 0}), kNow);
  state.take(Bytes{3, 0x01, 0x00}, kNow);
  EXPECT_FALSE(state.motion(kPlain, kNow + SpaceMouseState::kSilence).still());
  EXPECT_TRUE(state.motion(kPlain, kNow + SpaceMouseState::kSilence + 1ms).still());
  EXPECT_EQ(state.motion(kPlain, kNow + 10s).buttons, 1u);  // they speak on change alone
  state.release();
  EXPECT_EQ(state.motion(kPlain, kNow), SpaceMouseMotion{});
}

TEST(SpaceMouse, halves_can_be_switched_off) {
  SpaceMouseState state;
  state.take(words(1, {350, 350, 350, 350, 350, 350}), kNow);
  SpaceMouseSettings settings = kPlain;
  settings.moves = false;
  EXPECT_EQ(state.motion(settings, kNow).move, (std::array<double, 3>{}));
  EXPECT_NE(state.motion(settings, kNow).turn, (std::array<double, 3>{}));
  settings.on = false;
  EXPECT_EQ(state.motion(settings, kNow), SpaceMouseMotion{});
}

TEST(SpaceMouse, buttons_and_battery_are_read_and_rubbish_is_refused) {
  SpaceMouseState state;
  EXPECT_TRUE(state.take(Bytes{3, 0x02}, kNow));
  EXPECT_EQ(state.motion(kPlain, kNow).buttons, 2u);
  EXPECT_TRUE(state.take(Bytes{3, 0x01, 0x80, 0x00, 0x40, 0xFF, 0xFF}, kNow));  // 32 of them are enough
  EXPECT_EQ(state.motion(kPlain, kNow).buttons, 0x40008001u);
  EXPECT_TRUE(state.take(Bytes{0x17, 80}, kNow));
  EXPECT_EQ(state.battery_percent(), 80);
  EXPECT_FALSE(state.take(Bytes{0x17, 101}, kNow));
  EXPECT_FALSE(state.take(Bytes{}, kNow));
  EXPECT_FALSE(state.take(Bytes{1, 0, 0, 0, 0, 0}, kNow));
  EXPECT_FALSE(state.take(Bytes{2, 0}, kNow));
  EXPECT_FALSE(state.take(Bytes{9, 1, 2, 3, 4, 5, 6, 7}, kNow));
  EXPECT_EQ(state.battery_percent(), 80);
}

TEST(SpaceMouse, whatever_comes_its_motion_stays_within_one) {
  std::mt19937 random(11);
  SpaceMouseState state;
  Bytes report;
  for (int i = 0; i < 200'000; ++i) {
    report.resize(random() % 20);
    for (std::uint8_t& byte : report) byte = static_cast<std::uint8_t>(random());
    if (!report.empty() && i % 2 == 0) report[0] = static_cast<std::uint8_t>(1 + random() % 3);
    state.take(report, kNow);
    for (const auto& half : {state.motion({}, kNow).move, state.motion({}, kNow).turn}) {
      for (const double v : half) ASSERT_LE(std::abs(v), 1.0);
    }
  }
}

TEST(SpaceMouse, only_six_axis_devices_are_taken_for_one) {
  EXPECT_TRUE(is_space_mouse(0x256f, 0xc635));
  EXPECT_TRUE(is_space_mouse(0x046d, 0xc62b));
  EXPECT_FALSE(is_space_mouse(0x256f, 0xc650));  // a mouse with a wheel
  EXPECT_FALSE(is_space_mouse(0x046d, 0xc52b));  // a receiver of ordinary mice
  EXPECT_FALSE(is_space_mouse(0x05f3, 0x00ff));
}

}  // namespace
}  // namespace cusp::device::hid
