#include "scenarios/metrics/margin.h"

#include <algorithm>
#include <cmath>

#include "engine/volume/cell_field.h"
#include "scenarios/metrics/angle.h"
#include "scenarios/metrics/region_shares.h"
#include "scenarios/metrics/surface_search.h"
#include "scenarios/teeth/own_tissues.h"

namespace cusp::scenarios {

namespace {

/// Of the mean angle: what both surfaces are off alike over the whole margin, voxels at either end of a chord (measured: groups_test).
constexpr double kMeanSigmaVoxels = 0.03;

/// Of the angles' spread, times the share of the margin without an angle: voxels round the fissures and line angles where that share
/// begins (measured: crown_test).
constexpr double kWithoutFactor = 0.25;

/// Sine of the turn between the margin and the end of its chord, above which a line angle lies between them: there the margin's
/// normal is neither wall's.
constexpr double kLeastCorner = 0.2;

/// Angle between two chords, 0 to 180 degrees.
double between_deg(Vec3 a, Vec3 b) noexcept {
  const double rise = length_of(glm::cross(a, b)), run = glm::dot(a, b);
  return run >= 0.0 ? slope_deg(rise, run) : 180.0 - slope_deg(rise, -run);
}

class Margin {
 public:
  explicit Margin(const Volume& volume) : volume_(volume) {}

  std::optional<MarginPoint> at(IVec3 cell) {
    base_.load(volume_, Field::base, cell);
    if (!base_.crossed() || !base_.in_band()) return std::nullopt;
    cut_.load(volume_, Field::cut, cell);
    if (!cut_.crossed() || !cut_.in_band()) return std::nullopt;
    Vec3 f(0.5), out, into_void;
    if (!settle(f, out, into_void)) return std::nullopt;
    const Vec3 along = glm::cross(out, into_void) / length_of(glm::cross(out, into_void));
    const Vec2 within = inside_cell(f, along);
    if (!(within.y > within.x)) return std::nullopt;
    f += 0.5 * (within.x + within.y) * along;  // the middle of what passes the cell
    if (!settle(f, out, into_void)) return std::nullopt;
    const Grid& grid = volume_.grid();
    MarginPoint point;
    point.at_mm = grid.origin_mm + grid.voxel_mm * (Vec3(cell) + f);
    point.out = out / length_of(out);
    point.into_void = into_void / length_of(into_void);
    const Vec3 tissue_at = point.at_mm - grid.voxel_mm * (point.out + point.into_void);
    if (!is_own_hard(volume_.specimen().tissue(nearest_voxel(grid, tissue_at)))) return std::nullopt;
    point.weight = within.y - within.x;
    point.angle_deg = angle(point);
    return point;
  }

 private:
  /// Moves a place of the loaded cell to where both distances are 0. False where the surfaces touch without an edge, and away from
  /// the cell.
  bool settle(Vec3& f, Vec3& out, Vec3& into_void) {
    for (int pass = 0; pass < 8; ++pass) {
      const double b = base_.eval(f, out), c = cut_.eval(f, into_void);
      // The least step that brings both distances to 0.
      const double oo = glm::dot(out, out), oc = glm::dot(out, into_void), cc = glm::dot(into_void, into_void);
      const double determinant = oo * cc - oc * oc;
      if (!(determinant > 0.04)) return false;
      f -= ((b * cc - c * oc) * out + (c * oo - b * oc) * into_void) / determinant;
      if (glm::any(glm::lessThan(f, Vec3(-1.0))) || glm::any(glm::greaterThan(f, Vec3(2.0)))) return false;
    }
    return true;
  }
  /// Lengths along a line where it enters and leaves the cell. A line that passes beside leaves no later than it enters.
  static Vec2 inside_cell(Vec3 f, Vec3 along) noexcept {
    Vec2 out(-2.0, 2.0);
    for (int axis = 0; axis < 3; ++axis) {
      constexpr double kLevel = 1e-9;
      if (std::fabs(along[axis]) < kLevel) {
        if (f[axis] < 0.0 || f[axis] >= 1.0) return Vec2(0.0);
        continue;
      }
      const double a = -f[axis] / along[axis], b = (1.0 - f[axis]) / along[axis];
      out = {std::max(out.x, std::min(a, b)), std::min(out.y, std::max(a, b))};
    }
    return out;
  }
  std::optional<double> angle(const MarginPoint& m) {
    if (2.0 * volume_.grid().voxel_mm > kChordMm) return std::nullopt;
    const double across = glm::dot(m.out, m.into_void);
    const std::optional<Vec3> wall = chord(m, Field::cut, -(m.out - across * m.into_void));
    const std::optional<Vec3> skin = chord(m, Field::base, -(m.into_void - across * m.out));
    return wall && skin ? std::optional(between_deg(*wall, *skin)) : std::nullopt;
  }
  /// From the margin to the place of the surface that lies kChordMm off; nullopt where the other surface has taken it.
  std::optional<Vec3> chord(const MarginPoint& m, Field field, Vec3 way) {
    Vec3 reach = kChordMm * way / length_of(way);
    const Vec3 tangent = glm::normalize(glm::cross(m.out, m.into_void));
    for (int pass = 0; pass < 6; ++pass) {
      const FieldPoint on = cells_.at(volume_, field, m.at_mm + reach);
      if (!on.known || std::fabs(glm::dot(on.normal, tangent)) > kLeastCorner) return std::nullopt;
      reach -= on.d_mm * on.normal;
      reach -= glm::dot(reach, tangent) * tangent;  // at right angles to the margin
      reach *= kChordMm / length_of(reach);
    }
    const FieldPoint other = cells_.at(volume_, field == Field::cut ? Field::base : Field::cut, m.at_mm + reach);
    return other.d_mm < 0.0 ? std::optional(reach) : std::nullopt;
  }

