/// Gingiva, bone and the ligament between bone and root, about teeth that stand in a row. Shaped by eye from general
/// anatomy [M]: the free margin a millimetre above the CEJ, papillae up between the teeth, the bone's crest two below.
#pragma once

#include <vector>

#include "scenarios/teeth/tooth_body.h"

namespace cusp::scenarios {

inline constexpr double kGumMarginMm = 1.0;   // of the free gingiva above the CEJ [M]
inline constexpr double kBoneCrestMm = 2.0;   // of the bone below the CEJ [M]
inline constexpr double kLigamentMm = 0.2;    // wide (0.15 to 0.38 in the literature) [M]

/// A body that the teeth stand in: it runs through them, and whoever makes voxels lets the teeth go first. Its fields
/// are sampled every 0.4 mm and read back smoothly: soft tissue has no finer form.
class Gums final : public Body {
 public:
  struct Parts {
    bool gingiva = true, bone = true;
  };
  /// Pre: teeth is not empty, one part is wanted. Without bone the gingiva ends below the neck.
  Gums(const std::vector<const ToothBody*>& teeth, Parts parts);

  double outside(Vec3 p) const noexcept override { return surface_.at(p); }
  Tissue inside(Vec3 p, double outside_mm) const noexcept override;
  Tissue skin(Vec3) const noexcept override { return parts_.gingiva ? Tissue::gingiva : Tissue::bone; }
  Tissue whole(Vec3 p, double far) const noexcept override;
  Vec3 low() const noexcept override { return low_; }
  Vec3 high() const noexcept override { return high_; }
  /// The height (z) at which they end below, rounded over the last half millimetre.
  double floor_mm() const noexcept { return floor_; }

 private:
  /// A field sampled on a coarse grid and read with cubic weights.
  struct Coarse {
    Vec3 low{0.0};
    IVec3 size{0};
    std::vector<float> values;
    double at(Vec3 p) const noexcept;
  };
  Parts parts_;
  double floor_ = 0.0;
  Vec3 low_{0.0}, high_{0.0};
  Coarse surface_, bone_, tooth_;  // distances: to the outer surface, to the bone's, to the nearest tooth
};

}  // namespace cusp::scenarios
