#include "scenarios/metrics/unsupported.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scenarios/metrics/region_shares.h"
#include "scenarios/metrics/surface_search.h"
#include "scenarios/shapes/tissue_shape.h"

namespace cusp::scenarios {

namespace {

/// The junction is known to a voxel: its normal is that of the dentine within this radius, at places so far apart.
constexpr double kNormalMm = 0.4, kApartMm = 0.1;
/// The nearest voxel's cube stands out of a slanting border; mean over its slants.
constexpr double kStandsOutVoxels = 0.35;
/// The rod's way and the normal at its foot, in turn: each pass leaves less than half of the error.
constexpr int kPasses = 3;
/// Places in a voxel along each axis.
constexpr int kAlongVoxel = 3;
/// Along a rod.
constexpr double kStepVoxels = 0.5;
/// Of the border between carried enamel and other: of its place, and of the rods' lean for each mm of their way (measured: proximal_test).
constexpr double kRodBorderVoxels = 0.35, kRodLeanVoxels = 0.5;

bool of_enamel(Tissue t) noexcept { return t == Tissue::enamel || t == Tissue::carious_enamel; }

/// How many places of a voxel hold enamel that is left, and how many of those a rod does not carry.
struct Counted {
  int left = 0, unsupported = 0;
  double way_mm = 0;  // from the voxel to the dentine
};

class Rods {
 public:
  Rods(const Reference& reference, const Volume& volume) : dentine_(reference.dentine()), volume_(volume), search_(volume, Solid::remaining) {
    const int edge = static_cast<int>(kNormalMm / kApartMm);
    for (int z = -edge; z <= edge; ++z)
      for (int y = -edge; y <= edge; ++y)
        for (int x = -edge; x <= edge; ++x) {
          const Vec3 off = kApartMm * Vec3(x, y, z);
          const double weight = 1.0 - glm::dot(off, off) / (kNormalMm * kNormalMm);
          if (weight > 0.0) ball_.emplace_back(off, weight);
        }
  }

  Counted count(IVec3 v) {
    const Grid& grid = volume_.grid();
    const Vec3 centre = grid.centre_mm(v);
    const double depth = dentine_.distance_mm(centre) + kStandsOutVoxels * grid.voxel_mm;
    const Vec3 back = towards_dentine(centre, depth);
    Counted out{0, 0, std::max(0.0, depth)};
    for (int i = 0; i < kAlongVoxel * kAlongVoxel * kAlongVoxel; ++i) {
      const Vec3 off = (Vec3(i % kAlongVoxel, i / kAlongVoxel % kAlongVoxel, i / (kAlongVoxel * kAlongVoxel)) + 0.5) / static_cast<double>(kAlongVoxel) - 0.5;
      const Vec3 p = centre + grid.voxel_mm * off;
      if (search_.distance(p) >= 0.0) continue;
      ++out.left;
      if (is_cut(p, back, depth + grid.voxel_mm * glm::dot(off, -back) + kCarrierMm)) ++out.unsupported;
    }
    return out;
  }

 private:
  /// Against the slope of the distance to the junction: the junction's normal at the rod's foot.
  Vec3 towards_dentine(Vec3 p, double depth) const noexcept {
    Vec3 way = -dentine_.out_of(p);
    for (int pass = 0; pass < kPasses; ++pass) {
      const Vec3 normal = into_dentine(p + depth * way), sum = way + normal;
      const double length = std::sqrt(glm::dot(sum, sum));
      if (length > 0.5) way = sum / length;
    }
    return way;
  }
  /// To the middle of the dentine in a ball about a place of the junction; of length 1, or 0 where there is none.
  Vec3 into_dentine(Vec3 at) const noexcept {
    Vec3 sum(0.0);
    for (const auto& [off, weight] : ball_)
      if (dentine_.contains(at + off)) sum += weight * off;
    const double length = std::sqrt(glm::dot(sum, sum));
    return length > 0.0 ? sum / length : sum;
  }
  bool is_cut(Vec3 from, Vec3 way, double length) {
    const Grid& grid = volume_.grid();
    const double step = kStepVoxels * grid.voxel_mm;
    for (double mm = 0.0; mm < length + step; mm += step) {
      const Vec3 p = from + std::min(mm, length) * way;
      if (volume_.cut(nearest_voxel(grid, p)) != kSolid && cells_.at(volume_, Field::cut, p).d_mm > 0.0) return true;
    }
    return false;
  }

