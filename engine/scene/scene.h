/// Everything that step() reads besides its state and its input, and that does not change during an exercise.
/// Shared and immutable after loading. Any thread.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/base/vec.h"
#include "engine/scene/phenomena.h"
#include "engine/tool/bur.h"
#include "engine/volume/specimen.h"

namespace cusp::engine {

/// Rises when a golden hash of the step changes: a session of another engine version opens from its stored results.
inline constexpr int kEngineVersion = 34;

/// Contact method (engine/contact/README.md).
enum class Method : std::uint8_t { occupancy, occupancy_pivot, surface, ray, penalty, gradient };

constexpr std::string_view key_of(Method m) noexcept {
  switch (m) {
    case Method::occupancy: return "occupancy";
    case Method::occupancy_pivot: return "occupancy-pivot";
    case Method::surface: return "surface";
    case Method::ray: return "ray";
    case Method::penalty: return "penalty";
    case Method::gradient: return "gradient";
  }
  return "surface";
}
/// The paper's method and the ray proxy wear voxels; the others read and carve a distance.
constexpr Reading reading_of(Method m) noexcept {
  return m == Method::occupancy || m == Method::occupancy_pivot || m == Method::ray ? Reading::filled
                                                                                     : Reading::banded;
}

/// Stiffness of a tissue, and a bur's speed in it at full wear.
struct TissueFeel {
  double stiffness_n_per_mm = 1.0;  // K of eq. (2); (0, 20]
  double speed_mm_s = 1.0;          // removal velocity RV of eq. (6) at alpha = 1; 0 = cannot be cut
};

/// Parts of the guard; each can be switched off, to show its effect. A lost device and a position or force that is not finite
/// latch a fault in any case.
enum class GuardPart : std::uint16_t {
  limit = 1 << 0,      // most force
  slew = 1 << 1,       // rising force
  ramp_in = 1 << 2,    // from zero after start, bur change or re-arm
  jump = 1 << 3,       // fault: the device point jumped
  late = 1 << 4,       // fault: the tick is late
  stale = 1 << 5,      // fault: the device repeats itself
  speed = 1 << 6,      // fades the force of a fast device
  passivity = 1 << 7,  // the controller of passivity.h
  coupling = 1 << 8,   // its damper
};
inline constexpr std::uint16_t kAllGuardParts = 0x1ff;

/// Last stage of the step: bounds of the force. [M]: chosen here, not measured on a device.
struct GuardSettings {
  double limit_n = 8.9;             // the device's; per vector
  double slew_n_per_ms = 0.3;       // how fast the force may rise; it may fall at any rate
  double ramp_in_ms = 200.0;        // from zero after start, bur change or re-arm
  double jump_mm = 5.0;             // a device point that moves further in one input is a fault
  double late_ms = 50.0;            // an input later than this is a fault
  double stale_ms = 10.0;           // a device without a new sample for longer is a fault [M]: a Falcon answers each
                                    // millisecond, and drops its force when the host is silent
  double speed_mm_s = 400.0;        // the force of a device that moves faster along it fades, to zero at twice this
                                    // [M]: drilling hands move at 1 to 50
  double passivity_mj = 0.015;      // energy that the loop may feed before the passivity controller acts
  double delay_ms = 0.0;            // round trip that the passivity controller assumes, [0, 8]
  double encoder_mm = 0.05;         // step of the device's reading: less is no motion for the controller
  double coupling_ns_per_m = 10.0;  // damper of the virtual coupling, while the controller softens it
  std::uint16_t parts = kAllGuardParts;

  constexpr bool has(GuardPart part) const noexcept { return (parts & static_cast<std::uint16_t>(part)) != 0; }
  constexpr GuardSettings without(GuardPart part) const noexcept {
    GuardSettings out = *this;
    out.parts = static_cast<std::uint16_t>(out.parts & ~static_cast<unsigned>(part));
    return out;
  }
  constexpr GuardSettings with(GuardPart part) const noexcept {
    GuardSettings out = *this;
    out.parts = static_cast<std::uint16_t>(out.parts | static_cast<unsigned>(part));
    return out;
  }
  friend bool operator==(const GuardSettings&, const GuardSettings&) = default;
};

/// For the laboratory: force_n is the method's own. Not for a device that a hand holds.
constexpr GuardSettings unguarded() noexcept {
  GuardSettings out;
  out.parts = 0;
  return out;
}

struct Scene {
  std::shared_ptr<const Specimen> specimen;  // built with reading_of(method)
  Method method = Method::surface;
  std::array<TissueFeel, kTissueCodes> tissues{};
  std::vector<Bur> burs;                   // at least one; StepInput::bur chooses
  Vec3 tool_axis{0.0, 0.0, 1.0};             // unit, from the head towards the shank, at the identity orientation
  double tilt_cosine = 1.0;                  // surface: cosine of the largest tilt by the input's orientation; 1: none
  double full_force_n = 1.5;                 // F_full of eq. (4): d_max = F_full / K [M unless the scene sets it]
  bool friction = false;
  double friction_coefficient = 0.15;        // Coulomb cone (surface), scaled eq. (3) (occupancy) [M]
  GuardSettings guard;
  Phenomena phenomena;
};

}  // namespace cusp::engine
