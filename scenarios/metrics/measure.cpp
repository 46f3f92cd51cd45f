#include "scenarios/metrics/measure.h"

#include <algorithm>
#include <cmath>

#include "engine/volume/cut_volume.h"
#include "scenarios/format/keys.h"
#include "scenarios/metrics/depth.h"
#include "scenarios/metrics/form.h"
#include "scenarios/metrics/groups.h"
#include "scenarios/metrics/margin.h"
#include "scenarios/metrics/protected_parts.h"
#include "scenarios/metrics/region_shares.h"
#include "scenarios/teeth/two_threads.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

namespace {

/// Half a voxel either way: where the pulp's outermost voxel ends.
constexpr double kPulpSigmaVoxels = 0.5;
/// The proxy stands within 1.6 µm of the exact one in the mean and 10 µm at worst (contact trials, 31 holes), times some
/// 3 N/mm of a device.
constexpr double kForceSigmaN = 0.03;
constexpr double kTickS = 0.001;
/// The target's own boundary, as a mean, whatever the reading: its line angles lose more than a cut surface does, as in volume.cpp
/// (measured: crown_test).
constexpr double kBoundaryVoxels = 2.0 * kBandedSigmaVoxels;
/// What the bricks' shares take of the time of a measurement (grade_times); the groups take the rest.
constexpr double kShareOfBricks = 0.5;

Measure measured(std::string metric, double value, double uncertainty, std::string unit,
                 std::optional<Vec3> where = std::nullopt) {
  return {std::move(metric), true, value, uncertainty, std::move(unit), where};
}

/// Of the cut faces that lie as near to the pulp as the measure is known, the one that shows it best.
class NearPulpSink final : public SolidSink {
 public:
  NearPulpSink(const Reference& reference, const Volume& volume, double within_mm)
      : reference_(reference), judge_(volume), within_mm_(within_mm) {}
  Evidence best;

  void cell(Vec3, Vec3) override {}
  void box(Vec3, Vec3, Tissue) override {}
  void tetrahedron(const std::array<Vec3, 4>&, double, Tissue) override {}
  void face(const std::array<Vec3, 3>& corners, double, Tissue) override {
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const double mm = reference_.pulp().distance_mm(middle, within_mm_);
    if (mm < within_mm_) judge_.offer(corners, FaceKind::any, -mm, best);
  }

