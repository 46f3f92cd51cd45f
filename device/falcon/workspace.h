/// Maps the grip's position to the specimen, and a force on the bur to the grip. The device's x (right), y (up) and
/// z (to the user) become the specimen's x, z and -y, turned by `yaw_rad` about the specimen's z, scaled, shifted.
/// Metres on the device's side, millimetres on the specimen's. Pure but for the clutch. Haptic thread.
#pragma once

#include <optional>

#include "engine/base/vec.h"

namespace cusp::device::falcon {

struct WorkspaceSettings {
  Vec3 centre_m{0.0, 0.0,
                0.125};  // middle of the device's travel; programs use 0.100 to 0.150
  Vec3 origin_mm{0.0};   // position of the centre in the specimen
  double scale = 0.5;    // mm in the specimen for a mm of the grip: 80 mm of travel cover a tooth [M]
  double yaw_rad = 0.0;
};

class Workspace {
 public:
  static constexpr double kMinScale = 0.05;
  static constexpr double kMaxScale = 1.0;  // a larger scale would make tissue feel stiffer than the scene sets

  /// nullopt if a number is not finite or the scale is out of range.
  static std::optional<Workspace> from(const WorkspaceSettings& settings) noexcept;

  Vec3 specimen_mm(Vec3 grip_m) const noexcept;
  /// The grip position for a position in the specimen; meaningless while the clutch is held.
  Vec3 grip_m(Vec3 specimen_mm) const noexcept;
  /// Keeps newtons: with a scale under 1 a tissue of stiffness K feels like K * scale.
  Vec3 device_n(Vec3 specimen_n) const noexcept;

  /// While the clutch is held the grip moves and the bur does not; afterwards the bur continues from its position.
  /// Pre: the caller sends no force meanwhile.
  void hold(Vec3 grip_m) noexcept;
  void release(Vec3 grip_m) noexcept;
  bool held() const noexcept { return held_; }
  double scale() const noexcept { return settings_.scale; }

 private:
  explicit Workspace(const WorkspaceSettings& settings) noexcept;
  Vec3 turned(Vec3 device) const noexcept;

  WorkspaceSettings settings_;
  double cosine_ = 1.0, sine_ = 0.0;
  Vec3 held_mm_{0.0};
  bool held_ = false;
};

}  // namespace cusp::device::falcon
