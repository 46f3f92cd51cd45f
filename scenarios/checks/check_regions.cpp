#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "scenarios/checks/checks.h"
#include "scenarios/format/keys.h"
#include "scenarios/shapes/place.h"

namespace cusp::scenarios {
namespace {

/// Less pulp in a target is a horn that it opens, not a chamber that it gives access to [M]: a chamber holds ten times that.
constexpr double kLeastAccessMm3 = 1.0;

struct Reached {
  double target_mm3 = 0;  // of the tissue within the target
  double deepest_mm = 0;  // of it, below the target's surface
  double nearest_mm = 1e9;
  bool in_zone = false;
};

/// Calls visit(voxel, centre, near) of each solid voxel in or about the target.
template <class Visit>
void each_near(const Scenario& scenario, const Specimen& specimen, Visit&& visit) {
  const TargetShape shape(scenario.target, lent(specimen));
  if (shape.empty()) return;
  const Grid& grid = specimen.grid();
  const double side = scenario.leeway.most() + grid.voxel_mm;
  const auto voxel = [&](Vec3 p) { return IVec3(glm::floor((p - grid.origin_mm) / grid.voxel_mm)); };
  const IVec3 low = glm::max(voxel({shape.low().x - side, shape.low().y - side, shape.floor_mm() - side}), IVec3(0));
  const IVec3 high = glm::min(voxel({shape.high().x + side, shape.high().y + side, 0.0}) + 1, grid.size - 1);
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x) {
      const Vec3 foot = grid.centre_mm({x, y, low.z});
      if (shape.upright() != nullptr && shape.outline_mm({foot.x, foot.y}) > side) continue;
      for (int z = low.z; z < grid.size.z; ++z) {
        const IVec3 v(x, y, z);
        if (specimen.s(v) >= kHalf) visit(v, grid.centre_mm(v), shape.near(grid.centre_mm(v)));
      }
    }
}

void add(Reached& to, const Near& near, const Scenario& scenario, double voxel_mm3) {
  const double d = near.distance_mm;
  to.nearest_mm = std::min(to.nearest_mm, d);
  if (d < 0.0) {
    to.target_mm3 += voxel_mm3;
    to.deepest_mm = std::max(to.deepest_mm, -near.floor_mm);
  } else {
    const Place place = place_of(near, scenario.leeway);
    to.in_zone = to.in_zone || place == Place::tolerated_floor || place == Place::tolerated_side;
  }
}

/// What of each tissue lies in the target and its tolerance zone, by voxels' centres.
std::array<Reached, kTissueCodes> reached_by(const Scenario& scenario, const Specimen& specimen) {
  std::array<Reached, kTissueCodes> out;
  const double voxel_mm3 = std::pow(specimen.grid().voxel_mm, 3);
  each_near(scenario, specimen, [&](IVec3 v, Vec3, const Near& near) { add(out[index_of(specimen.tissue(v))], near, scenario, voxel_mm3); });
  return out;
}

/// The same of a protected region, of what lies deep enough in it to be damage.
Reached reached_of(const Protected& one, const Scenario& scenario, const Specimen& specimen) {
  const TargetShape region(*one.region, lent(specimen));
  const double least = one.severity == Damage::depth ? one.depth_mm : 0.0, voxel_mm3 = std::pow(specimen.grid().voxel_mm, 3);
  Reached out;
  each_near(scenario, specimen, [&](IVec3, Vec3 centre, const Near& near) {
    if (near.distance_mm <= scenario.leeway.most() && region.distance_mm(centre) < -least) add(out, near, scenario, voxel_mm3);
  });
  return out;
}

/// The tissue that is protected, by itself or as a region; empty for any other region.
Tissue tissue_of(const Protected& one) {
  if (one.tissue) return *one.tissue;
  return one.region && one.region->kind == RegionKind::tissue ? one.region->tissue : Tissue::empty;
}

void check_pulp(const Scenario& scenario, const Reached& pulp, std::vector<Finding>& out) {
  const bool there = std::ranges::any_of(scenario.tissues, [](const ScenarioTissue& t) { return t.tissue == Tissue::pulp; });
  if (!there) return;
  const bool rule = std::ranges::find(scenario.rubric.critical, "pulp_exposure") != scenario.rubric.critical.end();
  if (pulp.target_mm3 > 0.0) {
    if (rule || pulp.target_mm3 < kLeastAccessMm3)
      out.push_back({Severity::error, "/target/depth_mm", "target_opens_pulp", {{"value", pulp.deepest_mm}}, rule ? "rule" : "horn"});
    else
      out.push_back({Severity::warning, "/target/depth_mm", "target_holds_pulp", {{"value", pulp.target_mm3}}, {}});
    return;
  }
  if (!rule) out.push_back({Severity::warning, "/rubric/critical", "pulp_rule_off", {}, {}});
  if (pulp.in_zone)
    out.push_back({Severity::warning, "/leeway/floor_mm", "leeway_opens_pulp", {{"value", pulp.nearest_mm}}, {}});
}

/// A tissue of speed 0 within the target stays there whatever a student does.
void check_speeds(const Scenario& scenario, const std::array<Reached, kTissueCodes>& reached, std::vector<Finding>& out) {
  for (std::size_t i = 0; i < scenario.tissues.size(); ++i) {
    const ScenarioTissue& one = scenario.tissues[i];
    const double held = reached[index_of(one.tissue)].target_mm3;
    if (one.speed_mm_s > 0.0 || !(held > 0.0)) continue;
    out.push_back({Severity::error, "/tissues/" + std::to_string(i) + "/speed_mm_s", "target_uncuttable", {{"value", held}},
                   std::string(key_of_scenario_tissue(one.tissue))});
  }
}

}  // namespace

std::vector<Finding> check_regions(const Scenario& scenario, const Specimen& specimen) {
  std::vector<Finding> out;
  const auto reached = reached_by(scenario, specimen);
  check_pulp(scenario, reached[index_of(Tissue::pulp)], out);
  double all = 0;
  for (const Reached& r : reached) all += r.target_mm3;
  if (!(all > 0.0)) out.push_back({Severity::error, "/target/paths", "target_without_tissue", {}, {}});
  check_speeds(scenario, reached, out);
  for (std::size_t i = 0; i < scenario.protected_parts.size(); ++i) {
    const Protected& one = scenario.protected_parts[i];
    const Tissue tissue = tissue_of(one);
    if (tissue == Tissue::pulp || (tissue == Tissue::empty && !one.region)) continue;
    const Reached here = one.region ? reached_of(one, scenario, specimen) : reached[index_of(tissue)];
    const std::string path = "/protected/" + std::to_string(i), key(tissue == Tissue::empty ? "region" : key_of_scenario_tissue(tissue));
    if (here.target_mm3 > 0.0)
      out.push_back({Severity::error, path, "target_cuts_protected", {{"value", here.target_mm3}}, key});
    else if (here.in_zone)
      out.push_back({Severity::warning, path, "leeway_cuts_protected", {{"value", here.nearest_mm}}, key});
  }
  return out;
}

}  // namespace cusp::scenarios