  const TissueShape& dentine_;
  const Volume& volume_;
  SurfaceSearch search_;
  std::vector<std::pair<Vec3, double>> ball_;  // places about its middle, with weights that fall to 0 at its edge
  FieldCells cells_;
};

/// From the enamel next to the cut on through all that is unsupported.
class Flood {
 public:
  Flood(const Reference& reference, const Volume& volume)
      : volume_(volume), rods_(reference, volume),
        seen_(static_cast<std::size_t>(volume.grid().size.x) * static_cast<std::size_t>(volume.grid().size.y) * static_cast<std::size_t>(volume.grid().size.z)) {}

  UnsupportedEnamel all() {
    const double reach = std::max(1.5, 1.0 + kCarrierMm / volume_.grid().voxel_mm);
    for (const int brick : bricks_to_measure(volume_)) {
      const IVec3 corner = volume_.specimen().brick_at(brick) * kBrickEdge;
      for (int o = 0; o < kBrickVoxels; ++o) {
        const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
        if (volume_.cut(v) != kSolid && field_sample(volume_, Field::cut, v) > -reach) visit(v);
      }
    }
    for (std::size_t next = 0; next < waiting_.size(); ++next)
      for (int i = 0; i < 27; ++i) visit(waiting_[next] + IVec3(i % 3, i / 3 % 3, i / 9) - 1);
    const double voxel = volume_.grid().voxel_mm;
    constexpr double kWhole = kAlongVoxel * kAlongVoxel * kAlongVoxel;
    UnsupportedEnamel out{places_ * voxel * voxel * voxel / kWhole, borders_ * voxel * voxel * voxel, std::nullopt, {}};
    if (!waiting_.empty()) out.at_mm = volume_.grid().centre_mm(waiting_.front());
    out.voxels = std::move(waiting_);
    return out;
  }

 private:
  void visit(IVec3 v) {
    const IVec3 size = volume_.grid().size;
    if (glm::any(glm::lessThan(v, IVec3(0))) || glm::any(glm::greaterThanEqual(v, size))) return;
    const auto i = static_cast<std::size_t>(v.x) + static_cast<std::size_t>(size.x) * (static_cast<std::size_t>(v.y) + static_cast<std::size_t>(size.y) * static_cast<std::size_t>(v.z));
    if (seen_[i]) return;
    seen_[i] = true;
    if (!of_enamel(volume_.tissue(v))) return;
    const Counted one = rods_.count(v);
    if (one.unsupported == 0) return;
    places_ += one.unsupported;
    if (one.unsupported < one.left) borders_ += kRodBorderVoxels + kRodLeanVoxels * one.way_mm;
    waiting_.push_back(v);
  }

  const Volume& volume_;
  Rods rods_;
  std::vector<bool> seen_;
  std::vector<IVec3> waiting_;  // voxels with unsupported enamel; their neighbours are looked at in turn
  double places_ = 0, borders_ = 0;  // unsupported places; voxels of uncertainty along the border
};

}  // namespace

std::optional<UnsupportedEnamel> unsupported_enamel(const Reference& reference, const Volume& volume) {
  if (volume.specimen().reading() == Reading::filled || volume.cut_bricks().empty()) return std::nullopt;
  if (!(reference.has(Tissue::enamel) || reference.has(Tissue::carious_enamel)) || reference.dentine().empty()) return std::nullopt;
  return Flood(reference, volume).all();
}

void add_unsupported(const Reference& reference, const Volume& volume, std::vector<Measure>& out) {
  if (const auto found = unsupported_enamel(reference, volume))
    out.push_back({"unsupported_enamel", true, found->mm3, found->uncertainty_mm3, "mm3", found->at_mm});
  else
    out.push_back(not_measured("unsupported_enamel", "mm3"));
}

}  // namespace cusp::scenarios
