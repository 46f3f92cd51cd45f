/// A scripted student: follows a plan by what it feels. It asks for a push towards the next place, waits until the burr
/// gets there (tissue limits it), gives up a stroke that is blocked, and stops after a bounded time.
/// Deterministic by its seed. Thread: the one that plays.
#pragma once

#include "engine/base/haptic_port.h"
#include "engine/lab/hand_model.h"
#include "engine/step/step.h"
#include "scenarios/hands/plan.h"

namespace cusp {

struct HandStyle {
  HandSettings muscles;
  double push_n = 1.4;             // while cutting; more than the scene's full force cuts no faster
  double travel_mm_s = 15.0;       // free movement
  double arrive_mm = 0.01;         // a cutting stroke is done this near to its end
  double patience_s = 3.0;         // without 0.02 mm of progress: leave the stroke
  double most_s = 900.0;           // of the whole go
};

class Hand {
 public:
  /// `softest_n_per_mm`: stiffness to expect before anything is touched.
  Hand(Plan plan, const HandStyle& style, double softest_n_per_mm);
  /// The device's next sample, `dt_s` after `last` was answered. 0 < dt_s <= 0.05.
  Sample next(const StepOutput& last, double dt_s);
  /// The plan is through, or the time is.
  bool done() const noexcept { return stroke_ >= plan_.strokes.size() || clock_s_ > style_.most_s; }
  /// Where the device must be before the first step.
  Vec3 start_mm() const noexcept { return plan_.start_mm; }
  std::size_t strokes_left_out() const noexcept { return given_up_; }
  double clock_s() const noexcept { return clock_s_; }

 private:
  void enter(std::size_t stroke, Vec3 from) noexcept;
  bool arrived(Vec3 proxy) const noexcept;

  Plan plan_;
  HandStyle style_;
  HandModel muscles_;
  double softest_;
  std::size_t stroke_ = 0, given_up_ = 0;
  Vec3 from_mm_, intent_mm_;
  double clock_s_ = 0, stroke_s_ = 0, best_left_mm_ = 0, best_at_s_ = 0;
};

}  // namespace cusp
