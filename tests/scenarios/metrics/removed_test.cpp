// The metrics' removed volume equals the loss of the volume, tissue by tissue.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/step/step.h"
#include "engine/volume/cut_volume.h"
#include "scenarios/metrics/live.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/shapes/distance.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

Scenario slot() {
  Scenario s;
  s.tissues = {{Tissue::enamel, 3, 0.4}, {Tissue::dentine, 2, 1.6}, {Tissue::pulp, 0.5, 5}};
  s.instruments = {{}};
  s.target.outline.shape = "channel";
  s.target.outline.paths = {{Vec3(-1, 0, -1), Vec3(1, 0, -1)}};
  s.target.outline.width_mm = 1.2;
  s.target.outline.depth_mm = 1.0;
  s.target.outline.corner_radius_mm = 0.5;
  s.leeway.floor_mm = 0.2;
  s.leeway.side_mm = 0.2;
  return s;
}

class EveryReading : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Removed, EveryReading, testing::Values(Method::surface, Method::occupancy),
                         [](const auto& i) { return std::string(key_of(i.param)); });

TEST_P(EveryReading, tissue_by_tissue_the_metrics_equal_what_the_volume_lost) {
  // A block of 4 x 3 x 2.4 mm, top at z = 0; its layers lie obliquely: enamel, dentine, and pulp below.
  Grid grid{IVec3(50, 40, 34), 0.1, Vec3(-2.46, -1.94, -2.91)};
  const auto specimen = carved::specimen(
      grid, reading_of(GetParam()), [](Vec3 p) { return box_distance(p, Vec3(0, 0, -1.2), Vec3(2.0, 1.5, 1.2)); },
      [](Vec3 p) {
        const double depth = p.z + 0.3 * p.x + 0.2 * p.y;
        return depth > -0.2 ? Tissue::enamel : depth > -0.45 ? Tissue::dentine : Tissue::pulp;
      });
  auto scene = std::make_shared<Scene>();
  scene->specimen = specimen;
  scene->method = GetParam();
  Bur bur;
  bur.radius_mm = 0.5;
  bur.neck_radius_mm = 0.2;
  scene->burs = {bur};
  for (TissueFeel& feel : scene->tissues) feel = {1.0, 6.0};
  scene->full_force_n = 0.1;
  scene->guard = unguarded();
  StepState state(scene);
  const auto reference = std::make_shared<const Reference>(slot(), specimen);
  LiveMetrics live(reference);
  for (int k = 0; k < 1600; ++k) {
    StepInput input;
    input.x = static_cast<std::int32_t>(10000.0 * std::sin(0.01 * k));
    input.y = static_cast<std::int32_t>(2000.0 * std::cos(0.013 * k));
    input.z = 8000 - 10 * k;
    input.buttons = k > 50 && k < 1599 ? StepInput::kCut : std::uint16_t{0};
    step(state, input);
  }
  const Volume& volume = state.volume();
  const SolidMeasure lost = removed_solid(volume);
  ASSERT_GT(lost.mm3[index_of(Tissue::enamel)], 0.05);
  ASSERT_GT(lost.mm3[index_of(Tissue::dentine)], 0.05);
  ASSERT_GT(lost.mm3[index_of(Tissue::pulp)], 0.01);
  live.update(volume, volume.cut_bricks());
  const std::vector<Measure> measures = measure(*reference, volume, Process());
  double whole = 0.0;
  for (const Tissue tissue : {Tissue::enamel, Tissue::dentine, Tissue::pulp}) {
    const double mm3 = lost.mm3[index_of(tissue)];
    bool found = false;
    for (const Measure& m : measures) {
      if (m.metric != removed_key(tissue)) continue;
      found = true;
      EXPECT_NEAR(m.value, mm3, 1e-6 * mm3) << m.metric;
    }
    EXPECT_TRUE(found);
    EXPECT_NEAR(live.reading().removed_mm3[index_of(tissue)], mm3, 1e-6 * mm3);
    whole += mm3;
  }
  // And by place: what was rightly removed and what was not are all of it.
  double by_place = 0.0;
  for (const double mm3 : live.reading().overcut_mm3) by_place += mm3;
  EXPECT_NEAR(by_place, whole, 1e-6 * whole);
}

}  // namespace
}  // namespace cusp::test
