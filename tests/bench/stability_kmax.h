/// How stiff a wall may be before a hand and a device ring on it (k_max), for a contact method and for the exact proxy
/// of the same shape, in the laboratory's closed loop.
///
/// A run: from just above its place the device is led at 50 mm/s until the controller gives a first force; there it is
/// let go at that speed, and the hand goes on until it presses with 1 N (a grip's spring; without a grip a push that
/// grows as a wall of that stiffness would ask of 50 mm/s); then it presses for 2 s. The final 0.8 s decide
/// (lab::Steadiness). Where a shape holds nothing sideways and nobody holds the device, a rail does: on a frictionless
/// face the rest of a force quantum makes it drift, which is no vibration.
///
/// k_max: of the grid 0.05 N/mm times powers of 1.02, the last stiffness before the first at which a seed fails. Found
/// by bisection on the grid, and confirmed by looking below what it found: at every place of the 20 % beneath, at every
/// eighth of the grid below that, the same ones whatever was found. A failure met there takes its place. What fails only
/// between those is missed, unless every place is asked for.
///
/// Stiffness is a factor on the force of a scene of 1 N/mm (without friction the force is linear in it), so that
/// specimen, cuts and state are made once for all stiffnesses; with the guard on the scene has it itself.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/lab/closed_loop.h"
#include "engine/lab/measures.h"
#include "engine/step/step.h"
#include "tests/bench/options.h"
#include "tests/bench/stability_places.h"
#include "tests/modules.h"

namespace cusp::bench {

inline constexpr double kKMaxFloor = 0.05;  // N/mm
inline constexpr double kKMaxFactor = 1.02;
inline constexpr int kKMaxPlaces = 270;  // to 10.3 N/mm
inline constexpr double kPressN = 1.0, kApproachMmS = 50.0, kPressS = 2.0;

/// Which stiffnesses below the first failure are tried again.
enum class KMaxSearch : std::uint8_t { spot_checks, every_place };

struct KMaxCase {
  std::string place = "face";
  std::optional<Method> method;  // nullopt: the exact proxy
  GuardUse guard = GuardUse::off;
  double bur_radius_mm = 0.5;
  double voxel_mm = 10.0 / 128;
  lab::DeviceSettings device;
  lab::TransportSettings transport;  // its seed is the run's
  lab::Grip grip = lab::kNoGrip;
  int seeds = 5;
  std::uint64_t first_seed = 1;
  KMaxSearch search = KMaxSearch::spot_checks;
};

/// One run at one stiffness.
struct PressRun {
  lab::Steadiness::Verdict verdict = lab::Steadiness::Verdict::steady;
  double cycle_um = 0.0, cycle_hz = 0.0;  // peak to peak and frequency over the final 0.8 s
  double window_mj = 0.0;                 // net energy out of the wall in it
  double energy_mj = 0.0;                 // lab::ContactEnergy over the whole run
  // Of a method, where asked for:
  double force_step_mn = 0.0, guard_step_mn = 0.0;
  double penetration_um = 0.0;
  double off_um = 0.0;  // farthest from the exact proxy at the same device point
  int stuck_ms = 0;
  bool left = false;  // the proxy ended elsewhere: slipped off an edge, fell through, flew off; counts as moving
};

/// stop_early: a run ends when it has failed. compare_exact: the run also fills the differences from the exact proxy.
struct PressOptions {
  bool stop_early = false;
  bool compare_exact = false;
};

/// A place and what answers there, made once and run at many stiffnesses, on many devices. One thread at a time.
class PressBench {
 public:
  explicit PressBench(const KMaxCase& what);
  ~PressBench();
  PressBench(const PressBench&) = delete;
  PressBench& operator=(const PressBench&) = delete;

  /// Another device, transport, grip or guard. Place, method, bur and voxel stay as they were made.
  void use(const KMaxCase& what);
  /// early: a run that has already failed ends there. compare: follow the exact proxy too, for what is "of a method".
  PressRun run(double k_n_per_mm, std::uint64_t seed, PressOptions options = {});

 private:
  /// The method's state, clear of the place and ready; nullptr for the exact proxy.
  StepState* state_at(double k_n_per_mm, Vec3 start, const Press& press);

  struct Inner;
  std::unique_ptr<Inner> inner_;
};

struct KMax {
  double k_max_n_per_mm = 0.0;                                         // 0: the lowest already fails
  bool beyond = false;                                                 // nothing failed up to the grid's end
  lab::Steadiness::Verdict reason = lab::Steadiness::Verdict::steady;  // of the first stiffness that fails
  double cycle_um = 0.0, cycle_hz = 0.0;                               // there
  bool left = false;                                                   // there, the bur left the place
  std::uint64_t seed = 0;                                              // that fails there
  int runs = 0;                                                        // how many it took
};

constexpr std::string_view key_of(lab::Steadiness::Verdict v) noexcept {
  switch (v) {
    case lab::Steadiness::Verdict::steady:
      return "steady";
    case lab::Steadiness::Verdict::moves:
      return "moves";
    case lab::Steadiness::Verdict::feeds:
      return "feeds";
    case lab::Steadiness::Verdict::over_limit:
      return "over-limit";
  }
  return "steady";
}

double k_at(int place);  // of the grid

/// With a bench of the same place and method. near (N/mm): a guess, such as the exact proxy's; it saves half of the
/// runs and does not change what is confirmed. 0: none.
KMax find_k_max(PressBench& bench, const KMaxCase& what, double near_n_per_mm = 0.0);
KMax find_k_max(const KMaxCase& what);
/// By the definition, place by place from the lowest: for tests.
KMax scan_k_max(PressBench& bench, const KMaxCase& what);


}  // namespace cusp::bench
