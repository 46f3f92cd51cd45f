#include "scenarios/metrics/region_shares.h"

#include <algorithm>
#include <cmath>

#include "scenarios/metrics/region_classifier.h"

namespace cusp::scenarios {

namespace {

class ShareSink final : public RegionClassifier {
 public:
  ShareSink(const Reference& reference, const Volume& volume, RegionShares& shares)
      : RegionClassifier(reference.shape(), reference.leeway()), reference_(reference), judge_(volume), shares_(shares) {}

  using RegionClassifier::boundary_mm2;
  void face(const std::array<Vec3, 3>& corners, double mm2, Tissue tissue) override {
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    double d = 0;
    const Place where = wholly_in_target() ? Place::target : place_at(middle, d);
    const auto place = static_cast<std::size_t>(where);
    shares_.cut_face_mm2[place] += mm2;
    shares_.tissue_face_mm2[index_of(tissue)] += mm2;
    if (where == Place::tolerated_floor || where == Place::beyond_floor)
      judge_.offer(corners, FaceKind::floor, reference_.shape().upright() != nullptr ? reference_.shape().below_floor_mm(middle.z) : d, shares_.worst[place]);
    if (where == Place::tolerated_side || where == Place::beyond_side)
      judge_.offer(corners, FaceKind::wall, d, shares_.worst[place]);
    if (!reference_.pulp().empty()) pulp(corners);
  }

 private:
  void solid(Place place, double mm3, Tissue tissue) override {
    shares_.removed_mm3[static_cast<std::size_t>(place)] += mm3;
    shares_.tissue_mm3[index_of(tissue)] += mm3;
  }
  /// A distance changes no faster than its place: what was asked of late bounds its neighbours, and most need no asking. Faces
  /// share their corners.
  void pulp(const std::array<Vec3, 3>& corners) {
    constexpr double kBeyondMm = 0.5;  // asked a little further than needed, so that the bound lasts
    for (const Vec3& p : corners) {
      if (std::ranges::any_of(asked_, [&](const Asked& one) { return one.no_nearer_than(shares_.pulp_mm, p); })) continue;
      const Asked now{p, reference_.pulp().distance_mm(p, shares_.pulp_mm + kBeyondMm)};
      asked_[next_asked_] = now;
      next_asked_ = (next_asked_ + 1) % asked_.size();
      if (now.mm < shares_.pulp_mm) {
        shares_.pulp_mm = now.mm;
        shares_.pulp_at_mm = p;
      }
    }
  }

  const Reference& reference_;
  FaceJudge judge_;
  RegionShares& shares_;
  /// A place, and a lower bound of the distance from there to the pulp.
  struct Asked {
    Vec3 at_mm{0.0};
    double mm = -1.0;
    bool no_nearer_than(double least_mm, Vec3 p) const noexcept {
      const double room = mm - least_mm;
      const Vec3 off = p - at_mm;
      return room >= 0.0 && glm::dot(off, off) <= room * room;
    }
  };
  std::array<Asked, 32> asked_{};  // about a slice of a brick's corners
  std::size_t next_asked_ = 0;
};

class TargetSink final : public RegionClassifier {
 public:
  explicit TargetSink(const Reference& reference) : RegionClassifier(reference.shape(), reference.leeway()) {}
  void face(const std::array<Vec3, 3>&, double, Tissue) override {}
  double mm3 = 0;

 private:
  void solid(Place place, double part_mm3, Tissue) override { mm3 += place == Place::target ? part_mm3 : 0.0; }
};

/// Removed border between tissues: it is known to a voxel only, which the uncertainty owns up to.
void add_seams(const Volume& volume, int brick, RegionShares& shares) {
  const Specimen& specimen = volume.specimen();
  if (specimen.uniform(brick) || !volume.has_cut(brick)) return;
  const double mm2 = specimen.grid().voxel_mm * specimen.grid().voxel_mm;
  const IVec3 corner = specimen.brick_at(brick) * kBrickEdge;
  const bool filled = specimen.reading() == Reading::filled;
  const auto gone = [&](IVec3 v) {
    const bool was = filled ? specimen.s(v) > 0 : specimen.s(v) >= kHalf;
    return was && !volume.occupied(v);
  };
  for (int o = 0; o < kBrickVoxels; ++o) {
    const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
    if (!gone(v)) continue;
    const Tissue here = specimen.tissue(v);
    for (int axis = 0; axis < 3; ++axis) {
      IVec3 next = v;
      next[axis] += 1;
      const Tissue there = specimen.tissue(next);
      if (there == here || !gone(next)) continue;
      shares.tissue_seam_mm2[index_of(here)] += mm2;
      shares.tissue_seam_mm2[index_of(there)] += mm2;
    }
  }
}

}  // namespace

void RegionShares::add(const RegionShares& other) noexcept {
  for (std::size_t i = 0; i < static_cast<std::size_t>(kPlaces); ++i) {
    removed_mm3[i] += other.removed_mm3[i];
    cut_face_mm2[i] += other.cut_face_mm2[i];
    if (other.worst[i].better_than(worst[i])) worst[i] = other.worst[i];
  }
  for (std::size_t i = 0; i < kTissueCodes; ++i) {
    tissue_mm3[i] += other.tissue_mm3[i];
    tissue_face_mm2[i] += other.tissue_face_mm2[i];
    tissue_seam_mm2[i] += other.tissue_seam_mm2[i];
  }
  target_boundary_mm2 += other.target_boundary_mm2;
  if (other.pulp_mm < pulp_mm) {
    pulp_mm = other.pulp_mm;
    pulp_at_mm = other.pulp_at_mm;
  }
}

std::optional<double> over_pulp_mm(const Reference& reference, const Volume& volume, const RegionShares& sum) {
  if (reference.pulp().empty()) return std::nullopt;
  const bool left = std::ranges::any_of(reference.pulp().voxels(), [&](IVec3 v) { return volume.occupied(v); });
  if (!left) return 0.0;
  return std::isfinite(sum.pulp_mm) ? std::optional(sum.pulp_mm) : std::nullopt;
}

RegionShares shares_of_brick(const Reference& reference, const Volume& volume, int brick) {
  RegionShares shares;
  ShareSink sink(reference, volume, shares);
  emit_removed_by_place(volume, brick, sink);
  shares.target_boundary_mm2 = sink.boundary_mm2();
  add_seams(volume, brick, shares);
  return shares;
}

double removed_of_target_mm3(const Reference& reference, const Volume& volume, int brick) {
  TargetSink sink(reference);
  const Grid& grid = volume.grid();
  const IVec3 corner = volume.specimen().brick_at(brick) * kBrickEdge;
  if (!sink.within(grid.centre_mm(corner), grid.centre_mm(corner + IVec3(kBrickEdge)))) return 0.0;
  emit_removed_by_place(volume, brick, sink);
  return sink.mm3;
}

std::vector<int> bricks_to_measure(const Volume& volume) {
  const Specimen& specimen = volume.specimen();
  std::vector<int> out;
  for (const std::int32_t cut : volume.cut_bricks()) {
    const IVec3 at = specimen.brick_at(cut);
    for (int i = 0; i < 8; ++i) {
      const int b = specimen.brick_index(at - IVec3(i & 1, i >> 1 & 1, i >> 2));
      if (b >= 0) out.push_back(b);
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace cusp::scenarios
