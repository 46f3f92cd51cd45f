// Every contact method under random ticks in a scene of 64^3 voxels: walks, slides, rushes, presses and teleports of
// the device, cuts, swaps of bur, samples that are late, lost or no number. After each tick: every force finite,
// within the limit, zero while the guard is latched; nothing removed has come back; nothing that was reserved ran out.
// With every phenomenon on, random pedal and coolant, each of two handpieces runs half as many; 20,000 with CUSP_FULL=1.
//
// 40,000 ticks of each method, 20,000 with sanitizers; with CUSP_FULL=1 ten million of the surface proxy and a million of each other.
// Every 20,000 ticks begin anew, with their own seed: a failure prints it, and CUSP_RANDOM_SEED=N runs it alone.
// Shards, and how to resume them: README.md.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "engine_sources.h"
#include "tests/engine/random/random_shards.h"
#include "tests/engine/step/scenes.h"
#include "tests/full_run.h"
#include "tests/random.h"

namespace cusp::test {
namespace {

constexpr int kVoxels = 64;
constexpr double kVoxelMm = 0.1;

/// Tooth-like: dentine under enamel with a bay, a slot narrower than any bur, and a wall of two voxels.
double tooth(Vec3 p) {
  double d = length(p / Vec3(1.0, 0.8, 0.9)) - 2.3;
  d = std::max(d, 0.6 - length(p - Vec3(1.2, 0.0, 1.8)));
  d = std::max(d, 0.1 - std::abs(p.x + 0.9));
  return std::min(d, box_distance(p - Vec3(0.0, 1.9, 1.5), Vec3(1.5, 0.1, 1.0)));
}
/// Tissue up to the edge of the volume, on all sides but one.
double slab(Vec3 p) { return p.z - 0.7 + 0.3 * std::abs(p.x) - 0.2 * std::abs(p.y); }

std::shared_ptr<Scene> scene_for(Method method, double (*shape)(Vec3)) {
  VoxelVolume volume(Grid{IVec3(kVoxels), kVoxelMm, Vec3(-0.5 * (kVoxels - 1) * kVoxelMm)});
  IVec3 v;
  for (v.z = 0; v.z < kVoxels; ++v.z)
    for (v.y = 0; v.y < kVoxels; ++v.y)
      for (v.x = 0; v.x < kVoxels; ++v.x) {
        const Vec3 p = volume.grid.centre_mm(v);
        const std::size_t i = volume.grid.index(v);
        volume.s[i] = solid_from_distance(shape(p) / kVoxelMm);
        if (volume.s[i] > 0) volume.tissue[i] = p.z > 0.4 ? Tissue::enamel : Tissue::dentine;
      }
  auto scene = scene_of(volume, method, 0.4);
  scene->burs.push_back(Bur{"small", 0.25, 0.2, 1.0, 0.8, 6.0});
  scene->burs.push_back(Bur{"large", 0.6, 0.3, 2.0, 0.8, 6.0});
  scene->tissues[index_of(Tissue::enamel)] = {2.0, 4.0};
  scene->tissues[index_of(Tissue::dentine)] = {1.0, 12.0};
  scene->full_force_n = 1.5;
  scene->friction = true;
  scene->guard = GuardSettings{};
  scene->guard.ramp_in_ms = 20.0;
  return scene;
}

/// Random samples of a device.
class RandomInputs {
 public:
  explicit RandomInputs(std::uint64_t seed) : random_(seed) { place_ = anywhere(); }

