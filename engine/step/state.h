/// Inside of StepState: every number that the next step depends on. Only engine/step includes this.
#pragma once

#include <array>
#include <memory>

#include "engine/contact/cut_memory.h"
#include "engine/contact/surface_contact.h"
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
  Vec3 astray{0.0};                // surface: how the proxy's last move differed from the device's, per mm of it
  bool strays = false;             // it did so much the same way the tick before
  Vec3 cut_pose{0.0};              // banded: the bur's pose as far as removal goes
  Vec3 velocity{0.0};              // of the proxy, mm/s, for friction
  bool started = false;
  bool cut_valid = false;
  bool cut_pending = false;        // the head has been swept from cut_from to cut_pose: next to be carved
  Vec3 cut_from{0.0};
  Vec3 cut_axis{0.0, 0.0, 1.0};    // of the bur on that way
  /// A piece of the stroke that is being carved, some bricks a tick.
  struct Owed {
    Vec3 from{0.0}, to{0.0}, axis{0.0};
    std::uint16_t bur = 0;
    bool start_carved = false;     // the piece before ended where this one begins
    std::int32_t next = -1;        // brick to go on from; -1: nothing is owed
  };
  Owed owed_piece;
  std::array<double, kTissueCodes> owed{};  // wear below one quantum, a remainder for each tissue (filled)
  Vec3 foot{0.0};                  // gradient: from the pivot to the point of the bur that was followed last; zero: none
  CutMemory memory;
  LeavingPiece leaving;            // a severed piece on its way out

  // Derived from the scene and the volume.
  std::vector<std::vector<FrontRing>> fronts;  // by bur; empty for a ball
  std::unique_ptr<SurfaceContact> surface;  // of the surface method alone
  std::unique_ptr<ContactMethod> method;
  std::unique_ptr<PhenomenaState> phenomena;  // null: the scene asks for none
};

/// Surface method: carves what is still pending and ends the stroke (button up, no contact, fault, another bur).
/// Returns false when the volume had no room.
bool end_stroke(StepState::Inner& state) noexcept;

/// Surface method: contact, removal and raw force of one tick into `out`.
void step_surface(StepState::Inner& state, const Tick& tick, StepOutput& out) noexcept;

}  // namespace cusp::engine
