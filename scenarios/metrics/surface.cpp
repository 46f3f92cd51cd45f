#include "scenarios/metrics/surface.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/volume/cut_volume.h"
#include "scenarios/metrics/region_shares.h"
#include "scenarios/metrics/triangle_index.h"

namespace cusp::scenarios {

namespace {

/// Further off than any cut of one tooth.
constexpr double kFarMm = 20.0;
/// A sharp corner of the cut is rounded by the field: the greatest distance ends at one (measured: groups_test).
constexpr double kGreatestVoxels = 0.25;
/// The same moves the line where the distance reaches a tolerance, by so much of a place's uncertainty.
constexpr double kEdgeFactor = 1.5;

class TriangleSink final : public SolidSink {
 public:
  std::vector<Triangle> triangles;
  void cell(Vec3, Vec3) override {}
  void box(Vec3, Vec3, Tissue) override {}
  void tetrahedron(const std::array<Vec3, 4>&, double, Tissue) override {}
  void face(const std::array<Vec3, 3>& corners, double mm2, Tissue) override {
    if (mm2 > 0.0) triangles.push_back(corners);
  }
};

struct Distance {
  double mm, mm2;
};

/// Distances of places that lie beside each other: the last one bounds the next.
class Nearest {
 public:
  explicit Nearest(const TriangleIndex& index) : index_(index) {}
  double from(Vec3 p) noexcept {
    const Vec3 way = p - at_;
    constexpr double kRounding = 1e-9;
    const double bound = std::min(kFarMm, mm_ + std::sqrt(glm::dot(way, way)) + kRounding);
    at_ = p;
    return mm_ = index_.distance_mm(p, bound);
  }

 private:
  const TriangleIndex& index_;
  Vec3 at_{0.0};
  double mm_ = kFarMm;
};

/// Share of the area whose distance is at most x. Pre: `sorted` by distance.
double share_within(const std::vector<Distance>& sorted, const std::vector<double>& up_to, double x) {
  const auto end = std::ranges::upper_bound(sorted, x, {}, &Distance::mm);
  const auto count = static_cast<std::size_t>(end - sorted.begin());
  return count == 0 ? 0.0 : up_to[count - 1] / up_to.back();
}

}  // namespace

std::optional<SurfaceMatch> surface_match(const Reference& reference, const Volume& volume) {
  if (reference.specimen().reading() == Reading::filled || volume.cut_bricks().empty()) return std::nullopt;
  const std::vector<SurfacePatch>& target = reference.target_surface();
  TriangleSink sink;
  for (const int brick : bricks_to_measure(volume)) emit_removed(volume, brick, sink);
  if (target.empty() || sink.triangles.empty()) return std::nullopt;
  const TriangleIndex cut(std::move(sink.triangles), volume.grid().voxel_mm);
  SurfaceMatch out;
  std::vector<Distance> all;
  double squares = 0, area = 0;
  Nearest nearest(cut);
  for (const SurfacePatch& patch : target) {
    const Vec3 middle = patch.middle();
    const double mm = nearest.from(middle);
    all.push_back({mm, patch.mm2});
    squares += patch.mm2 * mm * mm;
    area += patch.mm2;
    for (const Vec3& corner : patch.corners) {
      const Vec3 off = corner - middle;
      if (mm + std::sqrt(glm::dot(off, off)) <= out.greatest_mm) continue;  // a distance changes by no more than its place
      const double there = nearest.from(corner);
      if (there <= out.greatest_mm) continue;
      out.greatest_mm = there;
      out.greatest_at_mm = corner;
    }
  }
  std::ranges::stable_sort(all, {}, &Distance::mm);
  std::vector<double> up_to;
  for (const Distance& one : all) up_to.push_back((up_to.empty() ? 0.0 : up_to.back()) + one.mm2);
  const double sigma = kEdgeFactor * reference.point_sigma_mm();
  for (std::size_t i = 0; i < kToleranceUm.size(); ++i) {
    const double x = 1e-3 * kToleranceUm[i];
    out.share[i] = share_within(all, up_to, x);
    out.share_uncertainty[i] = std::max(share_within(all, up_to, x + sigma) - out.share[i], out.share[i] - share_within(all, up_to, x - sigma));
  }
  out.rms_mm = std::sqrt(squares / area);
  const auto p95 = std::ranges::lower_bound(up_to, 0.95 * up_to.back());
  out.p95_mm = all[static_cast<std::size_t>(p95 - up_to.begin())].mm;
  out.uncertainty_mm = reference.point_sigma_mm();
  out.greatest_uncertainty_mm = kGreatestVoxels * reference.specimen().grid().voxel_mm;
  return out;
}

void add_surface(const Reference& reference, const Volume& volume, std::vector<Measure>& out) {
  const std::optional<SurfaceMatch> match = surface_match(reference, volume);
  for (std::size_t i = 0; i < kToleranceUm.size(); ++i) {
    std::string key = "surface_within_" + std::to_string(kToleranceUm[i]);
    if (match) out.push_back({std::move(key), true, 100.0 * match->share[i], 100.0 * match->share_uncertainty[i], "%", match->greatest_at_mm});
    else out.push_back(not_measured(std::move(key), "%"));
  }
  const auto add = [&](const char* key, double SurfaceMatch::* mm, double SurfaceMatch::* uncertainty) {
    if (match) out.push_back({key, true, (*match).*mm, (*match).*uncertainty, "mm", match->greatest_at_mm});
    else out.push_back(not_measured(key, "mm"));
  };
  add("surface_rms", &SurfaceMatch::rms_mm, &SurfaceMatch::uncertainty_mm);
  add("surface_p95", &SurfaceMatch::p95_mm, &SurfaceMatch::uncertainty_mm);
  add("surface_greatest", &SurfaceMatch::greatest_mm, &SurfaceMatch::greatest_uncertainty_mm);
}

}  // namespace cusp::scenarios
