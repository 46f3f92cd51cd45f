/// One way of finding contact, as the step runs it: contact, removal and raw force of a tick. Chosen per scene, made
/// once when the state is built; all that a next tick depends on stands in StepState::Inner, never in the method, so
/// that key states and hashes hold it. What a method keeps of its own is derived from the scene and the volume. Thread:
/// haptic, but for making it and reload(). No heap, no lock, no I/O in the noexcept functions.
#pragma once

#include <memory>
#include <span>

#include "engine/step/step.h"

namespace cusp::engine {

/// What a tick asks of a method.
struct Tick {
  Vec3 device{0.0};
  Vec3 axis{0.0, 0.0, 1.0};  // of the tool, unit, from the ball towards the shank
  bool cut = false;
  double dt_s = 0.001;  // bounded by the guard's late limit
  double removal_factor = 1.0;  // of the tissues' speeds, [0, 1]: what the spindle leaves
  bool piece_goes = false;      // a severed piece loses some of itself in this tick: what else can wait does
};

class ContactMethod {
 public:
  virtual ~ContactMethod() = default;

  /// Moves the proxy, removes what the bur wears and fills contact, force, tissue and flags of `out`.
  virtual void tick(StepState::Inner& state, const Tick& tick, StepOutput& out) noexcept = 0;
  /// The stroke is over (fault, another bur). False when the volume had no room.
  virtual bool lift(StepState::Inner& state) noexcept = 0;
  /// True when a proxy may begin at this pose, false when it has to come down from above the specimen.
  virtual bool fits(StepState::Inner& state, Vec3 axis, Vec3 pose_mm) noexcept = 0;
  /// See cut_along() of step.h.
  virtual bool cut_along(StepState::Inner& state, std::uint16_t bur, Vec3 from_mm, Vec3 to_mm) noexcept = 0;
  /// A severed piece's voxels go (engine/volume/fragments.h). False when the volume had no room.
  virtual bool take_away(StepState::Inner& state, std::span<const IVec3> voxels) noexcept = 0;
  /// The volume was replaced by a key state's.
  virtual void reload(StepState::Inner& state) = 0;
};

/// The method of the state's scene. Reserves all it can need.
std::unique_ptr<ContactMethod> make_method(StepState::Inner& state);
std::unique_ptr<ContactMethod> make_filled_method(StepState::Inner& state);  // occupancy, occupancy-pivot, ray
std::unique_ptr<ContactMethod> make_banded_method(StepState::Inner& state);  // penalty, gradient

}  // namespace cusp::engine
