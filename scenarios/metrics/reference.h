/// What a final volume is measured against: target, tolerance zone, the target's own volume in the untouched specimen, and the
/// pulp. Built once an exercise, shared by the live scores and the final measures. Immutable; any thread.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "engine/volume/specimen.h"
#include "scenarios/format/scenario.h"
#include "scenarios/modules.h"
#include "scenarios/shapes/place.h"

namespace cusp::scenarios {

/// How well the surface of a cut is known, in voxels, one-sided (measured: README, "Uncertainty").
inline constexpr double kBandedSigmaVoxels = 0.01;  // as a mean over a face
inline constexpr double kBandedPointVoxels = 0.1;   // at one place, which may be a ridge between two passes
inline constexpr double kFilledSigmaVoxels = 0.5;   // a voxel stands until the last of it is worn

/// The pulp's outermost voxels, for the distance from a cut to it. The pulp is known to a voxel, as all tissues are.
class PulpIndex {
 public:
  explicit PulpIndex(const Specimen& specimen);
  bool empty() const noexcept { return voxels_.empty(); }
  /// Distance from a place to the nearest pulp voxel (as a cube), 0 inside it; at most `at_most_mm`, which is also the
  /// answer without a pulp: the search stops there.
  double distance_mm(Vec3 p, double at_most_mm) const noexcept;
  const std::vector<IVec3>& surface_voxels() const noexcept { return voxels_; }

 private:
  /// Box round what lies below; a leaf holds voxels, a branch its two halves.
  struct Node {
    Vec3 low, high;                     // mm, round the voxels' cubes
    std::size_t first = 0, last = 0;    // leaf: in voxels_
    std::int32_t left = -1, right = -1; // branch: in nodes_
  };
  std::int32_t grow(std::span<Node> leaves);

  Grid grid_;
  std::vector<IVec3> voxels_;
  std::vector<Node> nodes_;
  std::int32_t root_ = -1;
};

/// A tissue or a region that an attempt is to spare.
struct ProtectedPart {
  Tissue tissue = Tissue::empty;
  std::shared_ptr<const TargetShape> shape;  // none: the tissue
  Damage severity = Damage::removal;
  double depth_mm = 0;
};

class Reference {
 public:
  /// Tens of milliseconds. Not for the haptic thread. Pre: the specimen is the scenario's, in its method's reading.
  Reference(const Scenario& scenario, std::shared_ptr<const Specimen> specimen);

  const Specimen& specimen() const noexcept { return *specimen_; }
  const TargetShape& shape() const noexcept { return shape_; }
  const Leeway& leeway() const noexcept { return leeway_; }
  const PulpIndex& pulp() const noexcept { return pulp_; }
  /// 1 if mesial lies along +x, -1 if along -x, 0 if the specimen is no tooth of a known number.
  int mesial_x() const noexcept { return mesial_x_; }
  const std::vector<Tissue>& tissues() const noexcept { return tissues_; }  // of the scenario, in its order
  /// Tissue within the target before anything was cut, mm³.
  double target_mm3() const noexcept { return target_mm3_; }
  const std::vector<ProtectedPart>& protected_parts() const noexcept { return protected_parts_; }
  bool heat() const noexcept { return heat_; }  // the scenario reckons coolant and warmth
  bool has(Tissue tissue) const noexcept { return present_[index_of(tissue)]; }
  double surface_sigma_mm() const noexcept;  // of a face's mean place
  double point_sigma_mm() const noexcept;    // of one place

 private:
  std::shared_ptr<const Specimen> specimen_;
  TargetShape shape_;
  Leeway leeway_;
  PulpIndex pulp_;
  std::vector<Tissue> tissues_;
  std::vector<ProtectedPart> protected_parts_;
  std::array<bool, kTissueCodes> present_{};
  double target_mm3_ = 0;
  bool heat_ = false;
  int mesial_x_ = 0;
};

}  // namespace cusp::scenarios
