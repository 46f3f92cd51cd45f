#include "ui/sound/drill_synth.h"

#include <algorithm>
#include <cmath>

#include "engine/removal/spindle.h"
#include "scenarios/tissues/tissue_facts.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

constexpr double kTau = 6.283185307179586;
constexpr double kUsualRateHz = 48000.0;  // kNoise is meant for it
constexpr double kGlideS = 0.02;
constexpr double kUsualPushN = 1.0;
// Shares of full scale.
constexpr double kWhine = 0.10, kOvertone = 0.04, kNoise = 0.35, kGrowl = 0.12;
constexpr double kGrowlDivisor = 24.0;  // a beat of the loaded bearing, far below the whine
// Of the sample rate.
constexpr double kMostPitchShare = 0.45, kMostToneShare = 0.15;
constexpr double kLeastToneHz = 50.0;

double within(double value, double low, double high) noexcept {
  return value > low ? (value < high ? value : high) : low;
}

}  // namespace

DrillHeard heard_of(const StepOutput& output, const Scene& scene) noexcept {
  DrillHeard out;
  const SpindleSettings spindle = settings_of(scene.phenomena.handpiece);
  if (!(spindle.free_rpm > 0.0)) return out;
  out.turns_per_s = static_cast<double>(output.spindle_rpm) / 60.0;
  out.speed_share = static_cast<double>(output.spindle_rpm) / spindle.free_rpm;
  if (!output.contact || output.faulted || !(output.spindle_rpm > 0.0f)) return out;
  const TissueFacts& facts = tissue_facts(output.tissue);
  const Vec3 f = output.force_raw_n;
  out.work = std::min(1.0, std::sqrt(f.x * f.x + f.y * f.y + f.z * f.z) / kUsualPushN);
  out.tone_hz = facts.tone_hz.value;
  out.loudness = facts.loudness.value;
  return out;
}

DrillSynth::DrillSynth(double sample_rate_hz) noexcept
    : rate_hz_(std::isfinite(sample_rate_hz) && sample_rate_hz > 0.0 ? sample_rate_hz : kUsualRateHz),
      noise_share_(kNoise * std::sqrt(rate_hz_ / kUsualRateHz)) {
  wanted_.tone_hz = now_.tone_hz = std::min(now_.tone_hz, kMostToneShare * rate_hz_);  // beyond, the noise's filter is unstable
}

void DrillSynth::follow(const DrillHeard& heard) noexcept {
  wanted_.turns_per_s = within(heard.turns_per_s, 0.0, kMostPitchShare * rate_hz_);
  wanted_.speed_share = within(heard.speed_share, 0.0, 1.0);
  wanted_.work = within(heard.work, 0.0, 1.0);
  const double most_tone_hz = kMostToneShare * rate_hz_;
  wanted_.tone_hz = within(heard.tone_hz, std::min(kLeastToneHz, most_tone_hz), most_tone_hz);
  wanted_.loudness = within(heard.loudness, 0.0, 1.0);
}

void DrillSynth::render(std::span<float> out) noexcept {
  const double glide = 1.0 - std::exp(-1.0 / (kGlideS * rate_hz_));
  const auto approach = [glide](double& now, double wanted) { now += (wanted - now) * glide; };
  for (float& sample : out) {
    approach(now_.turns_per_s, wanted_.turns_per_s);
    approach(now_.speed_share, wanted_.speed_share);
    approach(now_.work, wanted_.work);
    approach(now_.tone_hz, wanted_.tone_hz);
    approach(now_.loudness, wanted_.loudness);

    phase_ += now_.turns_per_s / rate_hz_;
    phase_ -= std::floor(phase_);
    growl_phase_ += now_.turns_per_s / kGrowlDivisor / rate_hz_;
    growl_phase_ -= std::floor(growl_phase_);
    double value = kWhine * now_.speed_share * std::sin(kTau * phase_);
    // An overtone beyond what the rate holds would fold back as another note.
    if (2.0 * now_.turns_per_s < kMostPitchShare * rate_hz_) value += kOvertone * now_.speed_share * std::sin(2.0 * kTau * phase_);
    value += kGrowl * now_.work * now_.speed_share * std::sin(kTau * growl_phase_);

    noise_ ^= noise_ << 13;
    noise_ ^= noise_ >> 17;
    noise_ ^= noise_ << 5;
    const double white = static_cast<double>(static_cast<std::int32_t>(noise_)) / 2147483648.0;
    // State-variable band pass, one octave wide.
    const double f = 2.0 * std::sin(kTau / 2.0 * now_.tone_hz / rate_hz_);
    low_ += f * band_;
    band_ += f * (white - low_ - 0.7 * band_);
    value += noise_share_ * now_.work * now_.loudness * now_.speed_share * band_;
    sample = static_cast<float>(within(value, -1.0, 1.0));
  }
}

}  // namespace cusp::ui
