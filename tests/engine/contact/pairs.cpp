// SurfaceContact::fits computes planes of faces and edges two at a time, push_out one at a time: they agree to the last
// rounding. fits reports whether any plane is met; push_out moves a pose that is deeper in a plane than its tolerance.
// Along a line the two thresholds are one tolerance apart.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "engine/contact/surface_contact.h"
#include "engine/removal/carve.h"
#include "tests/engine/step/scenes.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using test::length;

constexpr double kVoxelMm = 0.1, kRadiusMm = 0.3;
constexpr double kToleranceMm = 1e-7;  // kTolerance of surface_contact.cpp, which push_out leaves alone
constexpr double kSameMm = 4e-12;
constexpr Vec3 kUp(0.0, 0.0, 1.0);

/// Numbers in [-1, 1), the same on every machine.
struct Numbers {
  std::uint64_t seed;
  double operator()() {
    seed = seed * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(seed >> 33) / 1073741824.0 - 1.0;
  }
};

struct Bench {
  explicit Bench(const std::function<double(Vec3)>& distance_mm)
      : scene(test::scene_of(test::from_distance(5.0, kVoxelMm, distance_mm), Method::surface, kRadiusMm)) {
    // A slim neck touches only what the ball touches, because push_out() reads the head alone.
    scene->burs[0].neck_radius_mm = 0.01;
    scene->burs[0].shank_radius_mm = 0.02;
    volume = std::make_unique<Volume>(scene->specimen);
    surface = std::make_unique<SurfaceContact>(*scene, *volume, memory, sweeps);
  }
  const Bur& bur() const { return scene->burs[0]; }
  /// By pairs: no plane is met.
  bool free_by_pairs(Vec3 pose) { return surface->fits(*volume, bur(), kUp, pose); }
  /// One by one: no plane is met by more than the tolerance.
  bool free_one_by_one(Vec3 pose, double thin_mm) {
    Vec3 out(1e9);
    return surface->push_out(*volume, *scene, 0, kUp, pose, thin_mm, out) && out == pose;
  }

  std::shared_ptr<Scene> scene;
  CutMemory memory;
  Sweeps sweeps{Vec3(0.0), 0};
  std::unique_ptr<Volume> volume;
  std::unique_ptr<SurfaceContact> surface;
};

/// Where on from + s along, low (in) to high (out), `free` begins to hold.
template <class Free>
double begins(Vec3 from, Vec3 along, double low, double high, double close, Free&& free) {
  while (high - low > close) {
    const double middle = 0.5 * (low + high);
    (free(from + along * middle) ? high : low) = middle;
  }
  return high;
}

struct Seen {
  int places = 0, same = 0;
  std::vector<Vec3> touched;  // of the ball
};

/// Lowers the bur at random places until it meets a plane, and compares there.
Seen compare(Bench& bench, double half_mm, double top_mm, double thin_mm) {
  Numbers random{17};
  Seen seen;
  while (seen.places < 400) {
    const double y = half_mm * random(), x = half_mm * random();
    const Vec3 above(x, y, top_mm);
    const double down = begins(above, kUp, -1.5, 0.0, 1e-9, [&](Vec3 p) { return bench.free_by_pairs(p); });
    const Vec3 met = above + kUp * down;
    Vec3 out;
    if (!bench.surface->push_out(*bench.volume, *bench.scene, 0, kUp, met - kUp * 1e-6, thin_mm, out)) continue;
    const Vec3 way = out - (met - kUp * 1e-6);
    if (length(way) < 1e-9) continue;
    const Vec3 n = way / length(way);
    const double pairs = begins(met, n, -1e-5, 1e-5, 1e-15, [&](Vec3 p) { return bench.free_by_pairs(p); });
    const double one = begins(met, n, -1e-5, 1e-5, 1e-15, [&](Vec3 p) { return bench.free_one_by_one(p, thin_mm); });
    ++seen.places;
    // Measured: 1.9e-12 at most, but for one place in 800 where a plane ends just there.
    seen.same += std::fabs(pairs - one - kToleranceMm) < kSameMm ? 1 : 0;
    EXPECT_LE(std::fabs(pairs - one), 2.0 * kToleranceMm) << seen.places;
    seen.touched.push_back(met - n * (kRadiusMm - thin_mm));
  }
  return seen;
}

TEST(Pairs, of_faces_are_the_planes_of_single_faces) {
  // Hills and hollows of 0.6 mm: planes and tangents, of points on both sides.
  Bench bench([](Vec3 p) { return p.z - 0.3 * std::sin(2.1 * p.x + 0.3) * std::cos(1.7 * p.y - 0.2 * p.x); });
  const Seen seen = compare(bench, 1.8, 1.2, 0.0);
  EXPECT_GE(seen.same, seen.places * 99 / 100);
}

TEST(Pairs, of_edges_are_the_planes_of_single_edges) {
  // A roof with a sharp ridge, askew in the grid.
  const auto from_ridge = [](Vec3 p) { return (p.x + 0.3 * p.y) / std::sqrt(1.09); };
  Bench bench([&](Vec3 p) { return (p.z + std::fabs(from_ridge(p))) * std::sqrt(0.5); });
  const Seen seen = compare(bench, 0.25, 1.2, 0.0);
  EXPECT_GE(seen.same, seen.places * 99 / 100);
  int ridges = 0;
  for (const Vec3 p : seen.touched) ridges += std::fabs(from_ridge(p)) < 5e-3 ? 1 : 0;
  EXPECT_GE(ridges, seen.places / 4);
}

}  // namespace
}  // namespace cusp::test
