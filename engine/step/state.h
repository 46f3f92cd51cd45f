/// Inside of StepState: every number that the next step depends on. state_fields.h lists them. Only engine/step and its tests
/// include this.
#pragma once

#include <array>
#include <memory>

#include "engine/contact/cavity/cut_memory.h"
#include "engine/contact/cavity/sweeps.h"
#include "engine/contact/surface_contact.h"
#include "engine/removal/carve.h"
#include "engine/removal/wear.h"
#include "engine/step/guard.h"
#include "engine/step/methods.h"
#include "engine/step/step.h"
#include "engine/step/step_phenomena.h"
#include "engine/volume/fragments.h"

namespace cusp::engine {

struct StepState::Inner {
  explicit Inner(std::shared_ptr<const Scene> s);

  std::shared_ptr<const Scene> scene;
  Volume volume;
  StepOutput last;
  GuardState guard;

  Vec3 proxy{0.0};
  Vec3 device{0.0};                // of the input before
  Vec3 predicted_excess{0.0};      // surface: the proxy's last move less the device's, per mm of the device's
  bool prediction_holds = false;   // the last two ticks had much the same excess: the next displacement is predicted by it
  Vec3 cut_pose{0.0};              // banded: the bur's pose as far as removal goes
  bool started = false;
  bool cut_valid = false;
  bool cut_pending = false;        // the sweep along cut_way to cut_pose is still growing
  bool carved = false;             // the last tick carved a head's sweep after it had solved for contact
  Polyline cut_way;                // a head's: where the sweep begins and bends; a ball's: where it begins
  Vec3 cut_axis{0.0, 0.0, 1.0};    // of the bur in that sweep
  std::int32_t cut_first = 0, cut_last = -1;  // a ball's: those of `sweeps` that it is made of
  /// A finished sweep that is to be carved.
  struct PendingSweep {
    Polyline way;
    Vec3 axis{0.0};
    std::uint16_t bur = 0;
    bool start_carved = false;     // the sweep before ended where this one begins, with the same bur and axis
    std::int32_t first = 0, last = -1;  // a ball's: those of `sweeps` that it is made of
    bool waits = false;            // false: there is none
  };
  PendingSweep pending_sweep;
  std::array<double, kTissueCodes> wear_remainder{};  // filled: wear below one quantum of solid fraction, by tissue
  Vec3 foot{0.0};                  // gradient: from the pivot to the followed point of the bur; zero: none
  CutMemory memory;                // of heads that are no balls
  Sweeps sweeps;                   // of balls
  FragmentRemoval fragment_removal;

  // Derived from the scene and the volume.
  std::vector<std::vector<FrontRing>> fronts;  // by bur; empty for a ball
  std::unique_ptr<SurfaceContact> surface;  // of the surface method alone
  std::unique_ptr<ContactMethod> method;
  std::unique_ptr<PhenomenaState> phenomena;  // null: the scene asks for none
};

}  // namespace cusp::engine
