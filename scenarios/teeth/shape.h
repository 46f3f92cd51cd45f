/// The fields of one tooth: its outside, dentine and pulp as signed distances (first order, negative inside), made from
/// a table, varied by a seed and scaled until the measured lengths fit. Frame: that of the tables (quadrants 1 and 3).
#pragma once

#include <optional>

#include "scenarios/teeth/loft.h"
#include "scenarios/teeth/noise.h"
#include "scenarios/teeth/occlusal.h"

namespace cusp::scenarios {

class ToothShape {
 public:
  /// Features too thin for voxels of that size are widened: grooves to 1.8 voxels a side, canals to a radius of 0.8.
  ToothShape(const ToothTable& table, std::uint64_t seed, double voxel_mm);

  /// Below 0 within the tooth.
  double outside(Vec3 p) const noexcept;
  /// Below 0 within dentine (or pulp). `outside_mm`: the best known value of outside(p), for the thin coats.
  double dentine(Vec3 p, double outside_mm) const noexcept;
  double pulp(Vec3 p) const noexcept;
  /// Height above the CEJ: enamel where it is positive, cementum elsewhere.
  double above_cej(Vec3 p) const noexcept;

  /// Distance to the side walls alone: negative on the biting surface, by how far the rim is away.
  double beyond_rim(Vec3 p) const noexcept { return wall_.outside_at(to_table(p)).featured; }

  /// Place in the table's frame, before the seed's warp and the fit.
  Vec3 to_table(Vec3 p) const noexcept;
  Vec3 from_table(Vec3 table_place) const noexcept;

  const ToothTable& table() const noexcept { return table_; }
  const ToothDims& dims() const noexcept { return dims_; }
  /// Corners of a box that holds the tooth with little to spare.
  Vec3 low() const noexcept { return low_; }
  Vec3 high() const noexcept { return high_; }
  Vec3 mesial_contact() const noexcept { return mesial_; }
  Vec3 distal_contact() const noexcept { return distal_; }

  /// Goes from `from` (outside) along the unit vector `way` to the surface; nothing within `most_mm`.
  std::optional<double> march(Vec3 from, Vec3 way, double most_mm) const noexcept;
  /// Surface point below (x, y), seen from above the tooth.
  std::optional<Vec3> top_at(double x, double y) const noexcept;

 private:
  struct Scale {
    double x_crown = 1, x_neck = 1, y_crown = 1, y_neck = 1, z_crown = 1, z_root = 1;
  };
  double crown(Vec3 table_place, const WallPlace& wall) const noexcept;
  double cej_height(const WallSide& wall) const noexcept;
  void fit();
  void measure();
  void measure_crown_and_root();
  Vec3 furthest(Vec3 way, double z_from, double z_to) const;

  ToothTable table_;  // with what the seed changed in it
  std::uint64_t seed_;
  double voxel_mm_;
  Wall wall_;
  Occlusal occlusal_;
  std::vector<Loft> roots_, pulp_;
  ValueNoise warp_x_, warp_y_;
  Scale scale_;
  double x_blend_low_ = 0, x_blend_high_ = 0, y_blend_low_ = 0, y_blend_high_ = 0;
  ToothDims dims_;
  Vec3 low_{0.0}, high_{0.0}, mesial_{0.0}, distal_{0.0};
};

}  // namespace cusp::scenarios
