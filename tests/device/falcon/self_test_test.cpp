// The self-test on emulated Falcons whose mass, damping, friction and delay are known: what it measures against what was
// set. The whole driver, bytes and all, in a time that stands still until somebody waits.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <limits>

#include "device/falcon/profile.h"
#include "device/falcon/self_test.h"
#include "tests/device/falcon/trial_bench.h"

namespace cusp::device::falcon {
namespace {

using namespace std::chrono_literals;
using test::TrialBench;

SelfTestResult measured(const EmulatedBodySettings& body, const EmulatedLinkSettings& line = {}) {
  TrialBench bench(body, line);
  SelfTest trial;
  bench.run(trial);
  EXPECT_EQ(trial.end(), TrialEnd::done) << static_cast<int>(trial.end());
  const SelfTestResult out = trial.result();
  for (int i = 0; i < 3; ++i) {
    const auto& fit = out.axes[static_cast<std::size_t>(i)];
    if (!fit) continue;
    std::cout << "axis " << i << ": " << fit->mass_kg << " kg, " << fit->damping_ns_per_m << " +- " << fit->damping_error
              << " Ns/m, " << fit->friction_n << " +- " << fit->friction_error << " N, weight " << fit->weight_n << " N, "
              << fit->delay_ms << " +- " << fit->delay_error_ms << " ms, " << fit->windows << " windows\n";
  }
  return out;
}

TEST(FalconSelfTest, finds_the_damping_friction_and_mass_that_were_set) {
  for (const EmulatedBodySettings& set : {EmulatedBodySettings{.moving_kg = 0.2, .damping_ns_per_m = 2.0, .friction_n = 0.1},
                                          EmulatedBodySettings{.moving_kg = 0.12, .damping_ns_per_m = 0.5, .friction_n = 0.3},
                                          EmulatedBodySettings{.moving_kg = 0.3, .damping_ns_per_m = 5.0, .friction_n = 0.0}}) {
    const SelfTestResult found = measured(set);
    for (const auto& axis : found.axes) {
      ASSERT_TRUE(axis);
      // Measured off: 0.6 % of the mass, 0.016 Ns/m, 1.6 mN; the encoders' steps are what is left.
      EXPECT_NEAR(axis->mass_kg, set.moving_kg, 0.02 * set.moving_kg);
      EXPECT_NEAR(axis->damping_ns_per_m, set.damping_ns_per_m, 0.05);
      EXPECT_NEAR(axis->friction_n, set.friction_n, 0.005);
    }
    EXPECT_EQ(found.missing, 0u);
    EXPECT_EQ(found.least_counts, (std::array<int, 3>{1, 1, 1}));
    EXPECT_LT(*std::max_element(found.most_counts.begin(), found.most_counts.end()), 40);
    EXPECT_DOUBLE_EQ(*found.encoder_mm(), kCoarsestMmPerTick);
  }
}

TEST(FalconSelfTest, finds_the_delay_that_was_added) {
  const SelfTestResult none = measured({});
  ASSERT_TRUE(none.delay_ms());
  // The emulated firmware takes force and place together, and its answer is handed over a period later.
  EXPECT_NEAR(*none.delay_ms(), 1.0, 0.1);
  for (const LinkTime added : {LinkTime(1ms), LinkTime(2500us)}) {
    const SelfTestResult more = measured({.motor_delay = added});
    ASSERT_TRUE(more.delay_ms());
    const double added_ms = static_cast<double>(added.count()) * 1e-6;
    EXPECT_NEAR(*more.delay_ms() - *none.delay_ms(), added_ms, 0.1);  // measured off: 0.02 ms
  }
}

TEST(FalconSelfTest, ways_that_take_longer_by_chance_change_little) {
  const SelfTestResult found = measured({.damping_ns_per_m = 1.0}, {.jitter = 100us});
  ASSERT_TRUE(found.damping_ns_per_m());
  EXPECT_NEAR(*found.damping_ns_per_m(), 1.0, 0.1);
}

TEST(FalconSelfTest, a_grip_that_is_held_or_let_fall_ends_it_without_force) {
  TrialBench bench({});
  SelfTest trial;
  for (int i = 0; i < 2000; ++i) bench.push(trial.advance(bench.read()));
  ASSERT_EQ(trial.end(), TrialEnd::none);
  bench.body.set_hand_n({0.0, -8.0, 0.0});
  bench.run(trial);
  EXPECT_NE(trial.end(), TrialEnd::done);
  EXPECT_NE(trial.end(), TrialEnd::none);
  EXPECT_EQ(trial.advance(bench.read()), Vec3(0.0));
  EXPECT_FALSE(trial.result().damping_ns_per_m());
}

/// Wants one force whatever happens.
class Pusher final : public Trial {
 public:
  explicit Pusher(Vec3 n) : Trial(TrialBounds{}), n_(n) {}
  double share() const noexcept override { return 0; }

