/// What a final volume is measured against: target, tolerance zone, the target's own volume in the untouched specimen, and the
/// pulp. Built once an exercise, shared by the live scores and the final measures. Immutable; any thread.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/format/scenario.h"
#include "scenarios/metrics/several_targets.h"
#include "scenarios/metrics/target_surface.h"
#include "scenarios/modules.h"
#include "scenarios/shapes/border_surface.h"
#include "scenarios/shapes/place.h"
#include "scenarios/shapes/tissue_shape.h"
#include "scenarios/shapes/voxel_index.h"
#include "scenarios/teeth/landmarks.h"

namespace cusp::scenarios {

/// How well the surface of a cut is known, in voxels, one-sided (measured: README, "Uncertainty").
inline constexpr double kBandedSigmaVoxels = 0.01;  // as a mean over a face
inline constexpr double kBandedPointVoxels = 0.1;   // at one place, which may be a ridge between two passes
inline constexpr double kFilledSigmaVoxels = 0.5;   // a voxel stands until the last of it is worn

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
  const BorderSurface& pulp() const noexcept { return pulp_; }
  /// 1 if mesial lies along +x, -1 if along -x, 0 if the specimen is no tooth of a known number, or a turned one (scenarios/landmarks).
  int mesial_x() const noexcept { return mesial_x_; }
  /// Of the tooth generator: a neighbour has codes of its own, and the tooth stands about the frame's origin.
  bool is_grown() const noexcept { return fdi_ != 0; }
  /// SpecimenSource::is_one_with_neighbours().
  bool is_one_with_neighbours() const noexcept { return one_with_neighbours_; }
  const std::vector<Tissue>& tissues() const noexcept { return tissues_; }  // of the scenario, in its order
  /// Tissue within the target before anything was cut, mm³.
  double target_mm3() const noexcept { return target_mm3_; }
  /// The target's own boundary within the untouched specimen, mm².
  double target_boundary_mm2() const noexcept { return target_boundary_mm2_; }
  /// Of one exercise's several targets those that the rubric asks for by name.
  const SeveralTargets& targets() const noexcept { return targets_; }
  const std::vector<ProtectedPart>& protected_parts() const noexcept { return protected_parts_; }
  bool heat() const noexcept { return heat_; }  // the scenario reckons coolant and warmth
  bool has(Tissue tissue) const noexcept { return present_[index_of(tissue)]; }
  /// Whether the rubric has a criterion of the whole target, or a critical event, whose key begins so: what nobody asks for is not
  /// computed.
  bool asks(std::string_view start) const noexcept;
  /// Made at the first call, which may take tenths of a second; any thread. Of an empty target or a filled reading empty.
  const std::vector<SurfacePatch>& target_surface() const;
  /// Enamel and cementum, sound or carious: what dentine lies under. As above.
  const VoxelIndex& shell() const;
  /// Sound and carious dentine, with its signed distance. As above.
  const TissueShape& dentine() const;
  /// Of the grown tooth, or those that a tooth from a file is marked with; nullptr where there are none. As above.
  const ToothLandmarks* landmarks() const;
  /// How well a landmark is known: 0 of a grown tooth and of what the author set.
  double landmark_sigma_mm(MarkKind kind) const noexcept;
  double surface_sigma_mm() const noexcept;  // of a face's mean place
  double point_sigma_mm() const noexcept;    // of one place

 private:
  std::shared_ptr<const Specimen> specimen_;
  TargetShape shape_;
  SeveralTargets targets_;
  Leeway leeway_;
  BorderSurface pulp_;
  std::vector<Tissue> tissues_;
  std::vector<ProtectedPart> protected_parts_;
  std::array<bool, kTissueCodes> present_{};
  double target_mm3_ = 0, target_boundary_mm2_ = 0;
  /// What is made once, when it is first asked for.
  struct Later {
    std::once_flag surface_once, shell_once, dentine_once, landmarks_once;
    std::vector<SurfacePatch> surface;
    std::optional<VoxelIndex> shell;
    std::optional<TissueShape> dentine;
    std::optional<ToothLandmarks> landmarks;
  };

  std::vector<std::string> asked_;
  std::shared_ptr<Later> later_ = std::make_shared<Later>();
  int fdi_ = 0;  // 0: no grown tooth
  std::uint64_t seed_ = 0;
  SpecimenLandmarks marked_;  // of a tooth from a file
  bool heat_ = false, one_with_neighbours_ = false;
  int mesial_x_ = 0;
};

}  // namespace cusp::scenarios
