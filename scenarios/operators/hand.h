/// A scripted student: follows a plan by what it feels. It wants the bur to move along the stroke at a speed; what of
/// that speed points against the felt force is a push in proportion (the tissue gives way to it), the rest is a movement
/// along the face that it slides on. So a ball neither climbs over what it is to cut nor digs in. It waits until the bur
/// gets there. Where it is held (a ledge stops the neck) it lifts the bur out and sets it down a little further on along
/// the stroke; what that does not help either it gives up. With a handpiece that slows under load it is light, and lets up
/// where it may have stalled. It stops after a bounded time.
/// Deterministic by its seed. Thread: the one that plays.
#pragma once

#include <array>

#include "engine/base/haptic_port.h"
#include "engine/lab/hand_model.h"
#include "engine/step/step.h"
#include "scenarios/modules.h"
#include "scenarios/operators/plan.h"

namespace cusp::scenarios {

struct HandStyle {
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
  double patience_s = 2.0;         // without progress: set down anew further on, in the end leave the stroke
  double most_s = 3600.0;          // of the whole go
  bool light = true;               // hears its handpiece: pushes no harder than removes most, lets up where it stands
  bool coolant = true;             // runs it, where the exercise reckons heat
};

/// The share of the tissues' speeds at which a light hand drills with the exercise's handpiece and that bur; 1 without one.
[[nodiscard]] double light_speed_share(const Scenario& scenario, std::uint16_t bur) noexcept;

class Hand {
 public:
  /// Takes from the scenario what the tissues feel like and the full force.
  Hand(Plan plan, const HandStyle& style, const Scenario& scenario);
  /// The device's next sample, `dt_s` after `last` was answered. 0 < dt_s <= 0.05. Of `last` it feels proxy, force_n,
  /// contact and stiffness_n_per_mm.
  Sample next(const StepOutput& last, double dt_s);
  /// The plan is through, or the time is.
  bool done() const noexcept { return stroke_ >= plan_.strokes.size() || clock_s_ > style_.most_s; }
  /// Where the device must be before the first step.
  Vec3 start_mm() const noexcept { return plan_.start_mm; }
  const Plan& plan() const noexcept { return plan_; }
  std::size_t strokes_left_out() const noexcept { return given_up_; }
  std::size_t strokes_done() const noexcept { return stroke_; }
  double clock_s() const noexcept { return clock_s_; }

 private:
  /// Lifts out above `proxy` and comes down again on what is left of the stroke. False: it has been tried often enough.
  bool set_down_anew(Vec3 proxy) noexcept;
  const Stroke& now() const noexcept { return anew_ < kAnew ? way_anew_[anew_] : plan_.strokes[stroke_]; }
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
  HandStyle style_;
  HandModel muscles_;
  std::vector<TissueFeel> feels_;
  double full_force_n_;
  double radius_mm_;  // of the bur's head
  double hardest_push_n_;  // whatever holds it
  bool coolant_;
  static constexpr std::size_t kAnew = 3;  // up, over, down
  std::size_t stroke_ = 0, given_up_ = 0;
  std::array<Stroke, kAnew> way_anew_;
  std::size_t anew_ = kAnew;     // of them; kAnew: on the stroke itself
  std::size_t times_anew_ = 0;   // on this stroke
  Vec3 from_mm_;
  Vec3 felt_{0.0};  // direction against the force, about a unit; 0 while nothing is touched
  double lag_s_;  // of the muscles: by so much what is wanted runs ahead of a free movement
  double clock_s_ = 0;
  double least_left_mm_ = 0, since_s_ = 0;
};

}  // namespace cusp::scenarios
