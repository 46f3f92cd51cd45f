/// A cut that is held while an attempt stands, or under a question, counts for nothing until it was released. Otherwise a button that
/// stays pressed over a loss or a pause, or a foot on the pedal, would cut from where the device is found again, at full speed, while
/// the force that the hand would feel still ramps in. Pure; one thread.
#pragma once

#include "engine/base/haptic_port.h"
#include "engine/step/input.h"
#include "ui/modules.h"

namespace cusp::ui {

class HeldCut {
 public:
  enum class Attempt : std::uint8_t { runs, stands };

  /// Each sample of the device in order, before the loop reads it.
  void take(Sample& sample, Attempt attempt) noexcept {
    const bool pressed = (sample.buttons & StepInput::kCut) != 0 || sample.pedal > 0;  // a handpiece turns by the pedal alone
    if (!pressed || attempt == Attempt::stands) held_ = pressed;
    if (!held_) return;
    sample.buttons &= static_cast<std::uint16_t>(~StepInput::kCut);
    sample.pedal = 0;
  }

  /// Whether the cut of the newest sample counts for nothing.
  bool ignores() const noexcept { return held_; }

 private:
  bool held_ = false;
};

}  // namespace cusp::ui
