// The neck at the mouth of what its own ball has milled: it touches what is left there, and nothing that the ball has swept.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <ostream>
#include <vector>

#include "engine/step/state.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// A ball that is led down in circles, as a student widens a hole.
struct Spiral {
  const char* name;
  double radius_mm, neck_mm, voxel_mm, circle_mm, radians_per_s;
  friend void PrintTo(const Spiral& spiral, std::ostream* out) { *out << spiral.name; }
};

class AtTheMouth : public testing::TestWithParam<Spiral> {
 protected:
  static constexpr double kFaceMm = 1.4;
  static constexpr int kTicks = 3000;
  std::shared_ptr<const Scene> scene() const {
    auto out = scene_of(from_distance(4.0, GetParam().voxel_mm, [](Vec3 p) { return box_distance(p, Vec3(2.0, 2.0, kFaceMm)); }), Method::surface,
                        GetParam().radius_mm, 4.0);
    out->burs[0].neck_radius_mm = GetParam().neck_mm;
    return out;
  }
  StepInput led(int tick) const {
    const double t = 1e-3 * tick, turn = GetParam().radians_per_s * t, out = GetParam().circle_mm;
    const double over = t < 0.1 ? 0.6 - 5.0 * t : std::max(0.1 - 0.5 * (t - 0.1), -0.9);
    return input_at({out * std::sin(turn), out - out * std::cos(turn), kFaceMm + over}, tick > 40 ? CutButton::pressed : CutButton::up);
  }
};

TEST_P(AtTheMouth, the_neck_never_keeps_the_search_from_ending) {
  StepState state(scene());
  int run = 0, longest = 0, without_pose = 0;
  for (int tick = 0; tick < kTicks; ++tick) {
    const StepOutput out = step(state, led(tick));
    run = out.deferred ? run + 1 : 0;
    longest = std::max(longest, run);
    without_pose += out.infeasible;
  }
  EXPECT_LE(longest, 10) << "a tick that is deferred cuts nothing";
  EXPECT_LE(without_pose, 60);
}

TEST_P(AtTheMouth, the_neck_stays_within_what_the_ball_has_swept) {
  const Spiral& of = GetParam();
  StepState state(scene());
  std::vector<Vec3> way;
  double deepest = 0.0;
  const auto unswept_mm = [&](Vec3 p) {
    double out = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < way.size() && out > 0.0; ++i) {
      const Vec3 along = way[i] - way[i - 1], off = p - way[i - 1];
      const double square = glm::dot(along, along);
      const double t = square > 0.0 ? std::clamp(glm::dot(off, along) / square, 0.0, 1.0) : 0.0;
      out = std::min(out, length(off - along * t) - of.radius_mm);
    }
    return out;
  };
  bool touched = false;
  for (int tick = 0; tick < kTicks; ++tick) {
    const StepOutput out = step(state, led(tick));
    touched = touched || out.shank;
    if (way.empty() || out.proxy_mm != way.back()) way.push_back(out.proxy_mm);
    if (tick % 60 != 0) continue;
    for (const double under : {0.0, 0.05, 0.1})
      for (int k = 0; k < 48; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 48.0;
        const Vec3 p(out.proxy_mm.x + of.neck_mm * std::cos(angle), out.proxy_mm.y + of.neck_mm * std::sin(angle), kFaceMm - under);
        if (p.z > out.proxy_mm.z) deepest = std::max(deepest, unswept_mm(p));
      }
  }
  EXPECT_TRUE(touched);
  EXPECT_LE(deepest / of.voxel_mm, bound(0.3)) << "voxels";
}

TEST_P(AtTheMouth, what_is_kept_of_its_points_changes_no_answer) {
  const auto shared = scene();
  StepState keeps(shared), forgets(shared);
  for (int tick = 0; tick < kTicks; ++tick) {
    forgets.inner().surface->forget();
    const StepOutput a = step(keeps, led(tick)), b = step(forgets, led(tick));
    ASSERT_TRUE(a.proxy_mm == b.proxy_mm && a.force_n == b.force_n && a.deferred == b.deferred) << "tick " << tick;
  }
  EXPECT_EQ(keeps.hash(), forgets.hash());
}

INSTANTIATE_TEST_SUITE_P(Spirals, AtTheMouth,
                         testing::Values(Spiral{"coarse", 0.4, 0.25, 0.15, 0.3, 4.0}, Spiral{"wide", 0.5, 0.3, 0.1, 0.6, 1.0},
                                         Spiral{"fine", 0.4, 0.25, kPaperVoxelMm, 0.6, 1.0}),
                         [](const auto& p) { return p.param.name; });

}  // namespace
}  // namespace cusp::test
