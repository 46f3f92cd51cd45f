#include "ui/editor/target_preview.h"

#include <algorithm>
#include <array>

#include "scenarios/shapes/target.h"
#include "ui/modules.h"
#include "ui/render/target_look.h"

namespace cusp::ui {
namespace {

constexpr double kRegionMarginMm = 0.4, kRegionLidMm = 10.0;  // as TargetLook: cusps above the reference plane belong to it

/// TargetLook alone has no specimen for leaves of voxels.
TargetShape shape_of(const PreviewWish& wish) { return TargetShape(wish.target, lent(wish.whole->specimen())); }

std::vector<OverlayLine> lines_of(const PreviewWish& wish, const TargetShape& shape) {
  if (!needs_voxels(wish.target)) return TargetLook(wish.target, wish.leeway).lines(*wish.whole);
  return target_lines(*wish.whole, [&shape](Vec3 p) { return shape.distance_mm(p); }, wish.leeway.side_mm);
}

FeedSettings feed_of(const PreviewWish& wish, const TargetShape& shape) {
  FeedSettings out = TargetLook(wish.target, wish.leeway).feed();
  if (needs_voxels(wish.target)) {
    const double beside = wish.leeway.most() + kRegionMarginMm;
    out.region = Box{Vec3(shape.low() - beside, shape.floor_mm() - beside), Vec3(shape.high() + beside, shape.top_mm() + kRegionLidMm)};
  }
  // The ideal preparation has neither over-cut nor uncut remainder.
  if (wish.carved) out.deviation = {};
  return out;
}

/// Carves the target out: the cut field becomes the distance to the target's wall.
void carve_target(Volume& volume, const TargetShape& shape) {
  const Grid& grid = volume.grid();
  const Specimen& specimen = volume.specimen();
  const double h = grid.voxel_mm, reach = (kBandVoxels + 1) * h;
  const IVec3 n = specimen.brick_count();
  for (int b = 0; b < n.x * n.y * n.z; ++b) {
    if (!volume.cuttable(b)) continue;
    const IVec3 corner = specimen.brick_at(b) * kBrickEdge;
    const Vec3 low = grid.centre_mm(corner), high = grid.centre_mm(corner + IVec3(kBrickEdge - 1));
    if (high.z < shape.floor_mm() - reach || high.x < shape.low().x - reach || low.x > shape.high().x + reach ||
        high.y < shape.low().y - reach || low.y > shape.high().y + reach) {
      continue;
    }
    std::array<std::uint16_t, kBrickVoxels> left;
    bool any = false;
    for (int z = 0; z < kBrickEdge; ++z) {
      for (int y = 0; y < kBrickEdge; ++y) {
        for (int x = 0; x < kBrickEdge; ++x) {
          const double inside = -shape.distance_mm(grid.centre_mm(corner + IVec3(x, y, z)));
          const std::uint16_t s = solid_from_distance(inside / h);
          left[static_cast<std::size_t>(brick_offset(x, y, z))] = s;
          any = any || s < kSolid;
        }
      }
    }
    if (!any) continue;
    std::uint16_t* cut = volume.cut_for_writing(b);
    if (!cut) return;
    std::ranges::copy(left, cut);
    volume.touched(b);
  }
}

}  // namespace

std::vector<OverlayLine> preview_lines(const PreviewWish& wish) { return lines_of(wish, shape_of(wish)); }

TargetPreview make_preview(const PreviewWish& wish) {
  const TargetShape shape = shape_of(wish);
  TargetPreview out;
  out.lines = lines_of(wish, shape);
  Volume volume = *wish.whole;
  if (wish.carved && !shape.empty()) carve_target(volume, shape);
  out.patches = std::make_shared<PatchFeed>(feed_of(wish, shape));
  out.patches->build_all(volume);
  out.shown = std::make_shared<const Volume>(std::move(volume));
  return out;
}

}  // namespace cusp::ui
