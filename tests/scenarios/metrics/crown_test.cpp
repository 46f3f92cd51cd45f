// Preparations carved by analysis in the crowns of three grown teeth, turned and shifted against the grid: each value within its stated
// uncertainty. Three cases at voxels of 0.1 mm; with CUSP_FULL=1 twenty orientations of each tooth, three preparations in each at
// 0.1 mm and two at 0.05 and 0.078 mm, and the rows of scenarios/metrics/errors.md on stdout.

#include "tests/engine/volume/carved.h"
#include "tests/scenarios/metrics/box_exercise.h"
#include "tests/scenarios/metrics/crown_truth.h"

namespace cusp::test {
namespace {

constexpr std::array kTeeth = {36, 24, 16};

Scenario exercise_of(const TurnedCrown& crown, const Preparation& p, const UprightBox& target) {
  Scenario s = box_exercise_on_36({2 * target.half_x, 2 * target.half_y, target.depth}, {Tissue::enamel, 3, 0.5});
  s.tissues.push_back({Tissue::dentine, 2, 1.6});
  s.specimen.fdi = crown.fdi();
  s.target.outline.paths = {{p.place - Vec3(0, 0, target.depth)}};
  s.target.outline.top_mm = p.place.z;
  s.target.outline.corner_radius_mm = target.corner;
  return s;
}

void measure_in(const TurnedCrown& crown, const std::shared_ptr<const Specimen>& specimen, Kind kind, Draw& draw, KnownRows& rows) {
  Preparation p = random_preparation(kind, draw);
  p.turn = direction(draw(-15, 15));
  if (kind != Kind::slot)
    for (Vec2& lean : p.lean) lean = direction(draw(-8, 7));
  const double x = draw(-0.4, 0.4), y = draw(-0.4, 0.4);
  p.place = crown.middle() + Vec3(x, y, 0.0);
  const UprightBox target{.half_x = p.half_x - 0.3, .half_y = p.half_y - 0.25, .depth = draw(1.5, 2.2)};
  const double voxel_mm = specimen->grid().voxel_mm;
  const auto truth = CrownTruth(crown, p, target).values(voxel_mm);
  Scenario s = exercise_of(crown, p, target);
  s.rubric = rubric_of(truth);
  Volume volume(specimen);
  carved::carve(volume, [&](Vec3 at) { return p.distance(at); });
  count_case(measure(Reference(s, specimen), volume, {}), truth, rows);
}

TEST(Crown, OfAKnownPreparationIsMeasuredWithinItsUncertainty) {
  constexpr std::uint64_t kSeed = 51;
  KnownTable table("crown");
  for (const double voxel_mm : known_voxels()) {
    Draw draw{std::mt19937_64(kSeed)};
    std::vector<Orientation> orientations;
    for (int i = 0; i < (full_run() ? 20 : 1); ++i) orientations.push_back(random_orientation(draw));
    int kind = 0;
    for (const int fdi : kTeeth)
      for (const Orientation& orientation : orientations) {
        const double x = draw(0, 1), y = draw(0, 1), z = draw(0, 1);
        const TurnedCrown crown(fdi, voxel_mm, orientation, voxel_mm * Vec3(x, y, z));
        const auto specimen = specimen_of(crown, voxel_mm);
        for (int i = 0; i < known_cases(voxel_mm, 1, 3); ++i)
          measure_in(crown, specimen, std::array{Kind::tapered, Kind::rounded, Kind::slot}[static_cast<std::size_t>(kind++ % 3)], draw, table.rows(voxel_mm));
      }
  }
  // Of a fissured surface much of the margin has no angle. Where the crown falls off, a wall is half a millimetre high.
  table.expect(kSeed, {"cavosurface_angle", "cavosurface_off", "convergence_buccolingual", "convergence_mesiodistal", "wall_angle_distal", "wall_angle_mesial"});
}

}  // namespace
}  // namespace cusp::test
