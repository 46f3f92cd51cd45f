// The drilling sound as samples.
#include "tests/modules.h"
#include "ui/sound/drill_synth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "scenarios/tissues/tissue_facts.h"

namespace cusp::test {
namespace {

constexpr double kRate = 48000.0;

std::vector<float> heard(const DrillHeard& what, double seconds = 0.5, double rate = kRate) {
  DrillSynth synth(rate);
  synth.follow(what);
  std::vector<float> settle(static_cast<std::size_t>(rate / 4)), out(static_cast<std::size_t>(seconds * rate));
  synth.render(settle);
  synth.render(out);
  return out;
}
double loud(const std::vector<float>& samples) {
  double sum = 0;
  for (const float s : samples) sum += static_cast<double>(s) * static_cast<double>(s);
  return std::sqrt(sum / static_cast<double>(samples.size()));
}
/// Share of the sound's power at one pitch (Goertzel).
double at_pitch(const std::vector<float>& samples, double hz, double rate = kRate) {
  double re = 0, im = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double a = 6.283185307179586 * hz * static_cast<double>(i) / rate;
    re += static_cast<double>(samples[i]) * std::cos(a);
    im += static_cast<double>(samples[i]) * std::sin(a);
  }
  const double n = static_cast<double>(samples.size());
  const double power = loud(samples) * loud(samples);
  return power > 0 ? 2.0 * (re * re + im * im) / (n * n) / power : 0.0;
}
/// Of a tone: how often a second it rises through zero.
double pitch_hz(const std::vector<float>& samples, double rate) {
  int rises = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (samples[i - 1] < 0.0f && samples[i] >= 0.0f) ++rises;
  return rises * rate / static_cast<double>(samples.size());
}

DrillHeard spinning(double rpm, double share = 1.0) { return {rpm / 60.0, share, 0.0, 1600.0, 0.0}; }
DrillHeard cutting(Tissue tissue, double work = 1.0) {
  return {3500.0, 0.6, work, tissue_facts(tissue).tone_hz.value, tissue_facts(tissue).loudness.value};
}

TEST(DrillSynth, is_silent_at_a_stand) {
  EXPECT_EQ(loud(heard({})), 0.0);
  EXPECT_EQ(loud(heard({0.0, 0.0, 1.0, 4000.0, 1.0})), 0.0) << "a bur that stands makes no noise, however hard it is pushed";
}

TEST(DrillSynth, the_whine_has_the_spindles_true_pitch) {
  for (const double rpm : {350e3, 210e3, 200e3, 40e3}) {
    EXPECT_GT(at_pitch(heard(spinning(rpm)), rpm / 60.0), 0.8) << rpm;
    EXPECT_LT(at_pitch(heard(spinning(rpm)), 1.3 * rpm / 60.0), 0.01) << rpm;
  }
}

TEST(DrillSynth, the_whine_has_the_same_pitch_at_any_rate_of_the_output) {
  // One rise more or fewer in half a second is 2 Hz.
  for (const double rate : {4000.0, 8000.0, 44100.0, 96000.0, 192000.0, 352800.0, 384000.0, 768000.0})
    EXPECT_NEAR(pitch_hz(heard(spinning(40e3), 0.5, rate), rate), 40e3 / 60.0, 2.1) << rate;
}

TEST(DrillSynth, a_pitch_beyond_what_the_rate_holds_does_not_fold_to_a_false_one) {
  // 350,000 a minute are 5833 Hz, more than samples at 8 kHz can hold: it stays at their highest note.
  EXPECT_GT(at_pitch(heard(spinning(350e3), 0.5, 8000.0), 3600.0, 8000.0), 0.9);
  EXPECT_LT(at_pitch(heard(spinning(350e3), 0.5, 8000.0), 8000.0 - 5833.3, 8000.0), 0.01);
}

TEST(DrillSynth, cutting_is_louder_than_turning_in_the_air_and_more_load_louder_still) {
  const double air = loud(heard(cutting(Tissue::enamel, 0.0))), light = loud(heard(cutting(Tissue::enamel, 0.3))),
               hard = loud(heard(cutting(Tissue::enamel, 1.0)));
  EXPECT_GT(light, 1.05 * air);
  EXPECT_GT(hard, 1.3 * light);
}

TEST(DrillSynth, cutting_is_as_loud_at_any_rate_of_the_output) {
  DrillHeard noise = cutting(Tissue::enamel);
  noise.turns_per_s = 0.0;  // without whine and growl, whose loudness no rate changes
  const double usual = loud(heard(noise, 2.0));
  // 0.92, 0.89 and 0.88 by the filter's impulse responses: near the rate's end it is a little wider.
  for (const double rate : {96000.0, 192000.0, 384000.0}) EXPECT_NEAR(loud(heard(noise, 2.0, rate)) / usual, 1.0, 0.2) << rate;
}

TEST(DrillSynth, enamel_sounds_louder_and_higher_than_dentine_and_dentine_than_caries) {
  const auto enamel = heard(cutting(Tissue::enamel)), dentine = heard(cutting(Tissue::dentine)),
             caries = heard(cutting(Tissue::carious_dentine));
  EXPECT_GT(loud(enamel), loud(dentine));
  EXPECT_GT(loud(dentine), loud(caries));
  const auto power = [](const std::vector<float>& samples, double from, double to) {
    double sum = 0;
    for (double hz = from; hz < to; hz += 20.0) sum += at_pitch(samples, hz);
    return sum;
  };
  // The noise about its middle, against that an octave and more below; the whine lies between and is left out.
  EXPECT_GT(power(enamel, 3800, 5200) / power(enamel, 600, 1600), 2.0 * power(caries, 3800, 5200) / power(caries, 600, 1600));
}

TEST(DrillSynth, glides_and_never_clicks) {
  DrillSynth synth(kRate);
  float before = 0;
  double most = 0;
  for (int part = 0; part < 200; ++part) {
    synth.follow(part % 2 == 0 ? cutting(Tissue::pulp, 0.0) : spinning(60.0 * 200.0));
    std::vector<float> out(480);
    synth.render(out);
    for (const float s : out) {
      most = std::max(most, std::abs(static_cast<double>(s - before)));
      before = s;
    }
  }
  EXPECT_LT(most, 0.12);  // the whine itself moves so much from sample to sample: 0.1 * 2 pi * 3500 / 48000 = 0.05
}

TEST(DrillSynth, stays_within_its_bounds_and_is_a_number_whatever_it_gets) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  DrillSynth synth(kRate);
  for (const double bad : {nan, inf, -inf, -1.0, 1e300}) {
    for (int field = 0; field < 5; ++field) {
      DrillHeard what = cutting(Tissue::enamel);
      double* const fields[] = {&what.turns_per_s, &what.speed_share, &what.work, &what.tone_hz, &what.loudness};
      *fields[field] = bad;
      synth.follow(what);
      std::vector<float> out(4800);
      synth.render(out);
      for (const float s : out) ASSERT_LE(std::abs(s), 1.0f) << bad << ' ' << field;
    }
  }
  synth.follow(spinning(350e3));
  std::vector<float> out(48000);
  synth.render(out);
  EXPECT_GT(loud(out), 0.0) << "it has not gone silent for ever";
  for (const double rate : {nan, 0.0, -1.0, 1e9}) {
    DrillSynth odd(rate);
    odd.follow(cutting(Tissue::enamel));
    odd.render(out);
    for (const float s : out) ASSERT_LE(std::abs(s), 1.0f) << rate;
  }
}

TEST(DrillHeard, follows_speed_load_and_tissue_of_the_loop) {
  Scene scene;
  scene.phenomena.handpiece = Handpiece::turbine;
  StepOutput out;
  out.spindle_rpm = 210e3f;
  EXPECT_NEAR(heard_of(out, scene).turns_per_s, 3500.0, 0.01);
  EXPECT_NEAR(heard_of(out, scene).speed_share, 0.6, 1e-6);
  EXPECT_EQ(heard_of(out, scene).work, 0.0);
  out.contact = true;
  out.tissue = Tissue::enamel;
  out.force_raw_n = Vec3(0.0, 0.3, 0.4);
  EXPECT_NEAR(heard_of(out, scene).work, 0.5, 1e-12);
  EXPECT_EQ(heard_of(out, scene).tone_hz, tissue_facts(Tissue::enamel).tone_hz.value);
  out.spindle_rpm = 0.0f;
  EXPECT_EQ(heard_of(out, scene).work, 0.0) << "stalled";
  scene.phenomena.handpiece = Handpiece::none;
  out.spindle_rpm = 210e3f;
  EXPECT_EQ(heard_of(out, scene).turns_per_s, 0.0);
}

}  // namespace
}  // namespace cusp::test
