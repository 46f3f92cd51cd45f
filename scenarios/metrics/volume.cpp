#include "scenarios/metrics/volume.h"

#include <string>

#include "scenarios/metrics/region_classifier.h"
#include "scenarios/metrics/region_shares.h"

namespace cusp::scenarios {

namespace {

/// Of a volume that an edge between two faces divides, this share may lie on the wrong side (measured: groups_test).
constexpr double kEdgeShare = 0.1;

/// A single face has its line angles alone, which lose more than the mean of a cavity's surface does.
constexpr double kFaceFactor = 2.0;

class FaceVolumes final : public RegionClassifier {
 public:
  FaceVolumes(const Reference& reference, OvercutByFace& sums)
      : RegionClassifier(reference.shape(), reference.leeway(), ByFace::yes), reference_(reference), sums_(sums) {}

  void face(const std::array<Vec3, 3>& corners, double mm2, Tissue) override {
    if (wholly_in_target()) return;
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const Near near = near_at(middle);
    const Place place = place_of(near, reference_.leeway());
    if (place == Place::target) return;
    FaceOvercut& sum = of(place, near.face);
    sum.uncertainty_mm3 += kFaceFactor * reference_.surface_sigma_mm() * mm2;
    double& furthest = furthest_[index(place)][static_cast<std::size_t>(near.face)];
    if (near.distance_mm <= furthest) return;
    furthest = near.distance_mm;
    sum.at_mm = middle;
  }
  void tetrahedron(const std::array<Vec3, 4>& corners, double mm3, Tissue tissue) override {
    on_edge_ = false;
    if (!whole()) {
      const FaceName first = near_at(corners[0]).face;
      for (std::size_t i = 1; i < 4; ++i) on_edge_ = on_edge_ || near_at(corners[i]).face != first;
    }
    RegionClassifier::tetrahedron(corners, mm3, tissue);
    on_edge_ = false;
  }

 private:
  static std::size_t index(Place place) noexcept { return place == Place::beyond_floor || place == Place::beyond_side ? 1 : 0; }
  FaceOvercut& of(Place place, FaceName face) noexcept {
    return (index(place) == 1 ? sums_.beyond : sums_.leeway)[static_cast<std::size_t>(face)];
  }
  void solid(Place place, double mm3, Tissue) override {
    if (place == Place::target) return;
    FaceOvercut& sum = of(place, face_);
    sum.mm3 += mm3;
    if (on_edge_) sum.uncertainty_mm3 += kEdgeShare * mm3;
  }

  const Reference& reference_;
  OvercutByFace& sums_;
  std::array<std::array<double, kFaceNames>, 2> furthest_{};
  bool on_edge_ = false;
};

}  // namespace

std::optional<OvercutByFace> overcut_by_face(const Reference& reference, const Volume& volume) {
  if (reference.shape().empty()) return std::nullopt;
  OvercutByFace out;
  const double voxel = volume.grid().voxel_mm;
  for (auto* const zone : {&out.leeway, &out.beyond})
    for (FaceOvercut& one : *zone) one.uncertainty_mm3 = voxel * voxel * voxel;  // less than a voxel shows no face
  FaceVolumes sink(reference, out);
  for (const int brick : bricks_to_measure(volume)) emit_removed_by_place(volume, brick, sink);
  return out;
}

void add_volume(const Reference& reference, const Volume& volume, std::vector<Measure>& out) {
  const std::optional<OvercutByFace> all = overcut_by_face(reference, volume);
  for (const bool beyond : {false, true})
    for (std::size_t i = 0; i < kFaceNames; ++i) {
      std::string key = std::string(beyond ? "overcut_beyond_" : "overcut_leeway_") + std::string(kFaceKeys[i]);
      if (!all) {
        out.push_back(not_measured(std::move(key), "mm3"));
        continue;
      }
      const FaceOvercut& one = (beyond ? all->beyond : all->leeway)[i];
      out.push_back({std::move(key), true, one.mm3, one.uncertainty_mm3, "mm3", one.at_mm});
    }
}

}  // namespace cusp::scenarios
