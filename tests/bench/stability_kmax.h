/// How stiff a wall may be before a hand and a device ring on it (k_max), for a contact method and for the exact proxy of
/// the same shape, in the laboratory's closed loop.
///
/// A run: from just above its place the device is led at 50 mm/s along the press until the controller gives a first
/// force; there it is let go at that speed, and the hand goes on until it presses with 1 N (a grip's spring, or without
/// one a push that grows as a wall of that stiffness would ask of 50 mm/s); then it presses for 2 s. The final 0.8 s
/// decide (lab::Steadiness). Where a shape holds nothing sideways and nobody holds the device, a rail does: a frictionless
/// face would let it drift by a force quantum, which is no vibration.
///
/// k_max: of the grid 0.05 N/mm times powers of 1.02, the last stiffness before the first at which one of the seeds
/// fails. Found by bisection on the grid, and confirmed by looking below it, at every second place of the 20 % beneath,
/// then at places 10 % apart: a failure found there takes its place. What fails only between those is missed.
///
/// Stiffness enters as a factor on the force of a scene of 1 N/mm (friction off, it is linear in K); with the guard on
/// the scene has it itself.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "engine/lab/closed_loop.h"
#include "engine/lab/measures.h"
#include "engine/step/step.h"
#include "tests/bench/shapes.h"

namespace cusp::bench {

inline constexpr double kKMaxFloor = 0.05;   // N/mm
inline constexpr double kKMaxFactor = 1.02;
inline constexpr int kKMaxPlaces = 270;      // to 10.3 N/mm
inline constexpr double kPressN = 1.0, kApproachMmS = 50.0, kPressS = 2.0;

/// Where one presses. Six of them: face, edge, corner, groove, pit, channel.
struct Press {
  std::shared_ptr<const Shape> shape;
  std::unique_ptr<Truth> (*truth)(const Press&) = nullptr;  // nullptr: the shape's own
  Vec3 above{0.0};      // an admissible centre from which the way along `into` touches
  Vec3 touch{0.0};      // the exact proxy while pressed
  Vec3 into{0.0};       // unit, direction of the push
  Vec3 free_a{0.0}, free_b{0.0};  // unit directions in which nothing holds the burr
};

/// nullopt for another name.
std::optional<Press> make_press(std::string_view shape, double burr_radius_mm);

struct KMaxCase {
  std::string shape = "face";
  std::optional<Method> method;  // nullopt: the exact proxy
  bool guard = false;
  double burr_radius_mm = 0.5;
  double voxel_mm = 10.0 / 128;
  lab::DeviceSettings device;
  lab::TransportSettings transport;  // its seed is not used: seeds are 1 to `seeds`
  lab::Grip grip = lab::kNoGrip;
  int seeds = 5;
};

/// One run at one stiffness.
struct PressRun {
  lab::Steadiness::Verdict verdict = lab::Steadiness::Verdict::steady;
  double cycle_um = 0.0, cycle_hz = 0.0;  // peak to peak and frequency over the final 0.8 s
  double window_mj = 0.0;                 // net energy out of the wall in it
  double energy_mj = 0.0;                 // lab::ContactEnergy over the whole run
  double force_step_mn = 0.0, guard_step_mn = 0.0;  // of a method
  double penetration_um = 0.0;
  bool stuck = false;
  int stuck_ms = 0;
  bool passed_through = false;            // the proxy left the exact one by more than a burr radius
};

/// A press and what answers it, made once and run at many stiffnesses. Not copyable; any thread, one at a time.
class PressBench {
 public:
  PressBench(const KMaxCase& what, const Press& press);
  ~PressBench();
  /// measure: also what costs an exact proxy beside a method (force steps, stuck, penetration).
  PressRun run(double k_n_per_mm, std::uint64_t seed, bool measure = false);
  /// Changes device, grip and transport; the specimen and state stay.
  void use(const KMaxCase& what);

 private:
  struct Inner;
  std::unique_ptr<Inner> inner_;
};

struct KMax {
  double k_max_n_per_mm = 0.0;  // 0: the lowest already fails
  bool beyond = false;          // nothing failed up to the grid's end
  double cycle_um = 0.0, cycle_hz = 0.0;  // of the worst seed at the first stiffness that fails
  lab::Steadiness::Verdict reason = lab::Steadiness::Verdict::steady;  // why it fails there
  std::uint64_t seed = 0;       // that fails there
  int runs = 0;                 // how many it took
};

KMax find_k_max(const KMaxCase& what);
KMax find_k_max(PressBench& bench, const KMaxCase& what);

}  // namespace cusp::bench
