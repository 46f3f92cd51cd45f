#include "scenarios/metrics/recover_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cusp::scenarios {

namespace {

/// The band is 2.75 voxels wide: after four layers every voxel that a surface cell reads has its value.
constexpr int kLayers = 4;

/// No cut raises the surface. More than a place's uncertainty (README.md), and the file's surface is another one.
constexpr double kSameSurfaceVoxels = 0.1;

/// Beside a place deep in the void all is void, but only if no line that the surface is seen on says better.
constexpr double kDeepBend = 0.5;

/// The cut field on the specimen's grid while it is recovered: distances in voxels, positive inside the cut.
class CutField {
 public:
  CutField(const Specimen& specimen, const VoxelVolume& prepared, IVec3 shift)
      : specimen_(specimen), grid_(specimen.grid()), distance_(grid_.voxels(), 0.0), known_(grid_.voxels(), 0) {
    const bool filled = specimen.reading() == Reading::filled;
    IVec3 v;
    for (v.z = 0; v.z < grid_.size.z; ++v.z)
      for (v.y = 0; v.y < grid_.size.y; ++v.y)
        for (v.x = 0; v.x < grid_.size.x; ++v.x) {
          const IVec3 there = v + shift;
          const std::uint16_t now =
              prepared.grid.contains(there) ? prepared.s[prepared.grid.index(there)] : std::uint16_t{0};
          const std::uint16_t was = specimen.s(v);
          const double raised = distance_from_solid(was) - distance_from_solid(now);
          if (now >= kHalf && was < kHalf && raised > 0.5) ++foreign_;
          if (!filled && raised > kSameSurfaceVoxels) ++raised_;
          if (now >= was) continue;
          const std::size_t i = grid_.index(v);
          known_[i] = 1;
          distance_[i] = distance_from_solid(filled ? (now >= kHalf ? kSolid : std::uint16_t{0}) : now);
          cut_.push_back(v);
        }
  }

  std::size_t foreign_voxels() const noexcept { return foreign_; }
  std::size_t raised_voxels() const noexcept { return raised_; }

  /// Continues the field by one layer into voxels where base and file are the same, and the cut therefore no deeper.
  void continue_outwards() {
    std::vector<std::pair<IVec3, double>> found;
    for (const IVec3 v : frontier()) {
      std::optional<Way> best;
      for (int axis = 0; axis < 3; ++axis)
        for (int step = -1; step <= 1; step += 2) {
          const std::optional<Way> way = along(v, axis, step);
          if (way && (!best || better(*way, *best))) best = way;
        }
      // The cut is no deeper than the base shows: else the file would be lower.
      if (best) found.emplace_back(v, std::min(best->distance, distance_from_solid(specimen_.s(v))));
    }
    for (const auto& [v, d] : found) {
      known_[grid_.index(v)] = 1;
      distance_[grid_.index(v)] = d;
      cut_.push_back(v);
    }
  }

  bool write_to(Volume& volume) const {
    for (const IVec3 v : cut_) {
      const std::uint16_t value = solid_from_distance(distance_[grid_.index(v)]);
      if (value == kSolid) continue;
      const int brick = specimen_.brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
      if (!volume.cuttable(brick)) continue;
      const bool fresh = !volume.has_cut(brick);
      std::uint16_t* cut = volume.cut_for_writing(brick);
      if (cut == nullptr) return false;
      cut[brick_offset(v.x & 7, v.y & 7, v.z & 7)] = value;
      if (fresh) volume.touched(brick);
    }
    return true;
  }

