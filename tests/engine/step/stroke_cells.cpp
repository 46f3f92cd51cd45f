// Features that strokes give to the cells that they shape, against the exact balls.
#include <gtest/gtest.h>

#include "engine/contact/stroke_cells.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {


struct Stroke {
  Vec3 a, b;
};
constexpr double kStrokeRadiusMm = 0.4;
/// Two scratches that cross under a right angle at one depth: ridges between them, and four corners where these come out.
const Stroke kOne{Vec3(-1.3, 0.11, 0.21), Vec3(1.3, 0.05, 0.19)}, kOther{Vec3(0.07, -1.3, 0.2), Vec3(-0.02, 1.3, 0.22)};

/// Depth of a place in the ball swept along a stroke (mm): positive where it has been.
double depth(const Stroke& s, Vec3 p) {
  const Vec3 along = s.b - s.a;
  const double t = std::clamp(glm::dot(p - s.a, along) / glm::dot(along, along), 0.0, 1.0);
  return kStrokeRadiusMm - length(p - s.a - t * along);
}

class Scratched : public testing::Test {
 protected:
  Scratched() {
    auto scene = scene_of(from_distance(3.0, kPaperVoxelMm, [](Vec3 p) { return p.z; }), Method::surface, kStrokeRadiusMm);
    state = std::make_unique<StepState>(scene);
    for (const Stroke& s : {kOne, kOther}) {
      cut_along(*state, 0, s.a, s.b);
      memory.add(s.a, s.b, {kStrokeRadiusMm});
      memory.break_path();
    }
  }
  /// Calls visit(cell, features) for every cell that more than one stroke shapes.
  template <class Visit>
  void each(Visit&& visit) {
    StrokeCells cells;
    const Volume& volume = state->volume();
    for (const int brick : volume.cut_bricks()) {
      const IVec3 corner = volume.specimen().brick_at(brick) * kBrickEdge;
      cells.turn_to(memory, volume.grid(), corner);
      for (int o = 0; o < kBrickVoxels; ++o) {
        const IVec3 local(o & 7, o >> 3 & 7, o >> 6);
        CellField cut, base;
        cut.load(volume, Field::cut, corner + local);
        base.load(volume, Field::base, corner + local);
        if (cut.crossed() && cells.explain(local, cut, 2)) visit(corner + local, cells.features(&base));
      }
    }
  }
  Vec3 place(IVec3 cell, Vec3 at) const {
    return state->volume().grid().origin_mm + kPaperVoxelMm * (Vec3(cell) + at);
  }
  std::unique_ptr<StepState> state;
  CutMemory memory;
};

TEST_F(Scratched, every_feature_lies_on_what_it_stands_for) {
  int edges = 0, points = 0;
  each([&](IVec3 cell, std::span<const StrokeFeature> features) {
    for (const StrokeFeature& f : features) {
      for (int k = 0; k <= (f.edge ? 8 : 0); ++k) {
        const double t = f.edge ? f.from + (f.to - f.from) * k / 8 : 0.0;
        const Vec3 p = place(cell, f.at + t * (f.normal + t * (f.bend + t * (f.twist + t * f.fourth))));
        // Of face, one stroke and the other an edge lies on two, a point on one, and none has taken it.
        double d[3] = {std::fabs(p.z), std::fabs(depth(kOne, p)), std::fabs(depth(kOther, p))};
        std::sort(d, d + 3);
        EXPECT_LT(d[f.edge ? 1 : 0], 1e-4);  // mm; the field rounds these edges by up to 0.02
        EXPECT_LT(std::max({p.z, depth(kOne, p), depth(kOther, p)}), 2e-4);
      }
      (f.edge ? edges : points) += 1;
    }
  });
  EXPECT_GT(edges, 40);   // both ridges and the mouth beside them
  EXPECT_GT(points, 40);
}

TEST_F(Scratched, a_point_knows_the_surfaces_that_end_its_plane) {
  int both = 0;
  each([&](IVec3 cell, std::span<const StrokeFeature> features) {
    for (const StrokeFeature& f : features) {
      if (f.edge) continue;
      const Vec3 p = place(cell, f.at);
      for (int k = 0; k < f.besides; ++k) {
        double nearest = 1e300;
        for (const double d : {p.z, depth(kOne, p), depth(kOther, p)}) nearest = std::min(nearest, std::fabs(d - f.beside[k].d * kPaperVoxelMm));
        EXPECT_LT(nearest, 1e-4);
      }
      both += f.besides == 2;
    }
  });
  EXPECT_GT(both, 0);
}

TEST_F(Scratched, what_another_ball_has_cut_is_not_explained) {
  CutMemory wider;
  for (const Stroke& s : {kOne, kOther}) {
    wider.add(s.a, s.b, {kStrokeRadiusMm + 0.01});
    wider.break_path();
  }
  std::swap(memory, wider);
  int cells = 0;
  each([&](IVec3, std::span<const StrokeFeature>) { ++cells; });
  EXPECT_EQ(cells, 0);
}

}  // namespace
}  // namespace cusp::test
