// Drilling for the clock, and what it changes.
#include <algorithm>
#include <array>
#include <map>

#include "tests/bench/frame.h"
#include "tests/bench/motions.h"
#include "tests/bench/rate.h"

namespace cusp::bench {

namespace {

constexpr double kFullForceN = 0.25;  // at K = 1 N/mm: full wear from 0.25 mm of spring on
constexpr double kLeadMm = 0.3;       // of the device point before the bur: always full wear
constexpr double kCoverMm = 0.3;      // over the ball when the clock starts, more than the band
constexpr double kLeadStepMm = 0.05;  // a tick, on the way there
constexpr int kSettleTicks = 100;

std::shared_ptr<const Scene> drilling_scene(Method method, const Shape& face, double voxel_mm) {
  auto scene = scene_of(face, method, voxel_mm);
  scene->full_force_n = kFullForceN;
  for (TissueFeel& feel : scene->tissues) feel = {1.0, kAdvanceMmS};
  return scene;
}

/// Is the surface s = 1/2 (or the stairs of a filled reading) in this cell?
bool crossed(const Volume& volume, IVec3 cell) {
  const bool first = volume.occupied(cell);
  for (int i = 1; i < 8; ++i)
    if (volume.occupied(cell + IVec3(i & 1, i >> 1 & 1, i >> 2)) != first) return true;
  return false;
}

}  // namespace

Perforation::Perforation(Method method, const Shape& face, double voxel_mm, std::uint64_t seed)
    : state_(drilling_scene(method, face, voxel_mm)) {
  Random random(seed);
  const Spot spot = face.spot(random);
  const double r = face.bur_radius_mm();
  inwards_ = -spot.normal;
  start_ = spot.centre + inwards_ * (2.0 * r + kCoverMm);
  // The way there is cut at once; the bur goes in, begins to cut, and settles.
  cut_along(state_, 0, spot.centre - inwards_ * (2.0 * r), start_);
  lead(state_, step, face.home(), kLeadStepMm);
  lead(state_, step, spot.centre - inwards_ * (2.0 * r), kLeadStepMm);
  lead(state_, step, start_ + inwards_ * kLeadMm, kLeadStepMm);
  for (int k = 0; k < kSettleTicks; ++k) step(state_, next());
  tick_ = 0;
  start_ += inwards_ * (kAdvanceMmS * 1e-3 * kSettleTicks);
}

StepInput Perforation::next() {
  ++tick_;
  return input_at(start_ + inwards_ * (kLeadMm + kAdvanceMmS * 1e-3 * tick_), true);
}

Changes changes_a_tick(Method method, const Shape& face, double voxel_mm, int ticks) {
  Perforation run(method, face, voxel_mm, 1);
  const Volume& volume = run.state().volume();
  const Specimen& specimen = volume.specimen();
  const bool filled = specimen.reading() == Reading::filled;
  // [brick]: its values and, for each of its cells, whether the surface was there.
  struct Before {
    std::array<std::uint16_t, kBrickVoxels> s{};
    std::array<bool, kBrickVoxels> crossed{};
  };
  std::map<int, Before> before;
  const auto value_of = [&](int brick, int o) { return std::min(specimen.s_in(brick, o), volume.cut_in(brick, o)); };
  const auto remember = [&](int brick) {
    Before& b = before[brick];
    const IVec3 corner = specimen.brick_at(brick) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; ++o) {
      b.s[static_cast<std::size_t>(o)] = value_of(brick, o);
      b.crossed[static_cast<std::size_t>(o)] = crossed(volume, corner + IVec3(o & 7, o >> 3 & 7, o >> 6));
    }
  };
  // Every brick that the bur can reach in these ticks, so that a value's first change is seen as one.
  for (int b = 0; b < specimen.brick_count().x * specimen.brick_count().y * specimen.brick_count().z; ++b)
    if (volume.cuttable(b)) remember(b);

  std::int64_t voxels = 0, cells = 0;
  for (int k = 0; k < ticks; ++k) {
    step(run.state(), run.next());
    std::map<int, std::array<bool, kBrickVoxels>> moved;  // [brick]: voxels that changed what a cell sees
    for (const std::int32_t brick : volume.cut_bricks()) {
      Before& b = before[brick];
      for (int o = 0; o < kBrickVoxels; ++o) {
        const std::uint16_t s = value_of(brick, o);
        const std::uint16_t was = b.s[static_cast<std::size_t>(o)];
        if (s == was) continue;
        ++voxels;
        if (!filled || (s == 0) != (was == 0)) moved[brick][static_cast<std::size_t>(o)] = true;
        b.s[static_cast<std::size_t>(o)] = s;
      }
    }
    std::map<int, std::array<bool, kBrickVoxels>> seen;
    for (const auto& [brick, flags] : moved) {
      const IVec3 corner = specimen.brick_at(brick) * kBrickEdge;
      for (int o = 0; o < kBrickVoxels; ++o) {
        if (!flags[static_cast<std::size_t>(o)]) continue;
        for (int i = 0; i < 8; ++i) {
          const IVec3 cell = corner + IVec3(o & 7, o >> 3 & 7, o >> 6) - IVec3(i & 1, i >> 1 & 1, i >> 2);
          const int n = specimen.brick_index({cell.x >> 3, cell.y >> 3, cell.z >> 3});
          if (n < 0) continue;
          const auto at = static_cast<std::size_t>(brick_offset(cell.x & 7, cell.y & 7, cell.z & 7));
          if (seen[n][at]) continue;
          seen[n][at] = true;
          const bool now = crossed(volume, cell);
          bool& was = before[n].crossed[at];
          if (now || was) ++cells;
          was = now;
        }
      }
    }
  }
  return {static_cast<double>(voxels) / ticks, static_cast<double>(cells) / ticks};
}

}  // namespace cusp::bench