 private:
  const Reference& reference_;
  FaceJudge judge_;
  double within_mm_;
};

void add_target(const Reference& reference, const Volume& volume, const RegionShares& sum, std::vector<Measure>& out) {
  constexpr auto kTarget = static_cast<std::size_t>(Place::target);
  const double whole = reference.target_mm3();
  // What stands is bounded by what was cut and by the target's own boundary, which the whole target has too.
  const double gone_mm2 = sum.target_boundary_mm2, standing_mm2 = std::max(0.0, reference.target_boundary_mm2() - gone_mm2);
  const double cut_mm3 = reference.surface_sigma_mm() * sum.cut_face_mm2[kTarget], boundary_mm = kBoundaryVoxels * volume.grid().voxel_mm;
  if (!(whole > 0.0)) {
    out.push_back(not_measured("target_removed", "%"));
  } else {
    const std::optional<Vec3> worst = standing_place(reference, volume);
    const double share = std::clamp(sum.removed_mm3[kTarget] / whole, 0.0, 1.0);
    // d(removed / whole): what is off in the part that is gone, and in the part that stands.
    const double sigma = cut_mm3 + boundary_mm * ((1.0 - share) * gone_mm2 + share * standing_mm2);
    out.push_back(measured("target_removed", 100.0 * share, 100.0 * sigma / whole, "%", worst));
  }
  constexpr std::array<std::pair<Place, const char*>, 4> kOver = {{{Place::tolerated_floor, "overcut_leeway_floor"},
                                                                  {Place::tolerated_side, "overcut_leeway_side"},
                                                                  {Place::beyond_floor, "overcut_beyond_floor"},
                                                                  {Place::beyond_side, "overcut_beyond_side"}}};
  for (const auto& [place, key] : kOver) {
    if (reference.shape().empty()) {
      out.push_back(not_measured(key, "mm3"));
      continue;
    }
    const auto i = static_cast<std::size_t>(place);
    out.push_back(measured(key, sum.removed_mm3[i], reference.surface_sigma_mm() * sum.cut_face_mm2[i], "mm3",
                           sum.worst[i].found() ? std::optional(sum.worst[i].at_mm) : std::nullopt));
  }
  if (!(whole > 0.0)) {
    out.push_back(not_measured("uncut_remainder", "mm3"));
  } else {
    out.push_back(measured("uncut_remainder", std::max(0.0, whole - sum.removed_mm3[kTarget]), cut_mm3 + boundary_mm * standing_mm2, "mm3", out.front().where_mm));
  }
}

void add_depth(const Reference& reference, const std::optional<FloorDepth>& depth, std::vector<Measure>& out) {
  if (!depth) {
    for (const char* key : {"depth_least", "depth_mean", "depth_most"}) out.push_back(not_measured(key, "mm"));
    return;
  }
  out.push_back(measured("depth_least", depth->least_mm, reference.point_sigma_mm(), "mm", depth->least_at_mm));
  out.push_back(measured("depth_mean", depth->mean_mm, reference.surface_sigma_mm(), "mm"));
  out.push_back(measured("depth_most", depth->most_mm, reference.point_sigma_mm(), "mm", depth->most_at_mm));
}

struct BrickShares {
  int brick = 0;
  RegionShares shares;
};

/// Ascending. A brick's shares depend on nothing else, so two threads find the same bits as one.
std::vector<BrickShares> shares_of_bricks(const Reference& reference, const Volume& volume, const MeasureProgress& progress) {
  const std::vector<int> bricks = bricks_to_measure(volume);
  std::vector<BrickShares> out(bricks.size());
  const auto one = [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    out[k] = {bricks[k], shares_of_brick(reference, volume, bricks[k])};
  };
  const int count = static_cast<int>(bricks.size());
  in_two_threads(count, one, [&](int i) {
    if (progress) progress(kShareOfBricks * (i + 1) / count);
  });
  return out;
}

void add_pulp(const Reference& reference, const Volume& volume, const RegionShares& sum,
              const std::vector<BrickShares>& bricks, std::vector<Measure>& out) {
  const std::optional<double> over_pulp = over_pulp_mm(reference, volume, sum);
  if (!over_pulp) {
    out.push_back(not_measured("remaining_over_pulp", "mm"));
  } else {
    const double sigma = kPulpSigmaVoxels * volume.grid().voxel_mm + reference.point_sigma_mm();
    NearPulpSink near(reference, volume, sum.pulp_mm + sigma);
    for (const BrickShares& one : bricks)
      if (one.shares.pulp_mm < sum.pulp_mm + sigma) emit_removed(volume, one.brick, near);
    const std::optional<Vec3> nearest = std::isfinite(sum.pulp_mm) ? std::optional(sum.pulp_at_mm) : std::nullopt;  // of a tooth that is gone whole none
    out.push_back(measured("remaining_over_pulp", *over_pulp, sigma, "mm", near.best.found() ? std::optional(near.best.at_mm) : nearest));
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

namespace {

/// What is measured of one cavity and of the attempt, but for several targets.
std::vector<Measure> measure_whole(const Reference& reference, const Volume& volume, const Process& process, const MeasureProgress& progress) {
  const std::vector<BrickShares> bricks = shares_of_bricks(reference, volume, progress);
  RegionShares sum;
  for (const BrickShares& one : bricks) sum.add(one.shares);

  std::vector<Measure> out;
  add_target(reference, volume, sum, out);
  const std::optional<FloorDepth> depth = floor_depth(reference, volume);
  add_depth(reference, depth, out);
  const CutFaces faces(reference, volume, depth);
  const std::vector<MarginPoint> margin = margin_points(volume);
  add_form(faces, margin, reference, volume, out);
  for (const Tissue tissue : reference.tissues()) {
    const std::size_t i = index_of(tissue);
    if (!reference.has(tissue)) {
      out.push_back(not_measured(removed_key(tissue), "mm3"));
      continue;
    }
    out.push_back(measured(removed_key(tissue), sum.tissue_mm3[i], tissue_sigma_mm3(reference, sum, tissue), "mm3"));
  }
  add_pulp(reference, volume, sum, bricks, out);
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
  if (const auto damage = protected_damage(reference, volume, sum)) {
    out.push_back(measured("protected_removed", damage->removed_mm3, damage->uncertainty_mm3, "mm3", damage->at_mm));
    out.push_back(measured("protected_damage", damage->damaged, 0.0, "", damage->at_mm));
  }
  if (reference.heat()) add_heat(process, out);
  add_groups(faces, margin, reference, volume, out);
  return out;
}

}  // namespace

std::vector<Measure> measure(const Reference& reference, const Volume& volume, const Process& process, const MeasureProgress& progress) {
  const auto targets = reference.targets().asked();
  const double each = 1.0 / static_cast<double>(targets.size() + 1);  // of the whole and of each target
  double begun = 0;
  const auto within = [&](double share) {
    if (progress) progress(begun + each * share);
  };
  std::vector<Measure> out = measure_whole(reference, volume, process, within);
  for (const SeveralTargets::One& one : targets) {
    begun += each;
    for (Measure& m : measure_whole(*one.reference, reference.targets().cavity(volume, one), process, within)) {
      if (!one.reference->asks(m.metric) && m.metric != "target_removed") continue;  // what was left out is graded by it
      m.metric = metric_key(m.metric, one.name);
      out.push_back(std::move(m));
    }
  }
  return out;
}

}  // namespace cusp::scenarios
