#include "ui/editor/target_preview.h"

#include <algorithm>
#include <array>

#include "scenarios/shapes/target.h"
#include "ui/modules.h"
#include "ui/render/target_look.h"

namespace cusp::ui {
namespace {

TargetLook look_of(const PreviewWish& wish) { return {wish.target, wish.leeway, wish.whole->specimen_ptr()}; }

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

std::vector<OverlayLine> preview_lines(const PreviewWish& wish) { return look_of(wish).lines(*wish.whole); }

TargetPreview make_preview(const PreviewWish& wish) {
  const TargetLook look = look_of(wish);
  TargetPreview out;
  out.lines = look.lines(*wish.whole);
  Volume volume = *wish.whole;
  if (wish.carved && !look.empty()) carve_target(volume, look.shape());
  FeedSettings settings = look.feed();
  // The ideal preparation has neither over-cut nor uncut remainder.
  if (wish.carved) settings.deviation = {};
  out.patches = std::make_shared<PatchFeed>(std::move(settings));
  out.patches->build_all(volume);
  out.shown = std::make_shared<const Volume>(std::move(volume));
  return out;
}

}  // namespace cusp::ui
