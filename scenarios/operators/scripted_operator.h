/// A simulated student: follows a plan by the forces that it feels.
/// It wants a velocity along the stroke. The part against the felt force becomes a push in proportion, the rest a slide
/// along the face, so that a ball bur neither climbs out nor digs in.
/// If the bur is held (a ledge stops the neck), the operator retracts it and sets it down further along the stroke; if
/// that fails too, it skips the stroke. With a handpiece that slows under load it pushes lightly and releases a stall.
/// It ends after OperatorStyle::max_s at the latest. Deterministic by its seed. Thread: the one that plays.
#pragma once

#include <array>

#include "engine/base/haptic_port.h"
#include "engine/lab/hand_model.h"
#include "engine/step/step.h"
#include "scenarios/modules.h"
#include "scenarios/operators/plan.h"

namespace cusp::scenarios {

struct OperatorStyle {
  HandSettings muscles;
  double feed = 0.95;              // while cutting, of the speed at which the felt tissue gives way to the full force
  double correct_per_s = 8.0;      // speed back to the stroke's line, for each mm off it
  double side_push_n = 1.5;        // hardest push sideways
  double travel_mm_s = 15.0;       // free movement
  double approach_mm_s = 4.0;      // with the bur turning, nothing touched
  double arrive_mm = 0.01;         // a cutting stroke is done this near to its end
  double wander_mm = 0.06;         // this far off the line the bur hardly goes on along it
  double blunt_mm = 0.002;         // a force over less than this has no sure direction
  double feel_s = 0.004;           // how long it feels for a force's direction
  double patience_s = 2.0;         // without progress: reposition further on, in the end skip the stroke
  double max_s = 3600.0;           // of the whole attempt
  bool light = true;               // pushes no harder than removes most, releases a stalled handpiece
  bool coolant = true;             // runs it, where the exercise reckons heat
};

/// The share of the tissues' speeds at which a light operator drills with the exercise's handpiece and that bur; 1 without one.
[[nodiscard]] double light_speed_share(const Scenario& scenario, std::uint16_t bur) noexcept;

class ScriptedOperator {
 public:
  /// Takes from the scenario what the tissues feel like and the full force.
  ScriptedOperator(Plan plan, const OperatorStyle& style, const Scenario& scenario);
  /// The device's next sample, `dt_s` after `last`. Pre: 0 < dt_s <= 0.05. Reads proxy, force_n, contact and
  /// stiffness_n_per_mm of `last`.
  Sample next(const StepOutput& last, double dt_s);
  /// Every stroke is finished or skipped, or the time is up.
  bool done() const noexcept { return stroke_ >= plan_.strokes.size() || clock_s_ > style_.max_s; }
  /// Where the device must be before the first step.
  Vec3 start_mm() const noexcept { return plan_.start_mm; }
  const Plan& plan() const noexcept { return plan_; }
  std::size_t strokes_skipped() const noexcept { return skipped_; }
  double clock_s() const noexcept { return clock_s_; }

 private:
  /// Retracts above `proxy` and sets down on the rest of the stroke. False: the stroke has no rest, or no tries left.
  bool reposition(Vec3 proxy) noexcept;
  const Stroke& now() const noexcept {
    return reposition_step_ < kRepositionSteps ? reposition_path_[reposition_step_] : plan_.strokes[stroke_];
  }
  void turn_to(std::size_t stroke, Vec3 from) noexcept;
  void begin(Vec3 from) noexcept;
  /// Stiffness and speed of the tissue that feels like this.
  const TissueFeel& feel(double stiffness_n_per_mm) const noexcept;
  Vec3 wanted(const StepOutput& last, double dt_s) noexcept;
  bool arrived(Vec3 proxy) const noexcept;
  /// The bur has climbed out of its line.
  bool slipped(Vec3 proxy) const noexcept;
  /// Share of this stroke's speed that the next one goes on with: 1 straight on, 0 round a corner.
  double carried_on() const noexcept;

  Plan plan_;
  OperatorStyle style_;
  HandModel muscles_;
  std::vector<TissueFeel> feels_;
  double full_force_n_;
  double radius_mm_;  // of the bur's head
  double hardest_push_n_;  // whatever holds it
  bool coolant_;
  static constexpr std::size_t kRepositionSteps = 3;  // up, over, down
  std::size_t stroke_ = 0, skipped_ = 0;
  std::array<Stroke, kRepositionSteps> reposition_path_;
  std::size_t reposition_step_ = kRepositionSteps;  // kRepositionSteps: on the stroke itself
  std::size_t repositions_ = 0;                     // on this stroke
  Vec3 from_mm_;
  Vec3 felt_{0.0};  // direction against the force, about a unit; 0 while nothing is touched
  double lag_s_;  // of the muscles: the wanted place leads a free movement by this
  double clock_s_ = 0;
  double least_left_mm_ = 0, since_s_ = 0;
};

}  // namespace cusp::scenarios
