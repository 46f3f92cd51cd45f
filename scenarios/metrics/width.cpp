#include "scenarios/metrics/width.h"

#include <cmath>

#include "scenarios/metrics/cut_faces.h"

namespace cusp::scenarios {

namespace {

/// A surface whose normal leans less than 60 degrees from the axis is occlusal; a steeper one is proximal, buccal or lingual [M].
constexpr double kOcclusalCosine = 0.5;
/// Two margins face each other if their normals lean less than 45 degrees from opposite.
constexpr double kOppositeCosine = 0.70710678;
/// Beside the line from one margin to the other, voxels: one of the margin's places lies in each cell that it passes.
constexpr double kBesideVoxels = 0.75;
/// Nearer than this the margin meets itself at a line angle, voxels.
constexpr double kNearestVoxels = 1.5;
/// Wider than any crown: nothing faces the margin.
constexpr double kWidestMm = 15.0;

enum class Side : std::uint8_t { buccal, lingual, any, none };

/// A place of the margin in plan.
struct Edge {
  Vec3 at_mm{0.0};
  Vec2 into_void{0.0};  // at right angles to the margin, of length 1
  Side side = Side::none;
};

Side side_of(FaceName wall) noexcept {
  return wall == FaceName::buccal_wall ? Side::buccal : wall == FaceName::lingual_wall ? Side::lingual : wall == FaceName::side_wall ? Side::any : Side::none;
}

/// The wall below the margin: by its name in the target, else by its normal.
Side side_of(const MarginPoint& m, const Reference& reference) {
  const TargetShape& shape = reference.shape();
  if (shape.upright() != nullptr) return reference.mesial_x() == 0 ? Side::any : side_of(wall_by_normal(m.into_void, reference.mesial_x()));
  const std::optional<Facing> facing = shape.facing(m.at_mm, m.into_void);
  if (!facing) return Side::none;
  const bool named = facing->face != FaceName::side_wall || reference.mesial_x() == 0;
  return side_of(named ? facing->face : wall_by_normal(m.into_void, reference.mesial_x()));
}

std::vector<Edge> occlusal_edges(const std::vector<MarginPoint>& margin, const Reference& reference) {
  std::vector<Edge> out;
  for (const MarginPoint& m : margin) {
    if (m.out.z < kOcclusalCosine) continue;
    const Vec3 along = glm::cross(m.out, m.into_void);
    Vec2 across(-along.y, along.x);
    const double length = std::sqrt(glm::dot(across, across)), into = across.x * m.into_void.x + across.y * m.into_void.y;
    if (!(length > 0.0) || into == 0.0) continue;
    const Side side = side_of(m, reference);
    if (side != Side::none) out.push_back({m.at_mm, (into > 0.0 ? 1.0 : -1.0) / length * across, side});
  }
  return out;
}

bool opposite(Side a, Side b) noexcept {
  return a == Side::any || b == Side::any ? a == b : a != b;
}

/// Way from one edge straight into the void to where the other one crosses it; nullopt where it passes beside.
std::optional<double> across(const Edge& from, const Edge& to, double voxel_mm) noexcept {
  const Vec2 way(to.at_mm.x - from.at_mm.x, to.at_mm.y - from.at_mm.y);
  const double facing = -glm::dot(from.into_void, to.into_void);
  if (facing < kOppositeCosine) return std::nullopt;
  const double beside = way.x * from.into_void.y - way.y * from.into_void.x;
  if (std::fabs(beside) > kBesideVoxels * voxel_mm) return std::nullopt;
  const double mm = -glm::dot(way, to.into_void) / facing;
  return mm > kNearestVoxels * voxel_mm && mm < kWidestMm ? std::optional(mm) : std::nullopt;
}

/// Whether the way between two margins passes over the target: a scratch beside the cavity has margins of its own.
bool over_target(const TargetShape& shape, Vec3 from, Vec3 to, double step_mm) noexcept {
  const Vec3 way = to - from;
  const int steps = static_cast<int>(std::ceil(std::sqrt(glm::dot(way, way)) / step_mm));
  for (int i = 1; i < steps; ++i)
    if (shape.distance_mm(from + static_cast<double>(i) / steps * way) < 0.0) return true;
  return false;
}

}  // namespace

std::optional<Isthmus> isthmus(const std::vector<MarginPoint>& margin, const Reference& reference) {
  if (reference.shape().empty()) return std::nullopt;
  const std::vector<Edge> edges = occlusal_edges(margin, reference);
  const double voxel = reference.specimen().grid().voxel_mm;
  std::optional<Isthmus> best;
  for (const Edge& from : edges)
    for (const Edge& to : edges) {
      if (!opposite(from.side, to.side)) continue;
      const std::optional<double> mm = across(from, to, voxel);
      if (!mm || (best && *mm >= best->width_mm) || !over_target(reference.shape(), from.at_mm, to.at_mm, voxel)) continue;
      best = Isthmus{*mm, std::sqrt(2.0) * reference.point_sigma_mm(), from.at_mm, to.at_mm};
    }
  return best;
}

}  // namespace cusp::scenarios
