// The tooth with the ideal preparation of a target whose leaves are of its own voxels.

#include <gtest/gtest.h>

#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "tests/modules.h"
#include "ui/editor/target_preview.h"

namespace cusp::test {
namespace {

struct LesionPreview : testing::Test {
  Scenario scenario = *load_builtin("caries-26");
  std::shared_ptr<const Volume> whole;
  void SetUp() override {
    scenario.specimen.voxel_mm = 0.2;
    whole = std::make_shared<const Volume>(Specimen::build(make_specimen(scenario.specimen, {}).value(), Reading::banded));
  }
  PreviewWish wish(double grown_mm, bool carved = true) const {
    Region lesion, grown;
    lesion.kind = RegionKind::lesion;
    grown.kind = RegionKind::offset;
    grown.by_mm = grown_mm;
    grown.parts = {lesion};
    return {whole, grown, scenario.leeway, carved};
  }
  template <class Visit>
  void each_voxel(Visit&& visit) const {
    const IVec3 n = whole->specimen().brick_count() * kBrickEdge;
    IVec3 v;
    for (v.z = 0; v.z < n.z; ++v.z)
      for (v.y = 0; v.y < n.y; ++v.y)
        for (v.x = 0; v.x < n.x; ++v.x) visit(v, whole->specimen().tissue(v));
  }
  /// Voxels that the ideal preparation takes, and of them those that are sound.
  std::pair<int, int> taken(const Volume& shown) const {
    std::pair<int, int> out;
    each_voxel([&](IVec3 v, Tissue tissue) {
      if (tissue == Tissue::empty || whole->specimen().s(v) < kSolid || shown.cut(v) >= kSolid / 2) return;
      ++out.first;
      out.second += tissue == Tissue::enamel || tissue == Tissue::dentine ? 1 : 0;
    });
    return out;
  }
};

TEST_F(LesionPreview, is_carved_out_of_the_tooth_and_follows_its_growth) {
  const auto [alone, beside_it] = taken(*make_preview(wish(0)).shown);
  EXPECT_GT(alone, 100);
  EXPECT_EQ(beside_it, 0);
  const auto [grown, sound] = taken(*make_preview(wish(0.5)).shown);
  EXPECT_GT(grown, alone);
  EXPECT_EQ(grown - sound, alone) << "what was there before is all of the lesion";
  EXPECT_EQ(taken(*make_preview(wish(0.5, false)).shown).first, 0) << "the whole tooth";
}

TEST_F(LesionPreview, has_outlines_on_the_tooth) {
  EXPECT_FALSE(preview_lines(wish(0.5)).empty());
  EXPECT_FALSE(preview_lines({whole, scenario.target, scenario.leeway}).empty());
  EXPECT_EQ(make_preview(wish(0.5)).lines.size(), preview_lines(wish(0.5)).size());
}

}  // namespace
}  // namespace cusp::test
