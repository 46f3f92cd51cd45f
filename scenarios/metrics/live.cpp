#include "scenarios/metrics/live.h"

#include <algorithm>
#include <utility>

namespace cusp::scenarios {

namespace {

/// A cut surface further off than this leaves all voxels beside the pulp, so that nobody walks them: it passes within one voxel of an
/// exposed voxel's centre, the smoothed border within 1.6 of it, and a face is no longer than 1.8.
constexpr double kExposedVoxels = 5.0;

/// A cell reads voxels from 3 before its lower corner to 4 after it: sharp_edge.h takes the faces of cells two away, whose
/// stencils reach one further. Of a brick's voxels along an axis the cells below it so read the first four, those above the
/// last three.
constexpr int kReadBelow = 4, kReadAbove = 5;  // first voxel that they do not read, first that they read
enum : unsigned { kFirst = 1, kMiddle = 2, kLast = 4 };

constexpr unsigned part_of(int along) { return along < kReadBelow ? kFirst : along < kReadAbove ? kMiddle : kLast; }
constexpr unsigned read_by(int neighbour) { return neighbour < 0 ? kFirst : neighbour > 0 ? kLast : kFirst | kMiddle | kLast; }
/// A bit for each of the 27 parts of a brick that lie within these parts along x, y and z.
constexpr std::uint32_t parts(unsigned x, unsigned y, unsigned z) {
  std::uint32_t out = 0;
  for (int i = 0; i < 27; ++i)
    if ((x >> i % 3 & y >> i / 3 % 3 & z >> i / 9 & 1u) != 0) out |= std::uint32_t{1} << i;
  return out;
}
constexpr auto kPartOf = [] {
  std::array<std::uint32_t, kBrickVoxels> out{};
  for (int o = 0; o < kBrickVoxels; ++o) out[static_cast<std::size_t>(o)] = parts(part_of(o & 7), part_of(o >> 3 & 7), part_of(o >> 6));
  return out;
}();

}  // namespace

LiveMetrics::LiveMetrics(std::shared_ptr<const Reference> reference) : reference_(std::move(reference)) { reset(); }

void LiveMetrics::reset() {
  bricks_.clear();
  cut_.clear();
  reading_ = {};
  reading_.target_measured = reference_->target_mm3() > 0.0;
}

/// Adds the brick and its neighbours whose cells read what has changed in it.
void LiveMetrics::note_dirty(const Volume& volume, std::int32_t brick) {
  const Specimen& specimen = volume.specimen();
  const std::uint16_t* now = volume.cut_of(brick);
  if (now == nullptr) return;
  const auto [it, first] = cut_.try_emplace(brick);
  if (first) it->second.fill(kSolid);
  std::uint32_t changed = 0;
  for (std::size_t o = 0; o < it->second.size(); ++o)
    if (std::exchange(it->second[o], now[o]) != now[o]) changed |= kPartOf[o];
  const IVec3 at = specimen.brick_at(brick);
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const int b = specimen.brick_index(at + IVec3(x, y, z));
        if (b >= 0 && (changed & parts(read_by(x), read_by(y), read_by(z))) != 0) dirty_.push_back(b);
      }
}

LiveMetrics::Brick LiveMetrics::measured(const Volume& volume, int brick) const {
  Brick out{shares_of_brick(*reference_, volume, brick), {}};
  if (several() == 0) return out;
  const SeveralTargets& targets = reference_->targets();
  const Grid& grid = volume.grid();
  const IVec3 corner = volume.specimen().brick_at(brick) * kBrickEdge;
  const auto only = targets.only_part(grid.centre_mm(corner), grid.centre_mm(corner + IVec3(kBrickEdge)));
  for (std::size_t i = 0; i < several(); ++i) {
    const SeveralTargets::One& one = targets.asked()[i];
    if (only) out.of_mm3[i] = *only == one.part ? out.shares.removed_mm3[static_cast<std::size_t>(Place::target)] : 0.0;
    else out.of_mm3[i] = removed_of_target_mm3(*one.reference, volume, brick);
  }
  return out;
}

void LiveMetrics::update(const Volume& volume, std::span<const std::int32_t> changed) {
  if (changed.empty()) return;
  dirty_.clear();
  for (const std::int32_t brick : changed) note_dirty(volume, brick);
  std::sort(dirty_.begin(), dirty_.end());
  dirty_.erase(std::unique(dirty_.begin(), dirty_.end()), dirty_.end());
  for (const int b : dirty_) bricks_[b] = measured(volume, b);

  RegionShares sum;
  std::array<double, LiveReading::kMostTargets> of_mm3{};
  for (const auto& [number, brick] : bricks_) {
    sum.add(brick.shares);
    for (std::size_t i = 0; i < several(); ++i) of_mm3[i] += brick.of_mm3[i];
  }
  for (std::size_t i = 0; i < several(); ++i) {
    const double whole = reference_->targets().asked()[i].reference->target_mm3();
    reading_.removed_of[i] = whole > 0.0 ? 100.0 * std::clamp(of_mm3[i] / whole, 0.0, 1.0) : 0.0;
  }
  reading_.overcut_mm3 = sum.removed_mm3;
  reading_.removed_mm3 = sum.tissue_mm3;
  constexpr auto kTarget = static_cast<std::size_t>(Place::target);
  if (reading_.target_measured)
    reading_.target_removed = 100.0 * std::clamp(sum.removed_mm3[kTarget] / reference_->target_mm3(), 0.0, 1.0);
  reading_.remaining_over_pulp_mm = over_pulp_mm(*reference_, volume, sum);
  const std::optional<double>& over_pulp = reading_.remaining_over_pulp_mm;
  const bool near_pulp = over_pulp && *over_pulp < kExposedVoxels * volume.grid().voxel_mm;
  reading_.pulp_exposed = near_pulp && exposed_pulp(*reference_, volume).has_value();
}

}  // namespace cusp::scenarios