 private:
  Vec3 wanted(const TrialReading&, double) noexcept override { return n_; }
  Vec3 n_;
};

TEST(FalconTrial, keeps_its_bounds_whatever_is_wanted) {
  const TrialBounds bounds;
  Pusher hard(Vec3(100.0, 0.0, 0.0));
  Vec3 before(0.0);
  for (int i = 0; i < 100; ++i) {
    const Vec3 now = hard.advance({.t_s = i * 1e-3, .grip_m = kMiddleM});
    EXPECT_LE(glm::length(now - before), bounds.rise_n_s * 1e-3 + 1e-12);
    before = now;
  }
  EXPECT_NEAR(glm::length(before), bounds.max_n, 1e-9);

  Pusher broken{Vec3(std::numeric_limits<double>::quiet_NaN())};
  EXPECT_EQ(broken.advance({.t_s = 0, .grip_m = kMiddleM}), Vec3(0.0));
  EXPECT_EQ(broken.advance({.t_s = 1e-3, .grip_m = kMiddleM}), Vec3(0.0));
}

TEST(FalconTrial, ends_without_force_when_the_device_is_lost_silent_too_fast_or_at_its_end) {
  const auto after = [](auto change) {
    Pusher trial(Vec3(1.0));
    TrialReading reading{.grip_m = kMiddleM};
    for (int i = 0; i < 50; ++i) {
      reading.t_s += 1e-3;
      trial.advance(reading);
    }
    EXPECT_GT(glm::length(trial.force_n()), 0.5);
    for (int i = 0; i < 50 && trial.end() == TrialEnd::none; ++i) {
      reading.t_s += 1e-3;
      change(reading);
      trial.advance(reading);
    }
    EXPECT_EQ(trial.force_n(), Vec3(0.0));
    return trial.end();
  };
  EXPECT_EQ(after([](TrialReading& r) { r.gone = true; }), TrialEnd::device_lost);
  EXPECT_EQ(after([](TrialReading& r) { r.fresh = false; }), TrialEnd::device_lost);
  EXPECT_EQ(after([](TrialReading& r) { r.grip_m.x += 0.0015; }), TrialEnd::too_fast);
  EXPECT_EQ(after([](TrialReading& r) { r.grip_m.z = 0.060; }), TrialEnd::out_of_range);
  EXPECT_EQ(after([](TrialReading& r) { r.grip_m.x = std::numeric_limits<double>::quiet_NaN(); }), TrialEnd::out_of_range);
}

TEST(FalconMotionFit, fits_nothing_where_nothing_moved) {
  std::vector<MotionSample> still;
  for (int i = 0; i < 5000; ++i) still.push_back({i * 1e-3, 0.01, i % 20 < 10 ? 1.0 : -1.0});
  EXPECT_FALSE(fit_motion(still));
  EXPECT_FALSE(fit_motion({}));
  still.front().x_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(fit_motion(still));
}

TEST(FalconProfile, numbers_that_no_falcon_has_are_left_out) {
  FalconProfile good;
  good.calibration = {.trim_rad = Vec3(0.01, -0.02, 0.0), .counts_per_nm = 1e4, .force_gain = 1.2};
  good.gravity = {0.2, 0.003};
  good.damping_ns_per_m = 0.8;
  good.delay_ms = 1.5;
  const FalconSettings kept = settings_for(good, Vec3(1, 2, 3), 4);
  EXPECT_EQ(kept.calibration, good.calibration);
  EXPECT_EQ(kept.gravity, good.gravity);
  EXPECT_EQ(kept.damping_ns_per_m, 0.8);
  EXPECT_EQ(kept.delay_ms, 1.5);
  EXPECT_EQ(kept.burs, 4);
  EXPECT_EQ(kept.workspace.origin_mm, Vec3(1, 2, 3));

  const double nan = std::numeric_limits<double>::quiet_NaN();
  FalconProfile bad;
  bad.calibration = {.trim_rad = Vec3(nan), .counts_per_nm = 1e4, .force_gain = 100.0};
  bad.gravity = {-1.0, 0.0};
  bad.scale = 7.0;
  bad.damping_ns_per_m = nan;
  bad.delay_ms = -1.0;
  bad.encoder_mm = 1e9;
  const FalconSettings left = settings_for(bad);
  EXPECT_EQ(left.calibration, falcon::Calibration{});
  EXPECT_EQ(left.gravity, falcon::GravityCalibration{});
  EXPECT_EQ(left.workspace.scale, WorkspaceSettings{}.scale);
  EXPECT_FALSE(left.damping_ns_per_m || left.delay_ms || left.encoder_mm);
}

TEST(FalconProfile, a_clutch_takes_its_button_from_the_burs_and_a_centre_out_of_reach_is_left_out) {
  FalconProfile profile;
  EXPECT_EQ(settings_for(profile).buttons.clutch, status::kForward);
  profile.clutch = status::kPlus;
  EXPECT_EQ(settings_for(profile).buttons.clutch, status::kPlus);
  EXPECT_EQ(settings_for(profile).buttons.next_bur, 0);
  EXPECT_EQ(settings_for(profile).buttons.previous_bur, status::kMinus);
  profile.clutch = 0;
  EXPECT_EQ(settings_for(profile).buttons.clutch, 0);
  EXPECT_EQ(settings_for(profile).buttons.next_bur, status::kPlus);
  profile.clutch = status::kCentre;  // cuts, and nothing else
  EXPECT_EQ(settings_for(profile).buttons.clutch, status::kForward);
  profile.centre_m = Vec3(0.03, -0.03, 0.155);
  EXPECT_EQ(settings_for(profile).workspace.centre_m, profile.centre_m);
  profile.centre_m.x = 0.031;
  EXPECT_EQ(settings_for(profile).workspace.centre_m, WorkspaceSettings{}.centre_m);
  profile.centre_m.x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(settings_for(profile).workspace.centre_m, WorkspaceSettings{}.centre_m);
}

}  // namespace
}  // namespace cusp::device::falcon
