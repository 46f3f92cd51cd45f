/// Divides a solid by place (target, tolerance zone, beyond). A cell that lies wholly in one place counts there whole; any
/// other is cut where the target's distance, the bisector of floor and side, and the tolerance zone's edge pass.
#pragma once

#include <array>

#include "engine/volume/cut_volume.h"
#include "engine/volume/volume.h"
#include "scenarios/metrics/near_cache.h"
#include "scenarios/modules.h"
#include "scenarios/shapes/place.h"

namespace cusp::scenarios {

class RegionClassifier : public SolidSink {
 public:
  /// Whether face_ is kept: then a lone upright outline is asked place by place too.
  enum class ByFace : std::uint8_t { no, yes };
  /// Both outlive the sink.
  RegionClassifier(const TargetShape& shape, const Leeway& leeway, ByFace by_face = ByFace::no)
      : shape_(shape), leeway_(leeway), upright_(leeway.faces.empty() && by_face == ByFace::no ? shape.upright() : nullptr) {}

  /// Says that all cells until the next call lie in this box. If it lies deep in the target, no cell asks again. False if the
  /// target does not reach into it.
  bool within(Vec3 low, Vec3 high) noexcept;
  void cell(Vec3 low, Vec3 high) override;
  void box(Vec3 low, Vec3 high, Tissue tissue) override;
  void tetrahedron(const std::array<Vec3, 4>& corners, double mm3, Tissue tissue) override;

 protected:
  /// A part of a cell, wholly in one place.
  virtual void solid(Place place, double mm3, Tissue tissue) = 0;
  /// Place and distance from the target of a point in the current cell.
  Place place_at(Vec3 p, double& d) noexcept;
  /// Whether the current cell lies wholly in one place.
  bool whole() const noexcept { return whole_; }
  bool wholly_in_target() const noexcept { return whole_ && place_ == Place::target; }
  Near near_at(Vec3 p) noexcept;
  /// Area of the target's own boundary in what was divided so far.
  double boundary_mm2() const noexcept { return boundary_mm2_; }

  Vec3 low_{0.0}, high_{0.0};                  // of the current cell
  FaceName face_ = FaceName::side_wall;        // nearest to the part that solid() is given, outside the target

 private:
  double outline_at(Vec3 p) noexcept;
  double outline_mm(Vec2 p) noexcept;
  bool whole_upright(Vec3 centre, double h) noexcept;
  bool whole_tree(Vec3 centre, double h) noexcept;

  const TargetShape& shape_;
  const Leeway& leeway_;
  const OutlineShape* upright_;       // sampled on a plane; nullptr: each place asks the tree
  double boundary_mm2_ = 0;
  bool in_target_ = false;            // within() lies in it
  bool whole_ = false;                // the cell lies in one place
  Place place_ = Place::target;
  bool sampled_ = false;              // outline_ is of this cell
  std::array<double, 9> outline_{};   // from the wall, at thirds 0, 1/2, 1 of x (fastest) and y
  NearCache nears_;                   // of a tree
  OutlineCache outlines_;             // of a lone upright outline
};

/// Where the cells of a brick lie, and a voxel beside. Voxels of a filled reading lie there too.
struct BrickBox {
  Vec3 low, high;
};
[[nodiscard]] BrickBox cells_of_brick(const Specimen& specimen, int brick) noexcept;

/// emit_removed() of one brick, within() said first.
void emit_removed_by_place(const Volume& volume, int brick, RegionClassifier& sink);

}  // namespace cusp::scenarios