  /// before: output of the last tick.
  StepInput next(const StepOutput& before) {
    if (--left_ <= 0) choose();
    const Vec3 wobble = any();
    switch (way_) {
      case Way::walk:
        place_ += wobble * 0.03;
        break;
      case Way::move:
        place_ += velocity_ * 1e-3 + wobble * 0.002;
        break;
      case Way::hold:
        place_ += (aim_ - place_) * 0.05;
        break;
    }
    for (int i = 0; i < 3; ++i)
      if (!(std::abs(place_[i]) < kReachMm)) {
        place_[i] = place_[i] > 0 ? kReachMm : -kReachMm;
        velocity_[i] = -velocity_[i];
      }
    if (one_in(1500)) place_ = anywhere();
    if (one_in(700)) place_ += wobble * 2.5;
    if (one_in(300)) cut_ = !cut_;
    if (one_in(500)) bur_ = static_cast<std::uint16_t>(random_.bits() % 3);

    Sample sample;
    sample.status = one_in(2500) ? Sample::Status::gone : one_in(150) ? Sample::Status::late : Sample::Status::fresh;
    sample.position_mm = place_;
    sample.buttons = cut_ ? StepInput::kCut : std::uint16_t{0};
    sample.bur = one_in(3000) ? std::uint16_t{65535} : bur_;
    if (one_in(3000)) sample.position_mm.y = std::numeric_limits<double>::quiet_NaN();
    if (one_in(3000)) sample.position_mm.x = -std::numeric_limits<double>::infinity();
    if (one_in(3000)) sample.position_mm.z = 1e7 * unit();
    const auto elapsed = one_in(400)      ? static_cast<std::uint32_t>(random_.between(1.0, 70'000.0))
                         : one_in(20'000) ? std::numeric_limits<std::uint32_t>::max()
                                          : std::uint32_t{1000};
    StepInput input = quantise(sample, elapsed, last_);
    last_ = input;
    last_.buttons = 0;
    if (before.faulted ? one_in(20) : one_in(5000)) input.buttons |= StepInput::kRearm;
    return input;
  }

 private:
  enum class Way { walk, move, hold };
  static constexpr double kReachMm = 4.2;  // the volume's edge lies at 3.2
  double unit() { return random_.between(-1.0, 1.0); }
  bool one_in(std::uint64_t n) { return random_.bits() % n == 0; }
  /// In braces: x, y, z in this order, so that a seed names the same ticks whatever the compiler.
  Vec3 any() { return Vec3{unit(), unit(), unit()}; }
  Vec3 anywhere() { return any() * kReachMm; }
  void choose() {
    left_ = 1 + static_cast<int>(random_.bits() % 400);
    way_ = static_cast<Way>(random_.bits() % 3);
    aim_ = anywhere() * 0.8;
    // 1 to 1000 mm/s, slow ones as often as fast ones.
    const double speed = std::sqrt(std::sqrt(random_.between(1.0, 1e12)));
    const Vec3 direction = any();
    velocity_ = direction * (speed / (length(direction) + 1e-9));
  }

  Random random_;
  StepInput last_;
  Vec3 place_{0.0}, velocity_{0.0}, aim_{0.0};
  Way way_ = Way::walk;
  int left_ = 0;
  bool cut_ = false;
  std::uint16_t bur_ = 0;
};

/// Keeps every cut brick and compares those with a new revision. A worn voxel changes the revision when it vanishes, so
/// all bricks of a filled reading are compared every 64 ticks.
class RemovalWatch {
 public:
  explicit RemovalWatch(const Volume& volume) : wears_(volume.specimen().reading() == Reading::filled) {
    seen_.reserve(volume.cut_capacity());
  }

  enum class Bricks : std::uint8_t { changed, every };

  /// True if no voxel holds more than before.
  bool only_removed(const Volume& volume, Bricks compared) {
    const bool every_brick = compared == Bricks::every || (wears_ && ++looks_ % 64 == 0);
    const auto bricks = volume.cut_bricks();
    for (std::size_t i = 0; i < bricks.size(); ++i) {
      const std::uint32_t revision = volume.revision(bricks[i]);
      if (i == seen_.size()) {
        seen_.push_back({});
        seen_[i].s.assign(kBrickVoxels, kSolid);
      }
      if (seen_[i].revision == revision && !every_brick) continue;
      const std::uint16_t* now = volume.cut_of(bricks[i]);
      for (std::size_t v = 0; v < kBrickVoxels; ++v) {
        if (now[v] > seen_[i].s[v]) return false;
        // Changed under the same revision.
        if (!wears_ && seen_[i].revision == revision && now[v] != seen_[i].s[v]) return false;
        seen_[i].s[v] = now[v];
      }
      seen_[i].revision = revision;
    }
    return true;
  }

 private:
  struct Seen {
    std::uint32_t revision = 0;
    std::vector<std::uint16_t> s;
  };
  std::vector<Seen> seen_;
  bool wears_;
  std::uint64_t looks_ = 0;
};

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Random pedal, from up to down, and coolant now and then.
class RandomPedal {
 public:
  explicit RandomPedal(std::uint64_t seed) : random_(seed + 77) {}
  void press(StepInput& input) {
    if (random_.bits() % 300 == 0) pedal_ = random_.bits() % 3 == 0 ? 0 : static_cast<std::uint16_t>(random_.bits());
    if (random_.bits() % 2000 == 0) coolant_ = !coolant_;
    input.pedal = pedal_;
    if (coolant_) input.buttons |= StepInput::kCoolant;
  }

 private:
  Random random_;
  std::uint16_t pedal_ = 0;
  bool coolant_ = false;
};

void run_seed(const std::shared_ptr<const Scene>& scene, std::uint64_t seed, int ticks, Counts& counts) {
  StepState state(scene);
  RemovalWatch watch(state.volume());
  RandomInputs inputs(seed);
  RandomPedal pedal(seed);
  const double limit = scene->guard.limit_n * (1.0 + 1e-12);
  for (int k = 0; k < ticks; ++k) {
    StepInput input = inputs.next(state.last());
    if (scene->phenomena.any()) pedal.press(input);
    const StepOutput out = step(state, input);
    const auto where = [&] {
      return testing::Message() << "CUSP_RANDOM_SEED=" << seed << ", tick " << k << ", device " << input.x << ' '
                                << input.y << ' ' << input.z << " (0.1 um)";
    };
    ASSERT_TRUE(finite(out.force_n) && finite(out.force_raw_n) && finite(out.proxy_mm)) << where();
    ASSERT_LE(length(out.force_n), limit) << where();
    ASSERT_TRUE(!out.faulted || out.force_n == Vec3(0.0)) << where();
    ASSERT_FALSE(out.overflow) << where();
    const auto compared = k == ticks - 1 ? RemovalWatch::Bricks::every : RemovalWatch::Bricks::changed;
    ASSERT_TRUE(watch.only_removed(state.volume(), compared)) << where();
    counts.contacts += out.contact ? 1 : 0;
    counts.faults += out.faulted ? 1 : 0;
    counts.cutting += out.cutting ? 1 : 0;
    counts.infeasible += out.infeasible ? 1 : 0;
    counts.deferred += out.deferred ? 1 : 0;
    counts.stalled += out.has(PhenomenonSign::stalled) ? 1 : 0;
    counts.overheated += out.has(PhenomenonSign::overheated) ? 1 : 0;
    const bool sane = out.spindle_rpm >= 0.0f && out.spindle_rpm <= 400e3f && out.heat_k >= 0.0f && out.heat_k <= 1000.0f;
    ASSERT_TRUE(sane) << where();
  }
  counts.ticks += static_cast<std::uint64_t>(ticks);
  counts.cut_bricks += state.volume().cut_bricks().size();
}

#ifdef CUSP_SANITIZED
constexpr std::uint64_t kTicksByDefault = 20'000;
#else
constexpr std::uint64_t kTicksByDefault = 40'000;
#endif

class RandomTicks : public testing::TestWithParam<Method> {};

TEST_P(RandomTicks, forces_stay_finite_and_limited_and_removal_only_removes) {
  const bool full = full_run();
  const char* one = std::getenv("CUSP_RANDOM_SEED");
  const char* shard = std::getenv("CUSP_RANDOM_SHARD");
  const char* folder = std::getenv("CUSP_RANDOM_DONE");
  const std::uint64_t ticks = !full ? kTicksByDefault : GetParam() == Method::surface ? 10'000'000 : 1'000'000;
  Seeds seeds{1, ticks / kTicksOfASeed};
  if (one != nullptr) seeds.first = seeds.last = std::strtoull(one, nullptr, 10);
  if (shard != nullptr) {
    const auto asked = shard_of(seeds, shard);
    ASSERT_TRUE(asked) << "CUSP_RANDOM_SHARD=" << shard << " is no shard: 3/8 is the third of eight";
    seeds = *asked;
  }
  Done done(folder == nullptr ? "" : folder, key_of(GetParam()),
            "engine version " + std::to_string(kEngineVersion) + ", sources " + kEngineSources);
  ASSERT_EQ(done.other_engine(), "") << "CUSP_RANDOM_DONE=" << folder << " is of another engine: name another folder";
  const std::shared_ptr<const Scene> scenes[2] = {scene_for(GetParam(), tooth), scene_for(GetParam(), slab)};
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    if (done.has(seed)) continue;
    Counts own;
    run_seed(scenes[seed % 2], seed, kTicksOfASeed, own);
    if (HasFatalFailure()) return;
    done.add(seed, own);
  }
  if (seeds.count() == 0) return;  // more shards than seeds
  const Counts counts = done.sum(seeds);
  EXPECT_EQ(counts.ticks, seeds.count() * kTicksOfASeed);
  std::cout << key_of(GetParam()) << ", seeds " << seeds.first << " to " << seeds.last << ": " << counts.ticks << " ticks, " << counts.contacts << " in contact, "
            << counts.cutting << " cutting, " << counts.faults << " faulted, " << counts.infeasible << " infeasible, "
            << counts.deferred << " deferred, " << counts.cut_bricks << " bricks cut" << std::endl;
  // Inputs without contact, cuts and faults would prove nothing.
  EXPECT_GT(counts.contacts, counts.ticks / 10);
  EXPECT_GT(counts.cutting, counts.ticks / 100);
  EXPECT_GT(counts.faults, counts.ticks / 100);
}

TEST_P(RandomTicks, with_every_phenomenon_on_forces_stay_finite_and_limited) {
  Counts counts;
  std::uint64_t seed = 101;
  for (const Handpiece handpiece : {Handpiece::turbine, Handpiece::slow}) {
    const auto scene = scene_for(GetParam(), tooth);
    scene->phenomena = {handpiece, true, true};
    scene->tool_axis = Vec3(0.6, 0.0, 0.8);
    run_seed(scene, seed++, full_run() ? kTicksOfASeed : static_cast<int>(kTicksByDefault / 2), counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.cutting, counts.ticks / 200);
  EXPECT_TRUE(counts.stalled > 0 || GetParam() == Method::penalty);  // whose push ends at the depth of its shell
}

TEST(ShankInTissue, has_room_for_all_that_is_about_it) {
  constexpr std::uint64_t kSeed = 98;  // at tick 12,661 more than 7,743 cells lie about its shank
  Counts counts;
  run_seed(scene_for(Method::surface, tooth), kSeed, 13'000, counts);
}

INSTANTIATE_TEST_SUITE_P(Methods, RandomTicks,
                         testing::Values(Method::surface, Method::occupancy, Method::occupancy_pivot, Method::ray,
                                         Method::penalty, Method::gradient),
                         [](const auto& p) {
                           std::string name(key_of(p.param));
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace cusp::test
