#include "scenarios/metrics/depth.h"

#include <algorithm>
#include <cmath>

#include "engine/volume/cell_field.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

namespace {

struct Floor {
  double z_mm;
  bool cut;      // left by a bur
  double level;  // cosine of its lean
};

/// Looks down one column of a banded volume; x, y in voxels.
class BandedColumn {
 public:
  explicit BandedColumn(const Volume& volume) : volume_(volume) {}

  std::optional<Floor> look(double x, double y) {
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    const double fx = x - i, fy = y - j;
    for (int k = volume_.grid().size.z - 1; k >= 0; --k) {
      if (!may_be_solid(i, j, k)) continue;
      if (solid(Field::base, i, j, k, fx, fy) >= 0.0 || solid(Field::cut, i, j, k, fx, fy) >= 0.0) continue;
      return refine({i, j, k}, fx, fy);
    }
    return std::nullopt;
  }
  /// Where the tissue of a column that has none left ended below; nullopt: it never had any.
  std::optional<Floor> cut_through(double x, double y) const noexcept {
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    double below = 0;
    for (int k = -1; k < volume_.grid().size.z; ++k) {
      const double here = solid(Field::base, i, j, k, x - i, y - j);
      if (here >= 0.0) below = here;
      else return floor_at(k - here / (here - below));
    }
    return std::nullopt;
  }

 private:
  /// Level, at a height of voxels.
  Floor floor_at(double z) const noexcept { return {volume_.grid().origin_mm.z + volume_.grid().voxel_mm * z, true, 1.0}; }
  bool may_be_solid(int i, int j, int k) const noexcept {
    for (int c = 0; c < 4; ++c)
      if (volume_.s({i + (c & 1), j + (c >> 1), k}) > 0) return true;
    return false;
  }
  /// Bilinear distance at a height of voxel centres: negative where there is material.
  double solid(Field field, int i, int j, int k, double fx, double fy) const noexcept {
    const double a = field_sample(volume_, field, {i, j, k});
    const double b = field_sample(volume_, field, {i + 1, j, k});
    const double c = field_sample(volume_, field, {i, j + 1, k});
    const double d = field_sample(volume_, field, {i + 1, j + 1, k});
    return (1.0 - fy) * ((1.0 - fx) * a + fx * b) + fy * ((1.0 - fx) * c + fx * d);
  }
  /// The surface above voxel height k, on the corrected fields.
  Floor refine(IVec3 cell, double fx, double fy) {
    base_.load(volume_, Field::base, cell);
    cut_.load(volume_, Field::cut, cell);
    Vec3 g;
    const auto outside = [&](double z) {
      return std::max(base_.eval({fx, fy, z}, g), cut_.eval({fx, fy, z}, g));
    };
    // The corrected field may cross a little beyond the bilinear one's heights.
    double low = outside(0.0) < 0.0 ? 0.0 : -0.3;
    double high = outside(1.0) >= 0.0 ? 1.0 : 1.3;
    for (int pass = 0; pass < 40; ++pass) {
      const double middle = 0.5 * (low + high);
      (outside(middle) < 0.0 ? low : high) = middle;
    }
    const double z = 0.5 * (low + high);
    const double base = base_.eval({fx, fy, z}, g);
    Vec3 up;
    const double cut = cut_.eval({fx, fy, z}, up);
    const double length = glm::length(up);
    const Grid& grid = volume_.grid();
    return {grid.origin_mm.z + grid.voxel_mm * (cell.z + z), cut >= base, length > 0.25 ? up.z / length : 0.0};
  }

  const Volume& volume_;
  CellField base_, cut_;
};

/// The same of a filled volume: the top face of the highest voxel.
class FilledColumn {
 public:
  explicit FilledColumn(const Volume& volume) : volume_(volume) {}

  std::optional<Floor> look(double x, double y) {
    const int i = static_cast<int>(std::floor(x + 0.5)), j = static_cast<int>(std::floor(y + 0.5));
    const int k = top(i, j);
    if (k < 0) return std::nullopt;
    const double slope_x = 0.5 * (top(i + 1, j) - top(i - 1, j));
    const double slope_y = 0.5 * (top(i, j + 1) - top(i, j - 1));
    const Grid& grid = volume_.grid();
    return Floor{grid.origin_mm.z + grid.voxel_mm * (k + 0.5), volume_.specimen().s({i, j, k + 1}) > 0,
                 1.0 / std::sqrt(1.0 + slope_x * slope_x + slope_y * slope_y)};
  }
  std::optional<Floor> cut_through(double x, double y) const noexcept {
    const int i = static_cast<int>(std::floor(x + 0.5)), j = static_cast<int>(std::floor(y + 0.5));
    const Grid& grid = volume_.grid();
    for (int k = 0; k < grid.size.z; ++k)
      if (volume_.specimen().s({i, j, k}) > 0) return Floor{grid.origin_mm.z + grid.voxel_mm * (k - 0.5), true, 1.0};
    return std::nullopt;
  }

