#include "scenarios/metrics/measure.h"

#include <algorithm>
#include <cmath>

#include "scenarios/metrics/depth.h"
#include "scenarios/metrics/region_shares.h"

namespace cusp {

namespace {

/// Rms distance of a plane from the nearest voxel border: how a border between tissues is known.
constexpr double kSeamSigmaVoxels = 0.2887;  // 1 / sqrt(12)
/// Half a voxel either way: where the pulp's outermost voxel ends.
constexpr double kPulpSigmaVoxels = 0.5;
/// The proxy stands within 1.6 µm of the exact one in the mean and 10 µm at worst (contact trials, 31 holes), times some
/// 3 N/mm of a device.
constexpr double kForceSigmaN = 0.03;
constexpr double kTickS = 0.001;

Measure measured(std::string metric, double value, double uncertainty, std::string unit,
                 std::optional<Vec3> where = std::nullopt) {
  return {std::move(metric), true, value, uncertainty, std::move(unit), where};
}
Measure not_measured(std::string metric, std::string unit) {
  return {std::move(metric), false, 0.0, 0.0, std::move(unit), std::nullopt};
}

/// The voxel still standing that lies deepest inside the target.
std::optional<Vec3> deepest_standing(const Reference& reference, const Volume& volume) {
  const TargetShape& shape = reference.shape();
  const Grid& grid = volume.grid();
  const auto voxel = [&](Vec3 p) { return IVec3(glm::floor((p - grid.origin_mm) / grid.voxel_mm + 0.5)); };
  const IVec3 low = glm::max(voxel({shape.low().x, shape.low().y, shape.floor_mm()}), IVec3(0));
  const IVec3 high = glm::min(voxel({shape.high().x, shape.high().y, 0.0}), grid.size - 1);
  double deepest = 0.0;
  std::optional<Vec3> out;
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x) {
      const Vec3 foot = grid.centre_mm({x, y, low.z});
      const double u = shape.outline_mm({foot.x, foot.y});
      if (u >= deepest) continue;
      for (int z = low.z; z < grid.size.z; ++z) {
        if (!volume.occupied({x, y, z})) continue;
        const Vec3 p = grid.centre_mm({x, y, z});
        const double d = rounded_corner(u, shape.below_floor_mm(p.z), shape.corner_mm());
        if (d < deepest) {
          deepest = d;
          out = p;
        }
      }
    }
  return out;
}

/// A pulp voxel that is gone, or whose neighbour across a face is gone.
std::optional<Vec3> exposed_pulp(const Reference& reference, const Volume& volume) {
  const Specimen& specimen = volume.specimen();
  const bool filled = specimen.reading() == Reading::filled;
  const auto gone = [&](IVec3 v) {
    return (filled ? specimen.s(v) > 0 : specimen.s(v) >= kHalf) && !volume.occupied(v);
  };
  for (const IVec3 v : reference.pulp().surface_voxels()) {
    bool open = gone(v);
    for (int axis = 0; axis < 3 && !open; ++axis)
      for (int step = -1; step <= 1; step += 2) {
        IVec3 next = v;
        next[axis] += step;
        open = open || gone(next);
      }
    if (open) return volume.grid().centre_mm(v);
  }
  return std::nullopt;
}

void add_target(const Reference& reference, const Volume& volume, const RegionShares& sum, std::vector<Measure>& out) {
  constexpr auto kTarget = static_cast<std::size_t>(Place::target);
  const double whole = reference.target_mm3();
  if (!(whole > 0.0)) {
    out.push_back(not_measured("target_removed", "%"));
  } else {
    const double sigma = reference.surface_sigma_mm() * sum.cut_face_mm2[kTarget];
    const std::optional<Vec3> worst = deepest_standing(reference, volume);
    const double share = std::clamp(sum.removed_mm3[kTarget] / whole, 0.0, 1.0);
    out.push_back(measured("target_removed", 100.0 * share, 100.0 * sigma / whole, "%", worst));
  }
  constexpr std::array<std::pair<Place, const char*>, 4> kOver = {{{Place::leeway_floor, "overcut_leeway_floor"},
                                                                  {Place::leeway_side, "overcut_leeway_side"},
                                                                  {Place::beyond_floor, "overcut_beyond_floor"},
                                                                  {Place::beyond_side, "overcut_beyond_side"}}};
  for (const auto& [place, key] : kOver) {
    if (reference.shape().empty()) {
      out.push_back(not_measured(key, "mm3"));
      continue;
    }
    const auto i = static_cast<std::size_t>(place);
    out.push_back(measured(key, sum.removed_mm3[i], reference.surface_sigma_mm() * sum.cut_face_mm2[i], "mm3",
                           sum.worst[i].mm > 0.0 ? std::optional(sum.worst[i].at_mm) : std::nullopt));
  }
  if (!(whole > 0.0)) {
    out.push_back(not_measured("undercut", "mm3"));
  } else {
    out.push_back(measured("undercut", std::max(0.0, whole - sum.removed_mm3[kTarget]),
                           reference.surface_sigma_mm() * sum.cut_face_mm2[kTarget], "mm3", out.front().where_mm));
  }
}

void add_depth(const Reference& reference, const Volume& volume, std::vector<Measure>& out) {
  const std::optional<FloorDepth> depth = floor_depth(reference, volume);
  if (!depth) {
    for (const char* key : {"depth_least", "depth_mean", "depth_most"}) out.push_back(not_measured(key, "mm"));
    return;
  }
  out.push_back(measured("depth_least", depth->least_mm, reference.point_sigma_mm(), "mm", depth->least_at_mm));
  out.push_back(measured("depth_mean", depth->mean_mm, reference.surface_sigma_mm(), "mm"));
  out.push_back(measured("depth_most", depth->most_mm, reference.point_sigma_mm(), "mm", depth->most_at_mm));
}

void add_pulp(const Reference& reference, const Volume& volume, const RegionShares& sum, std::vector<Measure>& out) {
  if (reference.pulp().empty() || !std::isfinite(sum.pulp_mm)) {
    out.push_back(not_measured("remaining_over_pulp", "mm"));
  } else {
    const double sigma = kPulpSigmaVoxels * volume.grid().voxel_mm + reference.point_sigma_mm();
    out.push_back(measured("remaining_over_pulp", sum.pulp_mm, sigma, "mm", sum.pulp_at_mm));
  }
  if (reference.pulp().empty()) {
    out.push_back(not_measured("pulp_exposure", ""));
  } else {
    const std::optional<Vec3> at = exposed_pulp(reference, volume);
    out.push_back(measured("pulp_exposure", at ? 1.0 : 0.0, 0.0, "", at));
  }
}

void add_heat(const Process& process, std::vector<Measure>& out) {
  if (!(process.time_s() > 0.0)) {
    out.push_back(not_measured("dry_cutting_time", "s"));
    out.push_back(not_measured("temperature_rise_peak", "K"));
    out.push_back(not_measured("dry_cutting", ""));
    return;
  }
  const int events = process.overheated();
  out.push_back(measured("dry_cutting_time", process.dry_s(), kTickS, "s"));
  out.push_back(measured("temperature_rise_peak", process.heat_peak_k(), 0.0, "K",
                         process.heat_peak_k() > 0.0 ? std::optional(process.heat_peak_at_mm()) : std::nullopt));
  out.push_back(measured("dry_cutting", events, 0.0, "",
                         events > 0 ? std::optional(process.overheated_at_mm()) : std::nullopt));
}

}  // namespace

