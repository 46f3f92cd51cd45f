#include "scenarios/metrics/depth.h"

#include <algorithm>
#include <cmath>

#include "engine/volume/cell_field.h"
#include "scenarios/metrics/cut_faces.h"
#include "scenarios/metrics/surface_search.h"
#include "scenarios/modules.h"
#include "scenarios/teeth/own_tissues.h"

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

constexpr Vec3 kUp{0.0, 0.0, 1.0};

/// Of a tree: at such a floor of the target, off that part's walls by the inset.
bool on_floor(const TargetShape& shape, FaceName floor, const Facing& facing, Vec3 p, double inset) noexcept {
  return facing.face == floor && facing.wall_mm <= -inset && shape.bounded_by(facing, p);
}

/// Of a tree: straight below such a floor, and no over-cut beside another floor. `p`: where the column's tissue begins or ended.
bool is_below_floor(const TargetShape& shape, FaceName floor, Vec3 p, double inset) noexcept {
  constexpr double kAtTargetMm = 0.01;  // of the floor, a tenth of a voxel of 0.1 mm: it decides what counts, and no depth
  constexpr int kMostSteps = 64;        // 12 mm, higher than a crown, where the nearest wall is 0.2 mm off
  const std::optional<Facing> nearest = shape.facing(p, kUp);
  if (nearest && nearest->face != floor && nearest->beside_mm <= kWallReachMm) return false;
  double d = shape.distance_mm(p);
  if (d < kAtTargetMm) return false;
  for (int i = 0; i < kMostSteps && d >= kAtTargetMm && p.z < shape.top_mm(); ++i) {
    p.z += d;  // nothing of the target is nearer
    d = shape.distance_mm(p);
  }
  const std::optional<Facing> above = d < kAtTargetMm ? shape.facing(p, kUp) : std::nullopt;
  return above && on_floor(shape, floor, *above, p, inset);
}

/// Of a tree: what a bur left of such a floor. In a hole the floor of another part may be nearer.
bool is_of_floor(const TargetShape& shape, FaceName floor, Vec3 p, double inset) noexcept {
  const std::optional<Facing> facing = shape.facing(p, kUp);
  return facing && facing->face == floor ? on_floor(shape, floor, *facing, p, inset) : is_below_floor(shape, floor, p, inset);
}

/// A quarter of a voxel less than the target's corner, so that a slot as wide as the bur, whose floor is a line, keeps its columns.
double floor_inset(const TargetShape& shape, const Grid& grid) noexcept { return shape.corner_mm() - 0.25 * grid.voxel_mm; }

template <class Column>
std::optional<FloorDepth> over_outline(const Reference& reference, const Volume& volume, Column column) {
  const TargetShape& shape = reference.shape();
  const Grid& grid = volume.grid();
  const double step = 0.5 * grid.voxel_mm;
  const double inset = floor_inset(shape, grid);
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
      const bool pulpal = shape.upright() != nullptr || (left ? is_of_floor : is_below_floor)(shape, FaceName::pulpal_floor, at, inset);
      if (!pulpal) continue;
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

/// Whether tissue of the tooth ended below here.
bool ends_own_tissue(const Specimen& specimen, Vec3 p) noexcept {
  return is_own_hard(specimen.tissue(nearest_voxel(specimen.grid(), p + Vec3(0.0, 0.0, 0.5 * specimen.grid().voxel_mm))));
}

}  // namespace

std::optional<Vec3> lowest_cut_through(const Reference& reference, const Volume& volume, FaceName floor) {
  const TargetShape& shape = reference.shape();
  if (shape.empty() || shape.upright() != nullptr || volume.cut_bricks().empty() || volume.specimen().reading() == Reading::filled) return std::nullopt;
  const Grid& grid = volume.grid();
  BandedColumn column(volume);
  const Vec2 first = glm::max(shape.low(), Vec2(grid.origin_mm)), last = glm::min(shape.high(), Vec2(grid.centre_mm(grid.size - 1)));
  std::optional<Vec3> lowest;
  for (double y = first.y; y <= last.y; y += grid.voxel_mm)
    for (double x = first.x; x <= last.x; x += grid.voxel_mm) {
      const Vec2 at_voxel((x - grid.origin_mm.x) / grid.voxel_mm, (y - grid.origin_mm.y) / grid.voxel_mm);
      if (column.look(at_voxel.x, at_voxel.y)) continue;
      const std::optional<Floor> ended = column.cut_through(at_voxel.x, at_voxel.y);
      if (!ended || (lowest && ended->z_mm >= lowest->z)) continue;
      const Vec3 at(x, y, ended->z_mm);
      if (ends_own_tissue(volume.specimen(), at) && is_below_floor(shape, floor, at, floor_inset(shape, grid))) lowest = at;
    }
  return lowest;
}

std::optional<FloorDepth> floor_depth(const Reference& reference, const Volume& volume) {
  if (reference.shape().empty() || !reference.shape().has_plane() || volume.cut_bricks().empty()) return std::nullopt;
  return volume.specimen().reading() == Reading::filled ? over_outline(reference, volume, FilledColumn(volume))
                                                        : over_outline(reference, volume, BandedColumn(volume));
}

}  // namespace cusp::scenarios