 private:
  int top(int i, int j) const noexcept {
    int k = volume_.grid().size.z - 1;
    while (k >= 0 && !volume_.occupied({i, j, k})) --k;
    return k;
  }
  const Volume& volume_;
};

/// Of a tree: a floor that faces its pulpal floor, and off that part's walls by the inset.
bool on_pulpal_floor(const TargetShape& shape, Vec3 p, double inset) noexcept {
  const std::optional<Facing> facing = shape.facing(p, Vec3(0.0, 0.0, 1.0));
  return facing && facing->face == FaceName::pulpal_floor && facing->wall_mm <= -inset && shape.bounded_by(*facing, p);
}

/// Of a tree: below a pulpal floor of the target, where the specimen ended or a floor of another part is nearer. `p`: where the
/// column's tissue begins or ended.
bool is_below_pulpal_floor(const TargetShape& shape, Vec3 p, double inset) noexcept {
  constexpr double kAtTargetMm = 0.01;
  constexpr int kMostSteps = 64;
  double d = shape.distance_mm(p);
  if (d < kAtTargetMm) return false;
  for (int i = 0; i < kMostSteps && d >= kAtTargetMm && p.z < shape.top_mm(); ++i) {
    p.z += d;  // nothing of the target is nearer
    d = shape.distance_mm(p);
  }
  return d < kAtTargetMm && on_pulpal_floor(shape, p, inset);
}

template <class Column>
std::optional<FloorDepth> over_outline(const Reference& reference, const Volume& volume, Column column) {
  const TargetShape& shape = reference.shape();
  const Grid& grid = volume.grid();
  const double step = 0.5 * grid.voxel_mm;
  // Half a step more than the inset, so that a slot as wide as the bur, whose floor is a line, keeps its columns.
  const double inset = shape.corner_mm() - 0.5 * step;
  constexpr double kLevel = 0.70710678;  // 45 degrees
  FloorDepth out;
  double sum = 0;
  const int nx = static_cast<int>(std::floor((shape.high().x - shape.low().x) / step));
  const int ny = static_cast<int>(std::floor((shape.high().y - shape.low().y) / step));
  const Vec2 first = 0.5 * (shape.low() + shape.high() - step * Vec2(nx, ny));
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const Vec2 p = first + step * Vec2(i, j);
      if (shape.upright() != nullptr && shape.outline_mm(p) > -inset) continue;
      const Vec2 at_voxel((p.x - grid.origin_mm.x) / grid.voxel_mm, (p.y - grid.origin_mm.y) / grid.voxel_mm);
      const std::optional<Floor> left = column.look(at_voxel.x, at_voxel.y);
      const std::optional<Floor> floor = left ? left : column.cut_through(at_voxel.x, at_voxel.y);
      if (!floor || !floor->cut || floor->level < kLevel) continue;
      const Vec3 at(p.x, p.y, floor->z_mm);
      const bool pulpal = shape.upright() != nullptr || (left && on_pulpal_floor(shape, at, inset));
      if (!pulpal && !is_below_pulpal_floor(shape, at, inset)) continue;
      const double depth = shape.top_mm() - floor->z_mm;
      if (out.samples == 0 || depth < out.least_mm) {
        out.least_mm = depth;
        out.least_at_mm = at;
      }
      if (out.samples == 0 || depth > out.most_mm) {
        out.most_mm = depth;
        out.most_at_mm = at;
      }
      sum += depth;
      ++out.samples;
    }
  if (out.samples == 0) return std::nullopt;
  out.mean_mm = sum / static_cast<double>(out.samples);
  return out;
}

}  // namespace

std::optional<FloorDepth> floor_depth(const Reference& reference, const Volume& volume) {
  if (reference.shape().empty() || !reference.shape().has_plane() || volume.cut_bricks().empty()) return std::nullopt;
  return volume.specimen().reading() == Reading::filled ? over_outline(reference, volume, FilledColumn(volume))
                                                        : over_outline(reference, volume, BandedColumn(volume));
}

}  // namespace cusp::scenarios
