// Enamel over a groove, and caries under the middle of a round tooth, against their closed forms.
// Four cases at voxels of 0.1 mm; with CUSP_FULL=1 two hundred, a hundred each at 0.05 and 0.078 mm, and the rows of
// scenarios/metrics/errors.md on stdout.

#include "scenarios/metrics/caries.h"

#include "scenarios/metrics/unsupported.h"
#include "tests/full_run.h"
#include "tests/scenarios/metrics/two_teeth.h"

namespace cusp::test {
namespace {

TEST(Unsupported, EnamelOverAKnownGrooveIsWithinItsUncertainty) {
  constexpr std::uint64_t kSeed = 43;
  KnownTable table("block");
  for (const double voxel_mm : known_voxels()) {
    Draw draw{std::mt19937_64(kSeed)};
    for (int i = 0; i < known_cases(voxel_mm, 4, 40); ++i) {
      const UndercutSlot cut{draw(0.5, 0.9), draw(0.4, 0.6), draw(1.8, 2.2), i % 4 == 0 ? 0.0 : draw(0.05, 0.3), draw(0.7, 1.3)};
      const auto specimen = two_teeth(voxel_mm, draw, UndercutSlot::tissue);
      const std::map<std::string, double> truth = {{"unsupported_enamel", cut.unsupported_mm3()}};
      Scenario s = exercise();
      s.rubric = rubric_of(truth);
      Volume volume(specimen);
      carved::carve(volume, [&](Vec3 p) { return cut.distance(p); });
      count_groups(Reference(s, specimen), volume, truth, table.rows(voxel_mm));
    }
  }
  table.expect(kSeed);
}

std::map<std::string, double> caries_truth(const Lesion& lesion, double cut_z) {
  std::map<std::string, double> out = {{"caries_left_periphery", 0}, {"caries_left_pulp", 0}, {"caries_left_pulp_firm", 0}};
  const double step = 0.025;
  for (double x = -lesion.radius; x < lesion.radius; x += step)
    for (double y = -lesion.radius; y < lesion.radius; y += step)
      for (double z = -lesion.radius; z < lesion.radius; z += step) {
        const Vec3 p = lesion.at + Vec3(x, y, z);
        const Tissue t = lesion(p);
        if (p.z > cut_z || (t != Tissue::carious_dentine && t != kFirmCariousDentine)) continue;
        const bool periphery = ball_distance(p, Vec3(0, 0, kMiddle), kDentineRadius) > -kPeripheryMm;
        out[periphery ? "caries_left_periphery" : t == kFirmCariousDentine ? "caries_left_pulp_firm" : "caries_left_pulp"] += step * step * step;
      }
  return out;
}

TEST(Caries, LeftOfAKnownLesionIsWithinItsUncertainty) {
  constexpr std::uint64_t kSeed = 42;
  KnownTable table("block");
  for (const double voxel_mm : known_voxels()) {
    Draw draw{std::mt19937_64(kSeed)};
    for (int i = 0; i < known_cases(voxel_mm, 4, 200); ++i) {
      const Lesion lesion{Vec3(draw(1.9, 2.4), draw(-0.5, 0.5), draw(-1.6, -1.2)), draw(0.8, 1.0)};
      const auto specimen = two_teeth(voxel_mm, draw, lesion);
      Scenario s = exercise();
      const double cut_z = draw(-2.0, -1.2);
      Volume volume(specimen);
      carved::carve(volume, [&](Vec3 p) { return box_distance(p, Vec3(2, 0, cut_z + 2), Vec3(1.5, 1.5, 2)); });
      const auto truth = caries_truth(lesion, cut_z);
      s.rubric = rubric_of(truth);
      count_groups(Reference(s, specimen), volume, truth, table.rows(voxel_mm));
    }
  }
  table.expect(kSeed);
}

TEST(Caries, SoundTissueWithinThePermittedAccessIsNotLost) {
  Draw draw{std::mt19937_64(1)};
  const Lesion lesion;
  const auto specimen = two_teeth(0.1, draw, lesion);
  Scenario s = exercise();
  s.target = box_region({1, 0, -0.5}, {2.4, 2.4, 3});  // down to z = -2
  s.leeway = {0.2, 0.2};
  const auto lost = [&](double down_to) {
    Volume volume(specimen);
    carved::carve(volume, [&](Vec3 p) { return box_distance(p, Vec3(1, 0, 0.5 * (1 + down_to)), Vec3(1.2, 1.2, 0.5 * (1 - down_to))); });
    return get(measure(Reference(s, specimen), volume, {}), "sound_lost").value;
  };
  EXPECT_NEAR(lost(-2.0), 0.0, 0.01);
  // 0.5 mm below the zone, 2.4 x 2.4 mm, less what of the lesion's ball reaches there: none below z = -2.1.
  EXPECT_NEAR(lost(-2.7), 0.5 * 5.76, 0.1);
}

TEST(Caries, WithoutALesionIsNotMeasured) {
  Draw draw{std::mt19937_64(1)};
  const auto specimen = two_teeth(0.1, draw, tissue_at);
  const auto measures = measure(Reference(exercise(), specimen), Volume(specimen), {});
  for (const char* metric : {"caries_left_periphery", "caries_left_pulp", "caries_left_pulp_firm", "caries_left_enamel"}) EXPECT_FALSE(get(measures, metric).measured) << metric;
}

}  // namespace
}  // namespace cusp::test
