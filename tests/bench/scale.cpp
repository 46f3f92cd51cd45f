#include "tests/bench/scale.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "tests/bench/frame.h"
#include "tests/bench/lanes.h"
#include "tests/bench/motions.h"
#include "tests/bench/names.h"
#include "tests/bench/pin.h"
#include "tests/bench/rate.h"

namespace cusp::bench {

namespace {

constexpr int kEdges[] = {128, 256, 512, 1024};
constexpr double kBurMm = 0.5;
constexpr double kSameWayMm = 4.0;
constexpr double kFromEdgeMm = 1.0;         // of the block, so that the bur stays on its top
constexpr std::size_t kScaleTrackTicks = 16384;  // 0.8 m

double box_distance(Vec3 p, double half) {
  const Vec3 q = glm::abs(p) - half;
  return length(glm::max(q, Vec3(0.0))) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

std::shared_ptr<const Scene> block_scene(int edge, Method method, double voxel_mm, double radius_mm) {
  auto scene = std::make_shared<Scene>();
  scene->method = method;
  scene->specimen = solid_block(edge, voxel_mm, reading_of(method));
  scene->burs = {Bur{"bench", radius_mm, 0.4 * radius_mm, 4.0 + radius_mm, 0.4 * radius_mm, 4.0}};
  for (TissueFeel& feel : scene->tissues) feel = {1.0, 1.0};
  scene->guard.jump_mm = 1e6;
  return scene;
}

void print_scale(const std::vector<Row>& rows) {
  fmt::print("{:<16}{:<11}{:>14}{:>12}{:>9}{:>9}{:>11}{:>11}\n", "method", "variant", "voxels", "updates/s", "p50 us",
             "p99", "cost/128^3", "memory MB");
  for (const Row& r : rows)
    fmt::print("{:<16}{:<11}{:>14}{:>12.0f}{:>9.2f}{:>9.2f}{:>11.3f}{:>11.1f}\n", r.method, r.variant, r.volume_voxels,
               r.updates_per_s, r.tick_us_p50, r.tick_us_p99, r.cost_to_smallest, r.memory_mb);
}

}  // namespace

double solid_block_half_mm(int edge_voxels, double voxel_mm) {
  return (0.5 * edge_voxels - 4.0 - kBandVoxels) * voxel_mm;
}

std::shared_ptr<const Specimen> solid_block(int edge_voxels, double voxel_mm, Reading reading) {
  const Grid grid{IVec3(edge_voxels), voxel_mm, Vec3(-(edge_voxels - 1) * voxel_mm / 2.0)};
  const double half = solid_block_half_mm(edge_voxels, voxel_mm);
  const double band = kBandVoxels * voxel_mm;
  return Specimen::build(grid, reading, [&](IVec3 brick, BrickVoxels& voxels) -> std::optional<Tissue> {
    const Vec3 a = grid.centre_mm(brick * kBrickEdge);
    const Vec3 b = grid.centre_mm(brick * kBrickEdge + (kBrickEdge - 1));
    // The distance rises with each |coordinate|: the brick's furthest and nearest places bound it.
    const Vec3 far = glm::max(glm::abs(a), glm::abs(b));
    Vec3 near = glm::min(glm::abs(a), glm::abs(b));
    for (int i = 0; i < 3; ++i)
      if (a[i] * b[i] < 0.0) near[i] = 0.0;
    if (box_distance(far, half) <= -band) return Tissue::dentine;
    if (box_distance(near, half) >= band) return Tissue::empty;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const Vec3 p = grid.centre_mm(brick * kBrickEdge + IVec3(o & 7, o >> 3 & 7, o >> 6));
      const auto at = static_cast<std::size_t>(o);
      voxels.s[at] = solid_from_distance(box_distance(p, half) / voxel_mm);
      voxels.tissue[at] = Tissue::dentine;
    }
    return std::nullopt;
  });
}

std::vector<StepInput> block_inputs(const BlockSlide& slide, std::uint64_t seed, std::size_t ticks) {
  const double z = slide.top_mm + slide.bur_radius_mm - kDepthMm, reach = slide.half_way_mm;
  Random random(seed);
  const auto place = [&] {
    const double x = random.between(-reach, reach);
    return Vec3(x, random.between(-reach, reach), z);
  };
  Vec3 from = place(), to = place();
  double done = 0.0;
  std::vector<StepInput> out;
  while (out.size() < ticks) {
    const double whole = length(to - from);
    if (done > whole) {
      done -= whole;
      from = to;
      to = place();
      continue;
    }
    out.push_back(input_at(from + (to - from) * (done / whole)));
    done += slide.speed_mm_s * kTickUs * 1e-6;
  }
  return out;
}

std::vector<Row> scale_rows(const Options& options) {
  std::vector<Row> rows;
  for (const double voxel : chosen(options.voxels_mm, {kRateVoxelMm}))
    for (const double radius : chosen(options.bur_radii_mm, {kBurMm}))
      for (const Method method : {Method::surface, Method::occupancy}) {
        if (!asked(options.methods, key_of(method))) continue;
        std::vector<StepState> states;
        std::vector<double> memory_mb;
        for (const int edge : kEdges) {
          const double before = resident_mb().value_or(kAbsent);
          states.emplace_back(block_scene(edge, method, voxel, radius));
          memory_mb.push_back(resident_mb().value_or(kAbsent) - before);
        }
        for (const double speed : chosen(options.speeds_mm_s, {kRateSpeedMmS}))
          for (const bool same : {true, false}) {
            std::vector<Lane> lanes;
            for (std::size_t i = 0; i < states.size(); ++i) {
              const double top = solid_block_half_mm(kEdges[i], voxel);
              const double half_way = same ? kSameWayMm : top - kFromEdgeMm;
              Track track(block_inputs({top, radius, half_way, speed}, options.seed, kScaleTrackTicks));
              // From above, down to the first point.
              const Vec3 first = track.next().position_mm();
              lead(states[i], step, {first.x, first.y, top + 2.0 * radius + 1.0}, 1.0);
              lead(states[i], step, first, speed * 1e-3);
              lanes.push_back({std::move(states[i]), std::move(track), {}});
            }
            run_lanes(lanes, options.budget_s);
            for (std::size_t i = 0; i < lanes.size(); ++i) {
              Row& row = rows.emplace_back();
              row.method = key_of(method);
              row.shape = "block";
              row.variant = same ? "same-way" : "whole-top";
              row.motion = "slide";
              row.task = "exploration";
              row.speed_mm_s = speed;
              row.bur_radius_mm = radius;
              row.voxel_mm = voxel;
              row.seed = static_cast<std::int64_t>(options.seed);
              lanes[i].pace.fill(row);
              row.volume_voxels = std::int64_t{kEdges[i]} * kEdges[i] * kEdges[i];
              row.memory_mb = memory_mb[i];
              row.cost_to_smallest = 1.0 / ratio_of(lanes[i].pace, lanes[0].pace);
            }
            for (std::size_t i = 0; i < lanes.size(); ++i) states[i] = std::move(lanes[i].state);
          }
      }
  return rows;
}

int run_scale(const Options& options) {
  if (!pin_to_core()) std::cerr << "cusp-bench: this thread could not be kept on one core\n";
  Report report = empty_report();
  report.rows = scale_rows(options);
  return write_report(report, options.json, print_scale);
}

}  // namespace cusp::bench
