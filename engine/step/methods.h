/// A contact method: contact, removal and raw force of a tick. StepState makes its scene's method once.
/// StepState::Inner holds everything that the next tick depends on (state_fields.h); a method caches only figures of
/// the scene and the volume. Thread: haptic, except for construction and reload(). The noexcept functions are
/// wait-free.
#pragma once

#include <memory>
#include <span>

#include "engine/removal/wear.h"
#include "engine/step/step.h"

namespace cusp::engine {

/// Input of a method's tick.
struct Tick {
  Vec3 device{0.0};
  Vec3 axis{0.0, 0.0, 1.0};  // of the tool, unit, from the ball towards the shank
  bool cut = false;
  double dt_s = 0.001;  // bounded by the guard's late limit
  double removal_factor = 1.0;  // share of the tissues' removal speeds that the spindle gives, [0, 1]
  bool fragment_leaves = false;  // this tick removes voxels of a severed fragment, so other work is deferred
};

/// What the proxy touches.
struct Touched {
  Tissue tissue = Tissue::empty;    // most of it
  double stiffness_n_per_mm = 0.0;  // blended
};

/// What presses a bur on.
struct Pressed {
  Touched touched;
  double push_mm = 0.0;           // from the device to the proxy
  Vec3 slid{0.0};                 // of the proxy in this tick, as far as the cut pose goes along with it, mm
  double tie_mm = 0.0;            // the cut pose stays within this of the proxy, so that errors do not add up
  std::span<const Vec3> walls{};  // that neck and shank lean on: normals
};

/// The cut of a tick: the bur goes advance_mm from `pose` along `head`.
struct Advance {
  Vec3 pose{0.0};
  HeadPush head;
  double advance_mm = 0.0;

  /// Where it ends, at the device point at the latest.
  Vec3 end() noexcept {
    if (advance_mm > head.gap_mm) advance_mm = head.gap_mm;
    return pose + head.direction * advance_mm;
  }
};
/// Eq. (4) and (6): how far the pressed bur goes in this tick. now: of this tick, its bur and number.
Advance advance_of(const StepState::Inner& state, const Tick& tick, const Pressed& pressed, const StepOutput& now) noexcept;

/// The force of the spring between device and proxy, with friction against the proxy's way from `before`; and what it touches.
void press_back(const StepState::Inner& state, const Tick& tick, const Touched& touched, Vec3 before, StepOutput& out) noexcept;

class ContactMethod {
 public:
  virtual ~ContactMethod() = default;

  /// Moves the proxy, removes worn material and fills contact, force, tissue and flags of `out`.
  virtual void tick(StepState::Inner& state, const Tick& tick, StepOutput& out) noexcept = 0;
  /// Ends the stroke (fault, another bur). False if the volume had no room.
  virtual bool end_stroke(StepState::Inner& state) noexcept = 0;
  /// free_space: the surface method says true only where no brick in reach has tissue; costs a few us. whole: it looks at the
  /// surface, up to 1 ms for a wide head. Other methods look alike in both.
  enum class Look : std::uint8_t { free_space, whole };
  /// True if a proxy with this bur may start at this pose. A surface within a voxel of the bur may make it false.
  virtual bool fits(StepState::Inner& state, std::uint16_t bur, Vec3 axis, Vec3 pose_mm, Look look) noexcept = 0;
  /// Removes a severed fragment's voxels (engine/volume/fragments.h). False if the volume had no room.
  virtual bool remove_voxels(StepState::Inner& state, std::span<const IVec3> voxels) noexcept = 0;
  /// The volume was replaced by a key state's: caches are made again. Not on the haptic thread.
  virtual void reload(StepState::Inner& state) = 0;
};

/// The method of the state's scene. Reserves all it can need.
std::unique_ptr<ContactMethod> make_method(StepState::Inner& state);
std::unique_ptr<ContactMethod> make_surface_method();
std::unique_ptr<ContactMethod> make_filled_method(StepState::Inner& state);  // occupancy, occupancy-pivot, ray
std::unique_ptr<ContactMethod> make_banded_method(StepState::Inner& state);  // penalty, gradient

}  // namespace cusp::engine
