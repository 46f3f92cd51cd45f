// The felt wave by itself.
#include "engine/removal/vibration.h"
#include "tests/modules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace cusp::test {
namespace {

constexpr double kWaveTickS = 0.001;
constexpr SpindleSettings kWaveTurbine = settings_of(Handpiece::turbine);

std::vector<double> wave(double rpm, double push_n, double hardness, int ticks, double dt_s = kWaveTickS) {
  VibrationState state;
  std::vector<double> out;
  for (int k = 0; k < ticks; ++k) out.push_back(vibration_n(state, kWaveTurbine, rpm, push_n, hardness, dt_s));
  return out;
}
double most_of(const std::vector<double>& values) {
  double most = 0.0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}
/// Upward crossings of zero.
int beats(const std::vector<double>& values) {
  int count = 0;
  for (std::size_t k = 1; k < values.size(); ++k) count += values[k - 1] < 0.0 && values[k] >= 0.0 ? 1 : 0;
  return count;
}

TEST(Vibration, the_polynomial_is_a_sine_within_four_millionths_and_never_above_one) {
  double worst = 0.0;
  for (std::uint64_t phase = 0; phase < 4294967296ull; phase += 65537) {
    const double sine = sine_of(static_cast<std::uint32_t>(phase));
    ASSERT_LE(std::abs(sine), 1.0);
    worst = std::max(worst, std::abs(sine - std::sin(6.283185307179586 * static_cast<double>(phase) / 4294967296.0)));
  }
  EXPECT_LT(worst, 4e-6);  // 3.6e-6 by the series' next term, (pi/2)^11/11!
  EXPECT_GT(worst, 1e-6);
}

TEST(Vibration, felt_turns_are_so_rare_that_four_samples_make_a_wave) {
  EXPECT_EQ(subharmonic_of(kWaveTurbine), 24);                          // 5833 Hz / 24 = 243 Hz
  EXPECT_EQ(subharmonic_of(settings_of(Handpiece::electric)), 14);  // 3333 Hz / 14 = 238 Hz
  EXPECT_EQ(subharmonic_of(settings_of(Handpiece::slow)), 3);       // 667 Hz / 3 = 222 Hz
  EXPECT_EQ(subharmonic_of(settings_of(Handpiece::none)), 1);
}

TEST(Vibration, the_beat_follows_the_speed_and_is_never_a_false_slow_one) {
  for (const double rpm : {350e3, 210e3, 120e3, 80e3}) {
    EXPECT_NEAR(beats(wave(rpm, 1.0, 1.0, 4000)), 4.0 * rpm / 60.0 / 24.0, 2.0) << rpm;
  }
}

TEST(Vibration, sampled_as_it_is_the_true_pitch_would_have_come_out_as_another_one) {
  // What the subharmonic is for: 210,000 rpm are 3500 Hz, of which every sample at 1 kHz sees the same half wave.
  int turns = 0;
  double before = -1.0;
  for (int k = 0; k < 4000; ++k) {
    const double now = std::sin(6.283185307179586 * (3500.3 * kWaveTickS * k));
    turns += before < 0.0 && now >= 0.0 ? 1 : 0;
    before = now;
  }
  EXPECT_LT(turns, 4 * 600) << "four seconds of 3500 Hz are 14001 waves";
}

TEST(Vibration, is_never_above_60_mN_nor_above_a_tenth_of_the_push) {
  EXPECT_LE(most_of(wave(350e3, 100.0, 1.0, 4000)), kMostVibrationN);
  EXPECT_GT(most_of(wave(350e3, 100.0, 1.0, 4000)), 0.95 * kMostVibrationN);
  EXPECT_LE(most_of(wave(350e3, 0.05, 1.0, 4000)), kMostVibrationShare * 0.05);
}

TEST(Vibration, grows_with_load_and_with_the_hardness_of_what_is_cut) {
  EXPECT_NEAR(most_of(wave(350e3, 0.5, 1.0, 4000)) / most_of(wave(350e3, 1.0, 1.0, 4000)), 0.5, 1e-9);
  EXPECT_NEAR(most_of(wave(350e3, 1.0, 0.25, 4000)) / most_of(wave(350e3, 1.0, 1.0, 4000)), 0.25, 1e-9);
  EXPECT_EQ(most_of(wave(350e3, 0.0, 1.0, 100)), 0.0) << "in the air";
  EXPECT_EQ(most_of(wave(0.0, 1.0, 1.0, 100)), 0.0) << "at a stand";
}

TEST(Vibration, averages_out) {
  double sum = 0.0;
  for (const double v : wave(300e3, 1.0, 1.0, 10000)) sum += v;
  EXPECT_LT(std::abs(sum / 10000.0), 1e-5);
}

TEST(Vibration, fades_out_before_slow_ticks_could_fold_it) {
  EXPECT_GT(most_of(wave(350e3, 1.0, 1.0, 1000, 0.001)), 0.05);
  const double slower = most_of(wave(350e3, 1.0, 1.0, 1000, 0.0015));  // 0.365 turns a tick
  EXPECT_GT(slower, 0.02);
  EXPECT_LT(slower, 0.035);
  EXPECT_EQ(most_of(wave(350e3, 1.0, 1.0, 1000, 0.004)), 0.0);
}

TEST(Vibration, values_that_are_no_numbers_give_a_bounded_force) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, -1.0, 1e300}) {
    EXPECT_LE(most_of(wave(bad, 1.0, 1.0, 10)), kMostVibrationN) << bad;
    EXPECT_LE(most_of(wave(350e3, bad, 1.0, 10)), kMostVibrationN) << bad;
    EXPECT_LE(most_of(wave(350e3, 1.0, bad, 10)), kMostVibrationN) << bad;
    EXPECT_LE(most_of(wave(350e3, 1.0, 1.0, 10, bad)), kMostVibrationN) << bad;
  }
}

}  // namespace
}  // namespace cusp::test
