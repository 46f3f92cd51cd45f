/// Everything that does not change while an exercise runs: what `step` may read besides its state and its input.
/// Shared and immutable after loading. Any thread.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/base/vec.h"
#include "engine/tool/burr.h"
#include "engine/volume/specimen.h"

namespace cusp {

/// Rises when a golden hash of the step changes: a session of another engine version opens from its stored results.
inline constexpr int kEngineVersion = 2;

/// How contact is found (design, "Contact methods").
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

/// What a tissue feels like and how fast a burr goes through it at full wear.
struct TissueFeel {
  double stiffness_n_per_mm = 1.0;  // K of eq. (2); (0, 20]
  double speed_mm_s = 1.0;          // removal velocity RV of eq. (6) at alpha = 1; 0 = cannot be cut
};

/// Last stage of the step: what the hand may get.
struct GuardSettings {
  double limit_n = 8.9;             // the device's; per vector
  double slew_n_per_ms = 0.3;       // how fast the force may rise; it may fall at any rate
  double ramp_in_ms = 200.0;        // from zero after start, burr change or re-arm
  double jump_mm = 5.0;             // a device point that moves further in one input is a fault
  double late_ms = 50.0;            // an input that comes later than this is a fault
};

struct Scene {
  std::shared_ptr<const Specimen> specimen;  // built with reading_of(method)
  Method method = Method::surface;
  std::array<TissueFeel, kTissueCodes> tissues{};
  std::vector<Burr> burrs;                   // at least one; StepInput::burr chooses
  Vec3 tool_axis{0.0, 0.0, 1.0};             // unit, from the ball towards the shank; for devices without rotation
  double full_force_n = 1.5;                 // F_full of eq. (4): d_max = F_full / K [M unless the scene says]
  bool friction = false;
  double friction_coefficient = 0.15;        // Coulomb cone (surface), scaled eq. (3) (occupancy) [M]
  GuardSettings guard;
};

}  // namespace cusp
