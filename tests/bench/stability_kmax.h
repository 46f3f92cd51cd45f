/// k_max: the largest stiffness at which hand and device are stable on a wall, for a contact method and for the exact
/// proxy of the same shape, in the laboratory's closed loop.
///
/// Run: the device moves at kApproachMmS from above the place until the controller renders a first force. Then the drive
/// releases it, and the hand continues until it presses with kPressN: by the grip's spring, or without a grip by a push
/// that grows as if against that wall at kApproachMmS. It presses for kPressS; lab::Steadiness judges the final 0.8 s.
/// Without a grip a rail holds the free directions, because on a frictionless face the force quantum makes the device
/// drift.
///
/// k_max is the last stiffness of the grid kKMaxFloor * kKMaxFactor^n before the first at which a seed fails. Bisection
/// finds it. spot_checks then tries every place of the 20 % below and every eighth place beneath; a failure there
/// replaces the result. A failure only between those places is missed unless every_place is set.
///
/// The stiffness is a factor on the force of a scene of 1 N/mm, because without friction the force is linear in it. So
/// one specimen and state serve all stiffnesses. With the guard on, the scene itself has the stiffness.
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
  lab::TransportSettings transport;  // run() sets the seed
  lab::Grip grip = lab::kNoGrip;
  int seeds = 5;
  std::uint64_t first_seed = 1;
  KMaxSearch search = KMaxSearch::spot_checks;
};

/// One run at one stiffness.
struct PressRun {
  lab::Steadiness::Verdict verdict = lab::Steadiness::Verdict::steady;
  double cycle_um = 0.0, cycle_hz = 0.0;  // peak to peak and frequency over the final 0.8 s
  double window_mj = 0.0;                 // net energy out of the wall in those 0.8 s
  double energy_mj = 0.0;                 // lab::ContactEnergy over the whole run
  // Of a method, where asked for:
  double force_step_mn = 0.0, guard_step_mn = 0.0;
  double penetration_um = 0.0;
  double off_um = 0.0;  // largest distance from the exact proxy at the same device point
  int stuck_ms = 0;
  bool left = false;  // the proxy ended elsewhere: off an edge, behind the wall, away; counts as moves
};

/// stop_early: a run ends when it has failed. compare_exact: the run also fills the differences from the exact proxy.
struct PressOptions {
  bool stop_early = false;
  bool compare_exact = false;
};

/// A place with its method, made once for many stiffnesses and devices. Thread: one at a time.
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
  double k_max_n_per_mm = 0.0;                                         // 0: the lowest place fails
  bool beyond = false;                                                 // no failure up to the grid's end
  lab::Steadiness::Verdict reason = lab::Steadiness::Verdict::steady;  // of the first stiffness that fails
  double cycle_um = 0.0, cycle_hz = 0.0;                               // there
  bool left = false;                                                   // the bur left the place there
  std::uint64_t seed = 0;                                              // seed that fails there
  int runs = 0;                                                        // number of runs
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

double k_at(int place);  // stiffness of the grid, N/mm

/// Pre: the bench has the same place and method. near_n_per_mm: a guess, such as the exact proxy's k_max; it saves half of
/// the runs and changes no check. 0: none.
KMax find_k_max(PressBench& bench, const KMaxCase& what, double near_n_per_mm = 0.0);
KMax find_k_max(const KMaxCase& what);
/// k_max by its definition, place by place from the lowest. bench_kmax_test compares find_k_max with it.
KMax scan_k_max(PressBench& bench, const KMaxCase& what);


}  // namespace cusp::bench