  const Volume& volume_;
  CellField base_, cut_;
  FieldCells cells_;
};

/// What two ends of a chord that are a place's uncertainty off make of an angle.
double chord_sigma_deg(double point_sigma_mm) noexcept { return std::sqrt(2.0) * point_sigma_mm / kChordMm * kDegreesPerRadian; }

}  // namespace

std::vector<MarginPoint> margin_points(const Volume& volume) {
  std::vector<MarginPoint> out;
  if (volume.specimen().reading() == Reading::filled) return out;
  Margin margin(volume);
  for (const int brick : bricks_to_measure(volume)) {
    const IVec3 corner = volume.specimen().brick_at(brick) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; ++o)
      if (auto point = margin.at(corner + IVec3(o & 7, o >> 3 & 7, o >> 6))) out.push_back(*point);
  }
  return out;
}

std::optional<Cavosurface> cavosurface(const std::vector<MarginPoint>& margin, double point_sigma_mm) {
  const double sigma = chord_sigma_deg(point_sigma_mm);
  double sum = 0, squares = 0, all = 0, off = 0, uncertain = 0, without = 0, worst = -180;
  Cavosurface out;
  for (const MarginPoint& m : margin) {
    if (!m.angle_deg) {
      without += m.weight;
      continue;
    }
    const double deg = *m.angle_deg;
    const double beyond = std::max(kLeastCavosurfaceDeg - deg, deg - kMostCavosurfaceDeg);
    sum += m.weight * deg;
    squares += m.weight * deg * deg;
    all += m.weight;
    if (beyond > 0.0) off += m.weight;
    if (std::fabs(beyond) < sigma) uncertain += m.weight;
    if (beyond > worst) out.worst_at_mm = m.at_mm;
    worst = std::max(worst, beyond);
  }
  if (!(all > 0.0)) return std::nullopt;
  out.mean_deg = sum / all;
  const double spread_deg = std::sqrt(std::max(0.0, squares / all - out.mean_deg * out.mean_deg));
  out.mean_uncertainty_deg = kMeanSigmaVoxels / kBandedPointVoxels * sigma + kWithoutFactor * without / (all + without) * spread_deg;
  out.off_share = off / all;
  out.off_uncertainty = std::min(1.0, (uncertain + without) / all);
  return out;
}

void add_margin(const std::vector<MarginPoint>& margin, const Reference& reference, std::vector<Measure>& out) {
  if (const auto found = cavosurface(margin, reference.point_sigma_mm())) {
    out.push_back({"cavosurface_angle", true, found->mean_deg, found->mean_uncertainty_deg, "deg", found->worst_at_mm});
    out.push_back({"cavosurface_off", true, 100.0 * found->off_share, 100.0 * found->off_uncertainty, "%", found->worst_at_mm});
    return;
  }
  out.push_back(not_measured("cavosurface_angle", "deg"));
  out.push_back(not_measured("cavosurface_off", "%"));
}

}  // namespace cusp::scenarios
