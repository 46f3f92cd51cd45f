#include "scenarios/metrics/reference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenarios/format/keys.h"
#include "scenarios/landmarks/landmarks.h"
#include "scenarios/landmarks/propose.h"
#include "scenarios/metrics/region_classifier.h"
#include "scenarios/teeth/own_tissues.h"
#include "scenarios/teeth/tooth.h"

namespace cusp::scenarios {

namespace {

/// Adds up what lies in the target.
class TargetSum final : public RegionClassifier {
 public:
  using RegionClassifier::RegionClassifier;
  double mm3 = 0;
  using RegionClassifier::boundary_mm2;
  void face(const std::array<Vec3, 3>&, double, Tissue) override {}

 private:
  void solid(Place place, double volume, Tissue) override {
    if (place == Place::target) mm3 += volume;
  }
};

TissueSet only(Tissue tissue) noexcept {
  TissueSet out{};
  out[index_of(tissue)] = true;
  return out;
}

}  // namespace

Reference::Reference(const Scenario& scenario, std::shared_ptr<const Specimen> specimen)
    : specimen_(std::move(specimen)), shape_(scenario.target, specimen_), targets_(scenario, specimen_), leeway_(scenario.leeway), pulp_(specimen_, only(Tissue::pulp)),
      fdi_(scenario.specimen.grown_fdi()), seed_(scenario.specimen.seed),
      marked_(scenario.specimen.landmarks), heat_(has_phenomenon(scenario.phenomena, "heat")), one_with_neighbours_(scenario.specimen.is_one_with_neighbours()),
      mesial_x_(fdi_ != 0 ? scenarios::mesial_x(fdi_) : mesial_x_of(marked_)) {
  for (const Criterion& c : scenario.rubric.criteria)
    if (split_metric(c.metric).target.empty()) asked_.push_back(c.metric);
  for (const std::string& key : scenario.rubric.critical) asked_.push_back(key);
  for (const ScenarioTissue& t : scenario.tissues) tissues_.push_back(t.tissue);
  for (const Protected& one : scenario.protected_parts)
    protected_parts_.push_back({one.tissue.value_or(Tissue::empty), one.region ? std::make_shared<const TargetShape>(*one.region, specimen_) : nullptr,
                                one.severity, one.depth_mm});
  const IVec3 bricks = specimen_->brick_count();
  TargetSum sum(shape_, leeway_);
  for (int b = 0; b < bricks.x * bricks.y * bricks.z; ++b) {
    if (specimen_->uniform(b)) {
      present_[index_of(specimen_->tissue_in(b, 0))] = true;
    } else {
      for (int o = 0; o < kBrickVoxels; ++o)
        if (specimen_->s_in(b, o) >= kHalf) present_[index_of(specimen_->tissue_in(b, o))] = true;
    }
    const BrickBox cells = cells_of_brick(*specimen_, b);
    if (shape_.empty() || !sum.within(cells.low, cells.high)) continue;
    emit_specimen(*specimen_, b, sum);
  }
  present_[index_of(Tissue::empty)] = false;
  target_mm3_ = sum.mm3;
  target_boundary_mm2_ = sum.boundary_mm2();
}

bool Reference::asks(std::string_view start) const noexcept {
  return std::ranges::any_of(asked_, [start](const std::string& key) { return key.starts_with(start); });
}

const std::vector<SurfacePatch>& Reference::target_surface() const {
  std::call_once(later_->surface_once, [&] {
    if (!shape_.empty()) later_->surface = scenarios::target_surface(shape_, specimen_);
  });
  return later_->surface;
}

const VoxelIndex& Reference::shell() const {
  std::call_once(later_->shell_once, [&] {
    TissueSet tissues{};
    for (const Tissue t : {Tissue::enamel, Tissue::carious_enamel, Tissue::cementum}) tissues[index_of(t)] = true;
    later_->shell.emplace(*specimen_, tissues);
  });
  return *later_->shell;
}

const TissueShape& Reference::dentine() const {
  std::call_once(later_->dentine_once, [&] {
    TissueSet tissues{};
    for (const Tissue t : {Tissue::dentine, Tissue::carious_dentine, kFirmCariousDentine}) tissues[index_of(t)] = true;
    later_->dentine.emplace(specimen_, tissues);
  });
  return *later_->dentine;
}

const ToothLandmarks* Reference::landmarks() const {
  std::call_once(later_->landmarks_once, [&] {
    if (fdi_ == 0) {
      if (!marked_.marks.empty()) later_->landmarks = as_grown(marked_);
      return;
    }
    if (auto found = tooth_landmarks({.fdi = fdi_, .seed = seed_})) later_->landmarks = std::move(*found);
  });
  return later_->landmarks ? &*later_->landmarks : nullptr;
}

double Reference::landmark_sigma_mm(MarkKind kind) const noexcept {
  const auto proposed = [kind](const Landmark& one) { return one.kind == kind && one.state == MarkState::proposed; };
  return std::ranges::any_of(marked_.marks, proposed) ? proposal_error(kind, specimen_->grid().voxel_mm) : 0.0;
}

double Reference::surface_sigma_mm() const noexcept {
  return (specimen_->reading() == Reading::filled ? kFilledSigmaVoxels : kBandedSigmaVoxels) * specimen_->grid().voxel_mm;
}
double Reference::point_sigma_mm() const noexcept {
  return (specimen_->reading() == Reading::filled ? kFilledSigmaVoxels : kBandedPointVoxels) * specimen_->grid().voxel_mm;
}

}  // namespace cusp::scenarios