std::string removed_key(Tissue tissue) {
  const std::size_t i = index_of(tissue);
  return "removed_" + (i < kTissueKeys.size() ? std::string(kTissueKeys[i]) : std::to_string(i));
}

std::vector<Measure> measure(const Reference& reference, const Volume& volume, const Process& process) {
  RegionShares sum;
  for (const int brick : bricks_to_measure(volume)) sum.add(shares_of_brick(reference, volume, brick));

  std::vector<Measure> out;
  add_target(reference, volume, sum, out);
  add_depth(reference, volume, out);
  for (const Tissue tissue : reference.tissues()) {
    const std::size_t i = index_of(tissue);
    if (!reference.has(tissue)) {
      out.push_back(not_measured(removed_key(tissue), "mm3"));
      continue;
    }
    const double sigma = reference.surface_sigma_mm() * sum.tissue_face_mm2[i] +
                         kSeamSigmaVoxels * volume.grid().voxel_mm * sum.tissue_seam_mm2[i];
    out.push_back(measured(removed_key(tissue), sum.tissue_mm3[i], sigma, "mm3"));
  }
  add_pulp(reference, volume, sum, out);
  if (process.time_s() > 0.0)
    out.push_back(measured("time", process.time_s(), kTickS, "s"));
  else
    out.push_back(not_measured("time", "s"));
  if (process.touched()) {
    out.push_back(measured("force_peak", process.force_peak_n(), kForceSigmaN, "N", process.peak_at_mm()));
    out.push_back(measured("force_mean", process.force_mean_n(), kForceSigmaN, "N"));
  } else {
    out.push_back(not_measured("force_peak", "N"));
    out.push_back(not_measured("force_mean", "N"));
  }
  if (reference.heat()) add_heat(process, out);
  return out;
}

}  // namespace cusp
