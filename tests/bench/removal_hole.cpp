// Holes that balls of the catalogue, with their own necks, widen in circles while they go down: their mouths touch the necks.
#include <algorithm>
#include <cmath>

#include "scenarios/burs/bur_catalogue.h"
#include "tests/bench/motions.h"
#include "tests/bench/pin.h"
#include "tests/bench/removal.h"
#include "tests/bench/tick_times.h"
#include "tests/engine/volume/carved.h"

namespace cusp::bench {

namespace {

constexpr double kHalfMm = 2.5, kThickMm = 3.6;        // the block, its face at z = 0
constexpr double kDownMmS = 0.5, kLowestMm = 0.9;     // of the device under where the ball touches
constexpr double kWearMmS = 4.0;                       // at 1 N/mm: as the built-in exercises' plastic
constexpr std::int64_t kTicks = 4000;

}  // namespace

std::shared_ptr<Scene> hole_scene(const Bur& bur) {
  constexpr int kPadding = 4;
  const double v = kPaperVoxelMm;
  const int wide = static_cast<int>(std::ceil(2.0 * kHalfMm / v)) + 2 * kPadding, high = static_cast<int>(std::ceil(kThickMm / v)) + 2 * kPadding;
  const Grid grid{IVec3(wide, wide, high), v, {-0.5 * (wide - 1) * v, -0.5 * (wide - 1) * v, -kThickMm - (kPadding - 0.5) * v}};
  const auto block = [](Vec3 p) { return std::max({std::fabs(p.x) - kHalfMm, std::fabs(p.y) - kHalfMm, p.z, -kThickMm - p.z}); };
  auto scene = std::make_shared<Scene>();
  scene->method = Method::surface;
  scene->specimen = carved::specimen(grid, Reading::banded, block, [](Vec3) { return Tissue::plastic; });
  scene->burs = {bur};
  for (TissueFeel& feel : scene->tissues) feel = {1.0, kWearMmS};
  scene->full_force_n = kFullForceN;
  scene->guard = unguarded();
  return scene;
}

void add_holes(std::vector<Row>& rows) {
  std::vector<double> radii;
  for (const CatalogueBur& entry : bur_catalogue()) {
    const double r = entry.bur.radius_mm;
    if (!entry.bur.head.ball() || std::find(radii.begin(), radii.end(), r) != radii.end()) continue;
    radii.push_back(r);
    const auto scene = hole_scene(entry.bur);
    Row row;
    row.method = key_of(Method::surface);
    row.measure = "hole";
    row.bur = entry.shape + ' ' + entry.bur.name;
    row.direction = "spiral";
    row.bur_radius_mm = r;
    row.voxel_mm = kPaperVoxelMm;
    row.tick_ms = 1.0;
    row.runs = row.samples = row.infeasible_ticks = 0;
    TickTimes times;
    std::int64_t deferred = 0, longest = 0;
    for (const double circle_mm : {0.3, 0.6})
      for (const double per_s : {1.0, 2.0, 4.0}) {
        StepState state(scene);
        std::int64_t run = 0;
        for (std::int64_t k = 0; k < kTicks; ++k) {
          const double t = 1e-3 * static_cast<double>(k), over = r + std::max(0.1 - kDownMmS * t, -kLowestMm);
          const Vec3 device(circle_mm * std::sin(per_s * t), circle_mm * (1.0 - std::cos(per_s * t)), over);
          const double before = core_time_s();
          const StepOutput out = step(state, input_at(device, Button::down));
          times.add_ns(static_cast<std::int64_t>(1e9 * (core_time_s() - before)));
          run = out.deferred ? run + 1 : 0;
          longest = std::max(longest, run);
          deferred += out.deferred;
          row.infeasible_ticks += out.infeasible;
        }
        ++row.runs;
        row.samples += kTicks;
      }
    times.fill(row);
    row.tick_us_mean = 1e6 / row.updates_per_s;
    row.deferred_percent = 100.0 * static_cast<double>(deferred) / static_cast<double>(row.samples);
    row.stuck_ms = static_cast<double>(longest);
    rows.push_back(std::move(row));
  }
}

}  // namespace cusp::bench
