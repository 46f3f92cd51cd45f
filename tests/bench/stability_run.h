/// A run of `stability`: a method and the exact proxy of the same shape at the same device points, tick by tick. The
/// device point is scripted, or a hand moves it in the laboratory's closed loop.
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

inline constexpr double kStabilityNPerMm = 1.0;  // stiffness of all tissue, unless a case has its own

/// scene_of with the guard of a session, or with every part of it off.
std::shared_ptr<Scene> stability_scene(const Shape& shape, Method method, double voxel_mm, GuardUse guard,
                                       double delay_ms = 0.0);

/// A device and the hand that holds it.
struct Setting {
  double mass_kg = 0.1, damping_ns_per_m = 2.0, friction_n = 0.0, delay_ms = 0.0;
  /// none, soft, firm; scripted: no hand and no device are in the loop.
  std::string_view grip = "scripted";
  bool weighs = false;  // gravity pulls at the device

  bool in_loop() const { return grip != "scripted"; }
  lab::DeviceSettings device() const;  // with the Falcon's encoder, force quantum and limit
  lab::Grip hand() const;
  lab::TransportSettings transport(std::uint64_t seed) const;
};
/// Sets device, grip, mass, damping, friction and delay.
void name_setting(Row& row, const Setting& setting);
/// "m0.1-b2": kilograms, N s/m.
std::string device_name(double mass_kg, double damping_ns_per_m);

/// Largest measures over the runs of one row.
class Tally {
 public:
  /// A run begins.
  void begin();
  /// exact_n: force of the exact proxy. clearance_mm: exact, at the method's proxy. near_mm: within this distance the
  /// method stands with the exact proxy.
  struct Contact {
    Vec3 exact_n{0.0};
    double clearance_mm = 0.0;
    double bur_radius_mm = 0.0;
    double near_mm = 0.0;
  };
  void add(const StepOutput& out, const Exact& exact, const Contact& contact);
  /// Ticks before and after a vanished exact minimum in which the method may move to the next face at another time. They
  /// are a first contact and no force step.
  static constexpr int kSooner = 50, kLater = 100;
  /// Adds the rendered force of a tick without an exact proxy.
  void add_force(const StepOutput& out);
  /// The pivot is behind the tissue.
  void mark_passed() { through_ = true; }
  /// The next force step does not count (exchange, re-arm).
  void interrupt();
  void add_loop(const lab::LoopTick& tick);
  void add_exact_loop(const lab::LoopTick& tick);
  void add_rest(const lab::Steadiness& steady);
  void add_exact_rest(const lab::Steadiness& steady);
  /// The run is over.
  void end();

  void fill(Row& row);

 private:
  /// Input of a force step. skip: no step to this tick; ends: no step from it.
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

/// Time for which a method stays behind the exact proxy, ms; 0 below 50 ms. lab::StuckWatch looks 50 ms back and so also
/// counts the 49 ms before a jump, which this subtracts.
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

  /// Moves both to an admissible centre without contact and waits for the guard's ramp.
  void bring(Vec3 centre);
  /// Replaces the exact proxy after a cut or an exchange; the new one starts at the pose of the old one.
  void replace(std::unique_ptr<Truth> truth, double bur_radius_mm);
  /// The input, with a re-arm where a fault has lasted for kRearmTicks.
  StepInput rearmed(StepInput input);
  /// Steps the method and the exact proxy and adds the tick to the tally.
  StepOutput tick(const StepInput& input, Tally& tally);
  /// Force of the exact proxy in the last tick.
  Vec3 exact_n() const { return exact_n_; }

  /// Names a detached fragment to the step in the next inputs, as the loop does.
  void name_fragment(std::uint32_t name) { named_ = {static_cast<std::uint16_t>(0x8000u | name >> 15), static_cast<std::uint16_t>(name & 0x7fffu)}; }

  /// Stiffness of the exact proxy in mixed tissue, from the exact contact and the method's output; empty: 1 N/mm.
  std::function<double(const Exact&, const StepOutput&)> stiffness;
  /// True behind the tissue, where the pivot must not be; empty: never.
  std::function<bool(Vec3)> behind;

 private:
  const Shape& shape_;
  StepState state_;
  std::unique_ptr<Truth> truth_;
  double radius_mm_;
  Vec3 exact_n_{0.0};
  std::vector<std::uint16_t> named_;  // halves of the name not yet sent
  int faulted_ = 0;
};

/// Device point that the hand intends at millisecond ms, as if in free space.
using Intent = std::function<Vec3(int ms)>;

/// Events during a hand's run, for the method's loop and the exact proxy's loop.
struct Events {
  std::function<void(int ms, Pair& pair, lab::ClosedLoop& loop)> method;  // nullptr: nothing
  std::function<void(int ms, std::unique_ptr<Truth>& truth, lab::ClosedLoop& loop)> exact;
};

/// Ticks after which rearmed() re-arms a latched fault, as an operator does.
inline constexpr int kRearmTicks = 100;

/// A hand follows `intent` for `ms` milliseconds and then rests for kHoldMs. The method runs first, with the exact proxy
/// at the same device points; then the exact proxy runs in a loop of its own. Both begin at `start`.
inline constexpr int kHoldMs = 2000;
void run_hand(Pair& pair, const Shape& shape, const Setting& setting, Vec3 start, const Intent& intent, int ms,
              std::uint64_t seed, Tally& tally, const Events& events = {});

/// Intended depth behind the surface at which a hand presses with force_n on a wall of k_n_per_mm.
double depth_for(const Setting& setting, double force_n, double k_n_per_mm = kStabilityNPerMm);

}  // namespace cusp::bench
