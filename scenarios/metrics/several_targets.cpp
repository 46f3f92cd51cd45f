#include "scenarios/metrics/several_targets.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/format/keys.h"
#include "scenarios/metrics/reference.h"

namespace cusp::scenarios {

namespace {

/// The exercise as if it had this target alone, with the criteria that name it.
Scenario alone(const Scenario& scenario, const Region& target) {
  Scenario out = scenario;
  out.target = target;
  out.target.name.clear();
  out.target.title.clear();
  out.protected_parts.clear();
  out.rubric.critical.clear();
  out.rubric.criteria.clear();
  for (const Criterion& c : scenario.rubric.criteria) {
    const auto [metric, name] = split_metric(c.metric);
    if (name != target.name) continue;
    out.rubric.criteria.push_back(c);
    out.rubric.criteria.back().metric = metric;
  }
  return out;
}

}  // namespace

std::vector<const Region*> asked_targets(const Scenario& scenario) {
  std::vector<const Region*> out = named_targets(scenario.target);
  std::erase_if(out, [&](const Region* one) {
    return std::ranges::none_of(scenario.rubric.criteria, [one](const Criterion& c) { return split_metric(c.metric).target == one->name; });
  });
  return out;
}

SeveralTargets::SeveralTargets(const Scenario& scenario, const std::shared_ptr<const Specimen>& specimen) {
  const std::vector<const Region*> asked = asked_targets(scenario);
  if (asked.empty()) return;
  rounding_mm_ = scenario.target.rounding_mm;
  for (const Region& part : scenario.target.parts) {
    if (std::ranges::find(asked, &part) != asked.end())
      asked_.push_back({part.name, parts_.size(), std::make_shared<const Reference>(alone(scenario, part), specimen)});
    parts_.emplace_back(part, specimen);
  }
}

double SeveralTargets::beyond_mm(std::size_t part, Vec3 p) const noexcept {
  const double own = parts_[part].distance_mm(p);
  double other = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < parts_.size(); ++i)
    if (i != part) other = std::min(other, parts_[i].distance_mm(p));
  return std::min(own, 0.5 * (own - other));
}

std::optional<std::size_t> SeveralTargets::only_part(Vec3 low, Vec3 high) const noexcept {
  const double reach = 0.51 * std::sqrt(glm::dot(high - low, high - low)) + rounding_mm_;
  std::optional<std::size_t> out;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i].distance_mm(0.5 * (low + high)) > reach) continue;
    if (out) return std::nullopt;
    out = i;
  }
  return out;
}

Volume SeveralTargets::cavity(const Volume& volume, const One& target) const {
  Volume out(volume.specimen_ptr());
  const Grid& grid = volume.grid();
  const bool filled = volume.specimen().reading() == Reading::filled;
  const double far_mm = (0.5 * std::sqrt(3.0) * (kBrickEdge - 1) + kBandVoxels) * grid.voxel_mm;
  for (const std::int32_t brick : volume.cut_bricks()) {
    const IVec3 first = kBrickEdge * volume.specimen().brick_at(brick);
    const double middle = beyond_mm(target.part, 0.5 * (grid.centre_mm(first) + grid.centre_mm(first + IVec3(kBrickEdge - 1))));
    if (middle > far_mm) continue;  // beyond_mm() changes by no more than its place
    const std::uint16_t* const cut = volume.cut_of(brick);
    std::uint16_t* const own = out.cut_for_writing(brick);
    for (int o = 0; o < kBrickVoxels; ++o) {
      const double beyond =
          middle < -far_mm ? middle : beyond_mm(target.part, grid.centre_mm(first + IVec3(o & 7, o >> 3 & 7, o >> 6)));
      if (!filled) own[o] = std::max(cut[o], solid_from_distance(-beyond / grid.voxel_mm));
      else if (beyond <= 0.0) own[o] = cut[o];
    }
    out.touched(brick);
  }
  return out;
}

}  // namespace cusp::scenarios