 private:
  /// The field continued to a voxel along a line of three, and how much it bends there: an edge of the cut bends it.
  struct Way {
    double distance, bend;
  };
  /// The straighter one; of two that are equally straight the one with less void, for the walls of a cavity meet in edges
  /// across which the other's slope runs on into the tissue.
  static bool better(const Way& a, const Way& b) noexcept {
    constexpr double kAlikeBend = 0.02;
    if (std::fabs(a.bend - b.bend) > kAlikeBend) return a.bend < b.bend;
    return a.distance < b.distance;
  }
  std::optional<Way> along(IVec3 v, int axis, int step) const {
    std::array<double, 3> d{};
    for (std::size_t i = 0; i < d.size(); ++i) {
      v[axis] += step;
      if (!known(v)) return i > 0 && d[0] > kBandVoxels - 1e-4 ? std::optional(Way{d[0], kDeepBend}) : std::nullopt;
      d[i] = at(v);
    }
    const auto clamped = [](double one) { return std::fabs(one) > kBandVoxels - 1e-4; };
    if (clamped(d[0]) && d[0] > 0.0) return Way{d[0], kDeepBend};
    if (std::ranges::any_of(d, clamped)) return std::nullopt;
    return Way{2.0 * d[0] - d[1], std::fabs(d[0] - 2.0 * d[1] + d[2])};
  }
  bool known(IVec3 v) const noexcept { return grid_.contains(v) && known_[grid_.index(v)] != 0; }
  double at(IVec3 v) const noexcept { return distance_[grid_.index(v)]; }
  /// Unknown voxels beside known ones, each once, in the order of the known.
  std::vector<IVec3> frontier() const {
    std::vector<IVec3> out;
    std::vector<std::uint8_t> listed(known_.size(), 0);
    for (const IVec3 v : cut_)
      for (int axis = 0; axis < 3; ++axis)
        for (int step = -1; step <= 1; step += 2) {
          IVec3 next = v;
          next[axis] += step;
          if (!grid_.contains(next) || known(next) || listed[grid_.index(next)] != 0) continue;
          listed[grid_.index(next)] = 1;
          out.push_back(next);
        }
    return out;
  }

  const Specimen& specimen_;
  Grid grid_;
  std::vector<double> distance_;
  std::vector<std::uint8_t> known_;
  std::vector<IVec3> cut_;
  std::size_t foreign_ = 0, raised_ = 0;
};

/// Tissue of the file where the specimen's grid has no voxels.
std::size_t voxels_outside(const Grid& grid, const VoxelVolume& prepared, IVec3 shift) {
  std::size_t count = 0, i = 0;
  IVec3 v;
  for (v.z = 0; v.z < prepared.grid.size.z; ++v.z)
    for (v.y = 0; v.y < prepared.grid.size.y; ++v.y)
      for (v.x = 0; v.x < prepared.grid.size.x; ++v.x, ++i)
        if (prepared.s[i] >= kHalf && !grid.contains(v - shift)) ++count;
  return count;
}

}  // namespace

Result<Volume, Failure<RecoverError>> recover_cut(std::shared_ptr<const Specimen> specimen, const VoxelVolume& prepared) {
  const Grid& grid = specimen->grid();
  // Over the 2048 voxels that a file may have along an edge this adds up to a fiftieth of one.
  constexpr double kAlikeShare = 1e-5;
  if (std::fabs(prepared.grid.voxel_mm - grid.voxel_mm) > kAlikeShare * grid.voxel_mm)
    return fail(RecoverError::other_voxel, {}, std::to_string(prepared.grid.voxel_mm));
  const Vec3 off = (grid.origin_mm - prepared.grid.origin_mm) / grid.voxel_mm;
  const Vec3 whole = glm::round(off);
  constexpr double kRoundingVoxels = 0.01;  // a file's decimals
  if (!glm::all(glm::lessThanEqual(glm::abs(off - whole), Vec3(kRoundingVoxels)))) return fail(RecoverError::other_frame, {});
  // Beyond this the grids have no voxel in common, and the number may be too large for an integer.
  const Vec3 apart(grid.size + prepared.grid.size);
  const IVec3 shift(glm::clamp(whole, -apart, apart));
  CutField field(*specimen, prepared, shift);
  const std::size_t foreign = field.foreign_voxels() + voxels_outside(grid, prepared, shift);
  if (foreign > kForeignVoxels) {
    const double mm3 = static_cast<double>(foreign) * grid.voxel_mm * grid.voxel_mm * grid.voxel_mm;
    return fail(RecoverError::other_tissue, {}, std::to_string(mm3));
  }
  if (field.raised_voxels() > kForeignVoxels) return fail(RecoverError::other_surface, {});
  if (specimen->reading() == Reading::banded)
    for (int layer = 0; layer < kLayers; ++layer) field.continue_outwards();
  Volume volume(std::move(specimen));
  if (!field.write_to(volume)) return fail(RecoverError::too_much_cut, {});
  return volume;
}

}  // namespace cusp::scenarios
