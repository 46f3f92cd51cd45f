/// The drilling sound as samples: the whine of the spindle at its true pitch, and the hiss and growl of what is cut.
/// No Qt, no device. Thread: whichever renders; no heap, no lock in render(). Figures are [M], but for the pitch.
#pragma once

#include <cstdint>
#include <span>

#include "engine/step/step.h"
#include "ui/modules.h"

namespace cusp::ui {

/// What there is to hear. Plain values; safe to copy between threads.
struct DrillHeard {
  double turns_per_s = 0;  // of the spindle: the pitch
  double speed_share = 0;  // of its free speed, [0, 1]: the whine's loudness
  double work = 0;         // of the usual load of 1 N, [0, 1]; 0 where nothing is cut
  double tone_hz = 1600;   // middle of the cutting noise: of the tissue (scenarios/tissues)
  double loudness = 0;     // of that noise: of the tissue, [0, 1]
};

/// From the loop's newest output. Silent where the scene has no handpiece.
DrillHeard heard_of(const StepOutput& output, const Scene& scene) noexcept;

class DrillSynth {
 public:
  /// As the output gives it: the pitch is right at any. What is no rate counts as 48000.
  explicit DrillSynth(double sample_rate_hz) noexcept;

  /// What is to be heard from the next sample on; values glide there in some 20 ms, so that nothing clicks. What is no
  /// number counts as silence.
  void follow(const DrillHeard& heard) noexcept;
  /// Mono, within [-1, 1].
  void render(std::span<float> out) noexcept;

 private:
  double rate_hz_;
  double noise_share_;  // of full scale; white noise spreads its power over half the rate, and the filter lets one octave pass
  DrillHeard wanted_, now_;
  double phase_ = 0, growl_phase_ = 0;  // turns
  double low_ = 0, band_ = 0;           // of the noise's filter
  std::uint32_t noise_ = 0x9e3779b9u;
};

}  // namespace cusp::ui
