// Several targets of one exercise: each is measured on its own cavity, as if it were alone.

#include "scenarios/metrics/several_targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "scenarios/format/keys.h"
#include "scenarios/metrics/evidence_patch.h"
#include "scenarios/metrics/live.h"
#include "scenarios/metrics/measure.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/box_exercise.h"

namespace cusp::test {
namespace {

constexpr double kVoxelMm = 0.1;

struct Cavity {
  double x_mm;  // of its middle
  Vec3 size_mm; // along x, along y, depth
};
const Cavity kShallow{-3.0, {2.0, 2.0, 1.0}}, kDeep{3.0, {2.4, 1.6, 2.0}};

/// Half a block of plastic below z = 0.
std::shared_ptr<const Specimen> block(Reading reading = Reading::banded) {
  Grid grid;
  grid.size = {128, 64, 56};
  grid.voxel_mm = kVoxelMm;
  grid.origin_mm = {-6.35, -3.15, -4.45};
  return engine::carved::specimen(
      grid, reading,
      [](Vec3 p) {
        const Vec3 off = glm::abs(p - Vec3(0, 0, -2)) - Vec3(5.8, 2.6, 2.0);
        return std::max({off.x, off.y, off.z});
      },
      [](Vec3) { return Tissue::plastic; });
}

void cut(Volume& volume, const Cavity& one) {
  engine::carved::carve(volume, [&one](Vec3 p) {
    return std::max({std::fabs(p.x - one.x_mm) - 0.5 * one.size_mm.x, std::fabs(p.y) - 0.5 * one.size_mm.y, -one.size_mm.z - p.z});
  });
}

Region target(const Cavity& one, const std::string& name) {
  Region out = box_exercise_on_36(one.size_mm, {Tissue::plastic}).target;
  out.outline.paths = {{Vec3(one.x_mm, 0, -one.size_mm.z)}};
  out.outline.corner_radius_mm = 0;
  out.name = name;
  return out;
}

/// `keys`: of each target, and of the whole.
Scenario exercise(const Cavity& first, const Cavity& second, const std::vector<std::string>& keys) {
  Scenario s = box_exercise_on_36(first.size_mm, {Tissue::plastic});
  s.specimen.generator = "block";
  s.leeway = {0.3, 0.3};
  s.target = {};
  s.target.kind = RegionKind::joined;
  s.target.parts = {target(first, "shallow"), target(second, "deep")};
  for (const std::string& key : keys) {
    s.rubric.criteria.push_back({key, 1, {}});
    for (const Region* one : named_targets(s.target)) s.rubric.criteria.push_back({metric_key(key, one->name), 1, {}});
  }
  return s;
}

std::vector<std::string> every_cavity_key() {
  std::vector<std::string> out;
  for (const MetricKey& key : kMetricKeys)
    if (is_of_cavity(key.key)) out.emplace_back(key.key);
  return out;
}

const Measure* find(const std::vector<Measure>& all, const std::string& key) {
  const auto it = std::ranges::find(all, key, &Measure::metric);
  return it == all.end() ? nullptr : &*it;
}
double value(const std::vector<Measure>& all, const std::string& key) {
  const Measure* m = find(all, key);
  EXPECT_TRUE(m != nullptr && m->measured) << key;
  return m != nullptr ? m->value : std::nan("");
}

TEST(SeveralTargets, EachMeasuresTheSameBitsAsIfItWereAlone) {
  for (const Reading reading : {Reading::banded, Reading::filled}) {
    const auto specimen = block(reading);
    const Cavity shallow{kShallow.x_mm, kShallow.size_mm + Vec3(0.1, 0.0, 0.2)}, deep{kDeep.x_mm, kDeep.size_mm - Vec3(0.0, 0.2, 0.1)};
    Volume both(specimen), first(specimen), second(specimen);
    cut(both, deep);
    cut(both, shallow);
    cut(first, shallow);
    cut(second, deep);
    const Scenario s = exercise(kShallow, kDeep, every_cavity_key());
    const std::vector<Measure> all = measure(Reference(s, specimen), both, {});
    for (const auto& [part, volume] : {std::pair(0, &first), std::pair(1, &second)}) {
      Scenario alone = s;
      alone.target = s.target.parts[static_cast<std::size_t>(part)];
      std::erase_if(alone.rubric.criteria, [](const Criterion& c) { return !split_metric(c.metric).target.empty(); });
      int compared = 0;
      for (const Measure& expected : measure(Reference(alone, specimen), *volume, {})) {
        const Measure* own = find(all, metric_key(expected.metric, alone.target.name));
        if (!metric_from_key(expected.metric) || !is_of_cavity(expected.metric) || expected.metric.starts_with("removed_")) {
          EXPECT_EQ(own, nullptr) << expected.metric;
          continue;
        }
        ASSERT_NE(own, nullptr) << expected.metric;
        EXPECT_EQ(own->measured, expected.measured) << own->metric;
        EXPECT_EQ(own->value, expected.value) << own->metric;
        EXPECT_EQ(own->uncertainty, expected.uncertainty) << own->metric;
        EXPECT_EQ(own->where_mm, expected.where_mm) << own->metric;
        compared += own->measured;
      }
      EXPECT_GE(compared, reading == Reading::banded ? 20 : 10);
    }
  }
}

constexpr double kLiveOff = 0.01;  // LiveReading: the panel shows whole percents

TEST(SeveralTargets, LiveScoresShowWhatIsRemovedOfEachAsItIsMeasured) {
  for (const Reading reading : {Reading::banded, Reading::filled}) {
    const auto specimen = block(reading);
    const auto reference = std::make_shared<const Reference>(exercise(kShallow, kDeep, {"target_removed"}), specimen);
    LiveMetrics live(reference);
    EXPECT_EQ(live.reading().removed_of, (std::array<double, LiveReading::kMostTargets>{}));
    Volume volume(specimen);
    const auto look = [&] {
      const auto bricks = volume.cut_bricks();
      live.update(volume, std::vector<std::int32_t>(bricks.begin(), bricks.end()));
      const std::vector<Measure> all = measure(*reference, volume, {});
      EXPECT_NEAR(live.reading().removed_of[0], value(all, "target_removed@shallow"), kLiveOff);
      EXPECT_NEAR(live.reading().removed_of[1], value(all, "target_removed@deep"), kLiveOff);
    };
    cut(volume, {kDeep.x_mm - 0.3, kDeep.size_mm - Vec3(0, 0, 0.5)});
    look();
    EXPECT_EQ(live.reading().removed_of[0], 0.0);
    EXPECT_GT(live.reading().removed_of[1], 50.0);
    cut(volume, {kShallow.x_mm + 0.4, kShallow.size_mm});
    look();
    EXPECT_GT(live.reading().removed_of[0], 50.0);
  }
}

TEST(SeveralTargets, ADepthIsTakenFromTheTargetsOwnPlaneToItsOwnFloor) {
  const auto specimen = block();
  Volume volume(specimen);
  cut(volume, kShallow);
  cut(volume, {kDeep.x_mm, kDeep.size_mm + Vec3(0, 0, 0.25)});
  const std::vector<Measure> all = measure(Reference(exercise(kShallow, kDeep, {"depth_mean", "depth_most"}), specimen), volume, {});
  EXPECT_NEAR(value(all, "depth_mean@shallow"), 1.0, 0.01);
  EXPECT_NEAR(value(all, "depth_most@shallow"), 1.0, 0.02);
  EXPECT_NEAR(value(all, "depth_mean@deep"), 2.25, 0.01);
}

TEST(SeveralTargets, OverCutBelongsToTheNearerTargetAndToOneAlone) {
  const auto specimen = block();
  Volume volume(specimen);
  // From the shallow target 2.5 mm towards the deep one: 0.6 mm beyond the middle between both.
  cut(volume, {-0.55, {6.9, 1.0, 0.8}});
  const std::vector<Measure> all =
      measure(Reference(exercise(kShallow, kDeep, {"overcut_beyond_side", "overcut_leeway_side", "target_removed"}), specimen), volume, {});
  const auto over = [&](const std::string& name) {
    return value(all, metric_key("overcut_beyond_side", name)) + value(all, metric_key("overcut_leeway_side", name));
  };
  const double height = 1.0 * 0.8, middle = 0.5 * (-2.0 + 1.8);
  EXPECT_NEAR(over("shallow"), (middle + 2.0) * height, 0.06 * height) << "half a voxel where both cavities meet";
  EXPECT_NEAR(over("deep"), (1.8 - middle) * height, 0.06 * height);
  EXPECT_NEAR(over("shallow") + over("deep"), over(""), 0.12 * height);
}

TEST(SeveralTargets, TissueThatTwoTargetsShareCountsForBoth) {
  const auto specimen = block();
  const Cavity left{-0.5, {3.0, 2.0, 1.0}}, right{0.5, {3.0, 1.0, 1.8}};
  Volume volume(specimen);
  cut(volume, left);
  cut(volume, right);
  const std::vector<Measure> all = measure(Reference(exercise(left, right, {"target_removed"}), specimen), volume, {});
  EXPECT_NEAR(value(all, "target_removed@shallow"), 100.0, 0.5);
  EXPECT_NEAR(value(all, "target_removed@deep"), 100.0, 0.5);
}

TEST(SeveralTargets, OneThatNobodyCutIsNotMeasuredWhereTheOtherIs) {
  const auto specimen = block();
  Volume volume(specimen);
  cut(volume, kShallow);
  const std::vector<Measure> all = measure(Reference(exercise(kShallow, kDeep, {"target_removed", "depth_mean"}), specimen), volume, {});
  EXPECT_NEAR(value(all, "target_removed@shallow"), 100.0, 0.5);
  EXPECT_EQ(value(all, "target_removed@deep"), 0.0);
  EXPECT_FALSE(find(all, "depth_mean@deep")->measured);
}

TEST(SeveralTargets, ProgressRisesOverTheWholeAndEachTargetOnTheCallingThread) {
  const auto specimen = block();
  Volume volume(specimen);
  cut(volume, kShallow);
  cut(volume, kDeep);
  std::vector<double> shares;
  const auto caller = std::this_thread::get_id();
  const std::vector<Measure> all = measure(Reference(exercise(kShallow, kDeep, {"depth_mean"}), specimen), volume, {}, [&](double share) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    shares.push_back(share);
  });
  EXPECT_FALSE(all.empty());
  ASSERT_GE(shares.size(), 3u);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_GT(shares.front(), 0.0);
  EXPECT_GT(shares.back(), 2.0 / 3.0);
  EXPECT_LT(shares.back(), 1.0);
}

TEST(SeveralTargets, ANameThatTheExerciseDoesNotHaveIsNotMeasured) {
  const auto specimen = block();
  Scenario s = exercise(kShallow, kDeep, {});
  s.rubric.criteria = {{"depth_mean@other", 1, {}}, {"depth_mean@deep", 1, {}}};
  const std::vector<Measure> all = measure(Reference(s, specimen), Volume(specimen), {});
  EXPECT_EQ(find(all, "depth_mean@other"), nullptr);
  ASSERT_NE(find(all, "depth_mean@deep"), nullptr);
}

TEST(SeveralTargets, APatchLiesInItsOwnCavity) {
  const auto specimen = block();
  auto volume = std::make_shared<Volume>(specimen);
  cut(*volume, kShallow);
  cut(*volume, kDeep);
  const EvidencePatches patches(std::make_shared<const Reference>(exercise(kShallow, kDeep, {"depth_mean"}), specimen), volume);
  for (const auto& [name, cavity] : {std::pair("shallow", kShallow), std::pair("deep", kDeep)}) {
    const EvidencePatch patch = patches.of(metric_key("depth_mean", name));
    double mm2 = 0;
    for (const auto& t : patch.triangles) {
      mm2 += 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
      for (const Vec3& p : t) EXPECT_LT(std::fabs(p.x - cavity.x_mm), 0.5 * cavity.size_mm.x + 0.05) << name;
    }
    EXPECT_NEAR(mm2, cavity.size_mm.x * cavity.size_mm.y, 0.15 * cavity.size_mm.x * cavity.size_mm.y) << name;
  }
  EXPECT_TRUE(patches.of("depth_mean@other").empty());
}

}  // namespace
}  // namespace cusp::test
