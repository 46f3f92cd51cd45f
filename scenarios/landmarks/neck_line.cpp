#include "scenarios/landmarks/neck_line.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace cusp::scenarios {

namespace {

constexpr int kWays = 72;
constexpr double kFurthestMm = 9.0;  // from the middle of a tooth to its side

bool is_enamel(Tissue t) noexcept { return t == Tissue::enamel || t == Tissue::carious_enamel; }

/// The tooth's outermost place along a way at one height; nullopt where it has none there.
struct Outermost {
  Vec3 at_mm;
  Tissue tissue;
};
std::optional<Outermost> outermost(const ToothSurface& tooth, Vec2 middle, Vec2 way, int z) noexcept {
  const Grid& grid = tooth.grid();
  const double step = 0.25 * grid.voxel_mm;
  for (double r = kFurthestMm; r > 0.0; r -= step) {
    const Vec2 p = middle + r * way;
    const IVec3 v(static_cast<int>(std::floor((p.x - grid.origin_mm.x) / grid.voxel_mm + 0.5)),
                  static_cast<int>(std::floor((p.y - grid.origin_mm.y) / grid.voxel_mm + 0.5)), z);
    if (tooth.is_tooth(v)) return Outermost{Vec3(p, grid.centre_mm(v).z), tooth.tissue(v)};
  }
  return std::nullopt;
}

/// The border is half a voxel below the last enamel.
std::optional<Vec3> neck_at(const ToothSurface& tooth, Vec2 middle, Vec2 way) noexcept {
  for (int z = 1; z < tooth.grid().size.z; ++z) {
    const auto here = outermost(tooth, middle, way, z);
    if (!here || !is_enamel(here->tissue)) continue;
    if (!outermost(tooth, middle, way, z - 1)) return std::nullopt;
    return here->at_mm - Vec3(0, 0, 0.5 * tooth.grid().voxel_mm);
  }
  return std::nullopt;
}

}  // namespace

std::vector<Vec3> neck_line(const ToothSurface& tooth, Vec2 middle_mm) {
  std::vector<Vec3> out;
  for (int i = 0; i < kWays; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kWays;
    if (const auto p = neck_at(tooth, middle_mm, {std::cos(angle), std::sin(angle)})) out.push_back(*p);
  }
  if (10 * static_cast<int>(out.size()) < 9 * kWays) return {};
  out.push_back(out.front());
  return out;
}

}  // namespace cusp::scenarios
