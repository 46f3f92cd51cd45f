// What the surface method keeps from tick to tick for speed alone decides nothing: not where a search looked before, not where
// its budget ends, not which parts it resolves. One state keeps it, the other loses it before every tick.
#include <gtest/gtest.h>

#include <optional>
#include <ostream>
#include <random>

#include "engine/step/state.h"
#include "engine/tool/heads.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// Two equal states that are stepped alike.
class Twins {
 public:
  explicit Twins(const std::shared_ptr<const Scene>& scene) : keeps_(scene), forgets_(scene) {}
  /// False if they differ in what they answer or in their state.
  bool step_both(const StepInput& input) {
    forgets_.inner().surface->forget();
    const std::int64_t visited = keeps_.inner().surface->candidates_visited();
    const StepOutput a = step(keeps_, input), b = step(forgets_, input);
    beyond_budget_ += keeps_.inner().surface->candidates_visited() - visited > SurfaceContact::kExploring.candidates;
    deferred_ += a.deferred;
    return a.proxy_mm == b.proxy_mm && a.force_n == b.force_n && a.deferred == b.deferred &&
           keeps_.inner().surface->cut_surface().unresolved_parts() == forgets_.inner().surface->cut_surface().unresolved_parts();
  }
  bool same_state() const { return keeps_.hash() == forgets_.hash(); }
  int beyond_budget() const { return beyond_budget_; }
  int deferred() const { return deferred_; }

 private:
  StepState keeps_, forgets_;
  int beyond_budget_ = 0, deferred_ = 0;
};

struct Shape {
  const char* name;
  double radius;
  std::optional<Profile> profile;
  friend void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }
};

class WhatIsKept : public testing::TestWithParam<Shape> {
 protected:
  std::shared_ptr<const Scene> scene(double voxel_mm, const std::function<double(Vec3)>& distance_mm) const {
    auto out = scene_of(from_distance(4.0, voxel_mm, distance_mm), Method::surface, GetParam().radius, 4.0);
    if (GetParam().profile) out->burs[0].head = *GetParam().profile;
    return out;
  }
};

TEST_P(WhatIsKept, never_ends_a_search_elsewhere_over_a_rippled_face_at_40_to_170_mm_per_s) {
  const Shape& shape = GetParam();
  Twins twins(scene(0.05, [](Vec3 p) { return box_distance(p, Vec3(1.8, 1.8, 1.4)) + 0.1 * std::sin(6.0 * p.x) * std::sin(5.0 * p.y); }));
  for (unsigned seed = 0; seed < 6; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    const double pace = 0.02 + 0.07 * part(random), from = 6.0 * part(random), height = 1.2 + shape.radius * part(random);
    for (int k = 0; k < 150; ++k)
      ASSERT_TRUE(twins.step_both(input_at({1.9 * std::sin(from + pace * k), 1.9 * std::cos(from + 0.7 * pace * k),
                                            height + 0.4 * std::sin(0.05 * k)})))
          << "seed " << seed << ", tick " << k;
  }
  EXPECT_TRUE(twins.same_state());
  EXPECT_GT(twins.beyond_budget(), 0) << "no search was long enough to tell";
}

TEST_P(WhatIsKept, never_resolves_an_edge_earlier_in_the_cavity_that_the_bur_has_milled) {
  const double r = GetParam().radius;
  Twins twins(scene(0.1, [](Vec3 p) { return box_distance(p, Vec3(1.8, 1.8, 1.4)); }));
  const auto along = [&](Vec3 from, Vec3 to, int ticks) {
    for (int k = 0; k <= ticks; ++k)
      if (!twins.step_both(input_at(from + (to - from) * (static_cast<double>(k) / ticks)))) return false;
    return true;
  };
  ASSERT_TRUE(along({0.0, 0.0, 2.6}, {0.0, 0.0, 1.4 + r}, 40));
  Vec3 at(0.0);
  for (int k = 0; k < 700; ++k) {
    const double shake = 0.03 * std::sin(2.3 * k);
    at = {0.8 * std::sin(0.0131 * k) + shake, 0.6 * std::sin(0.00617 * k), 1.3 + r - 0.0002 * k + 0.15 * std::sin(0.07 * k)};
    ASSERT_TRUE(twins.step_both(input_at(at, k % 90 < 78 ? CutButton::pressed : CutButton::up))) << "milling, tick " << k;
  }
  ASSERT_TRUE(along(at, {0.0, 0.0, 1.6}, 60));
  for (int k = 0; k < 700; ++k) {
    const double a = 0.06 * k, out = 0.9 + 0.3 * std::sin(0.013 * k);
    ASSERT_TRUE(twins.step_both(input_at({out * std::cos(a), out * std::sin(a), 1.2 + 0.3 * std::sin(0.031 * k)}))) << "exploring, tick " << k;
  }
  EXPECT_TRUE(twins.same_state());
}

INSTANTIATE_TEST_SUITE_P(Burs, WhatIsKept,
                         testing::Values(Shape{"ball", 0.8, std::nullopt}, Shape{"inverted_cone", 0.5, flat_head(0.5, 0.35, 1.0)},
                                         Shape{"pear", 0.4, pear_head(0.4, 0.4, 0.25, 1.8)}),
                         [](const auto& p) { return p.param.name; });

}  // namespace
}  // namespace cusp::test
