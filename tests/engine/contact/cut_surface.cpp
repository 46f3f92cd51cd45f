// What a brick keeps of cells that no look asks for.
#include "engine/contact/features/cut_surface.h"

#include <gtest/gtest.h>

#include "engine/removal/carve.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

constexpr double kBlockVoxelMm = 0.1, kHoleMm = 0.5;

CellsNear every_cell(unsigned) { return CellsNear::all(); }
CellsNear no_cell(unsigned) { return CellsNear{}; }

/// Features of all bricks that are cut.
template <class Cells>
int features_of(CutSurface& surface, const Volume& volume, Cells&& cells) {
  int out = 0;
  for (const std::int32_t brick : volume.cut_bricks())
    for (std::int32_t p = surface.first(volume, brick, cells); p >= 0; p = surface.page(p).next) out += surface.page(p).count;
  return out;
}

TEST(CutSurface, a_feature_that_was_cut_away_is_gone_after_looks_elsewhere_too) {
  Volume volume(Specimen::build(from_distance(3.0, kBlockVoxelMm, [](Vec3 p) { return box_distance(p, Vec3(1.4)); }), Reading::banded));
  CutSurface surface(volume);
  const auto cut_to = [&](double z) {
    for_changed(carve_sweep(volume, Vec3(0.0, 0.0, 1.6), Vec3(0.0, 0.0, z), kHoleMm), [&](const ChangedVoxels& c) { surface.changed(volume, c); });
  };
  cut_to(1.2);
  EXPECT_GT(features_of(surface, volume, every_cell), 0);
  cut_to(0.6);
  features_of(surface, volume, no_cell);
  CutSurface anew(volume);
  EXPECT_EQ(features_of(surface, volume, every_cell), features_of(anew, volume, every_cell));
}

}  // namespace
}  // namespace cusp::test
