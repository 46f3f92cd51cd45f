/// A run of `stability`: a method (behind its guard, or without) and the exact proxy of the same shape at the same
/// device points, tick by tick; the device point led, or in the laboratory's closed loop with a hand.
#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/lab/closed_loop.h"
#include "engine/lab/measures.h"
#include "engine/step/step.h"
#include "tests/bench/motions.h"
#include "tests/bench/options.h"
#include "tests/bench/rows.h"
#include "tests/bench/shapes.h"
#include "tests/modules.h"

namespace cusp::bench {

inline constexpr double kStabilityNPerMm = 1.0;  // K of all tissue, unless a case has its own

/// scene_of with the guard as a session has it, or with every part of it off.
std::shared_ptr<Scene> stability_scene(const Shape& shape, Method method, double voxel_mm, GuardUse guard,
                                       double delay_ms = 0.0);

/// A device and the hand in front of it.
struct Setting {
  double mass_kg = 0.1, damping_ns_per_m = 2.0, friction_n = 0.0, delay_ms = 0.0;
  /// none, soft, firm; scripted: the device point is led, no hand and no device are in the loop.
  std::string_view grip = "scripted";
  bool weighs = false;  // gravity pulls at the device

  bool in_loop() const { return grip != "scripted"; }
  lab::DeviceSettings device() const;  // falcon's encoder, force quantum and limit
  lab::Grip hand() const;
  lab::TransportSettings transport(std::uint64_t seed) const;
};
/// Sets device, grip, mass, damping, friction and delay.
void name_setting(Row& row, const Setting& setting);
/// "m0.1-b2": kilograms, N s/m.
std::string device_name(double mass_kg, double damping_ns_per_m);

/// What was met in the runs of one row.
class Tally {
 public:
  /// A run begins.
  void begin();
  /// A tick. exact_n: force of the exact proxy. clearance_mm: exact, of the bur at the method's proxy. vanished: the
  /// exact minimum ceased to be in it. near_mm: as far as this from the exact proxy the method stands with it.
  ///
  /// Where an exact minimum vanishes, both go on to another face, and the method may do so a little sooner or later:
  /// the ticks in which they stand apart for that (kSooner before, kLater after at most) are a first contact, no force
  /// step.
  struct Contact {
    Vec3 exact_n{0.0};
    double clearance_mm = 0.0;
    double bur_radius_mm = 0.0;
    double near_mm = 0.0;
  };
  void add(const StepOutput& out, const Exact& exact, const Contact& contact);
  static constexpr int kSooner = 50, kLater = 100;
  /// Of a tick that add() was not told of: what the hand got.
  void add_force(const StepOutput& out);
  /// The method's pivot stands where only a way through tissue leads.
  void mark_passed() { through_ = true; }
  /// A swap, a re-arm: the next rise is none.
  void interrupt();
  void add_loop(const lab::LoopTick& tick);
  void add_exact_loop(const lab::LoopTick& tick);
  void add_rest(const lab::Steadiness& steady);
  void add_exact_rest(const lab::Steadiness& steady);
  /// The run is over.
  void end();

  void fill(Row& row);

 private:
  /// What a force step is taken from. skip: no step to here; ends: none from here.
  struct Moment {
    Vec3 force_n{0.0}, exact_n{0.0};
    bool acted = false, apart = false, vanished = false, skip = false, ends = false;
  };
  void note_stuck();
  void note_steps();

  std::vector<Moment> run_;
  lab::ForceSteps steps_;
  lab::StuckWatch stuck_;
  lab::Penetration penetration_;
  lab::ContactEnergy energy_, exact_energy_, left_, exact_left_;
  std::vector<double> step_mn_;
  std::int64_t ticks_ = 0, runs_ = 0, passed_ = 0, stuck_runs_ = 0;
  int stuck_ms_ = 0;
  double force_max_n_ = 0.0, run_late_mj_ = 0.0, late_mj_ = 0.0;
  double energy_mj_ = kAbsent, exact_energy_mj_ = kAbsent, left_mj_ = kAbsent, exact_left_mj_ = kAbsent, cycle_um_ = kAbsent, cycle_hz_ = kAbsent,
         exact_cycle_um_ = kAbsent;
  bool through_ = false, was_stuck_ = false;
};

/// How long a method has been stuck: behind the exact proxy for 50 ms, not merely late by some after it jumped. The
/// watch looks 50 ms back, and so counts the 49 before a jump as well. 0: not stuck.
int stuck_for_ms(const lab::StuckWatch& watch);
int stuck_for_ms(int watched_ms);

/// A method and its exact proxy side by side.
class Pair {
 public:
  /// Pre: the shape outlives it.
  Pair(const Shape& shape, std::shared_ptr<const Scene> scene);

  StepState& state() { return state_; }
  Truth& truth() { return *truth_; }
  double bur_radius_mm() const { return radius_mm_; }

  /// Both stand at an admissible centre, clear of everything, with the guard's ramp behind them.
  void bring(Vec3 centre);
  /// Another exact proxy, which starts where the one before stood (a cut, an exchange).
  void replace(std::unique_ptr<Truth> truth, double bur_radius_mm);
  /// The input, with a re-arm where a fault has lasted for kRearmTicks.
  StepInput rearmed(StepInput input);
  /// A step, and a move of the exact proxy, into the tally. Where the exact minimum vanishes, the ticks until the
  /// method stands with the new one again (100 at most) are a first contact, and no force step.
  StepOutput tick(const StepInput& input, Tally& tally);
  /// Force of the exact proxy in the last tick.
  Vec3 exact_n() const { return exact_n_; }

  /// A piece that has been cut loose, named to the step in the next inputs, as the loop does.
  void name_fragment(std::uint32_t name) { named_ = {static_cast<std::uint16_t>(0x8000u | name >> 15), static_cast<std::uint16_t>(name & 0x7fffu)}; }

  /// K of the exact proxy where the tissue is not all alike, by the contact point (its ball's lowest) and what the
  /// method answered.
  std::function<double(const Exact&, const StepOutput&)> stiffness;
  /// Where the pivot has no business to be.
  std::function<bool(Vec3)> behind;

 private:
  const Shape& shape_;
  StepState state_;
  std::unique_ptr<Truth> truth_;
  double radius_mm_;
  Vec3 exact_n_{0.0};
  std::vector<std::uint16_t> named_;  // halves of a name that are still to be said
  int faulted_ = 0;
};

/// A hand's intent at a millisecond of its way: device points that it would go through if nothing were there.
using Intent = std::function<Vec3(int ms)>;

/// What happens in a hand's run besides.
struct Events {
  std::function<void(int ms, Pair& pair, lab::ClosedLoop& loop)> method;  // nullptr: nothing
  std::function<void(int ms, std::unique_ptr<Truth>& truth, lab::ClosedLoop& loop)> exact;
};

/// A latched fault is re-armed after so many ticks, as somebody at the desk would.
inline constexpr int kRearmTicks = 100;

/// A hand follows `intent` for so many milliseconds and then holds still for kHoldMs. First the method (with the exact
/// proxy at the same device points), then the exact proxy on its own in the same loop. Both begin at `start`.
inline constexpr int kHoldMs = 2000;
void run_hand(Pair& pair, const Shape& shape, const Setting& setting, Vec3 start, const Intent& intent, int ms,
              std::uint64_t seed, Tally& tally, const Events& events = {});

/// How deep behind the surface a hand has to mean to be so that it presses with force_n on stiffness K.
double depth_for(const Setting& setting, double force_n, double k_n_per_mm = kStabilityNPerMm);

}  // namespace cusp::bench
