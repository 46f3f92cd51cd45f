#include "tests/bench/removal.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>

#include "engine/tool/swept.h"
#include "tests/bench/frame.h"
#include "tests/bench/pin.h"
#include "tests/bench/program.h"
#include "tests/bench/removal_paths.h"
#include "tests/modules.h"

namespace cusp::bench {

namespace {

std::string_view tissue_name(Tissue tissue) {
  for (std::size_t i = 0; i < kRemovalMaterials.size(); ++i)
    if (kRemovalMaterials[i].tissue == tissue) return kRemovalTissues[i];
  return "";
}

/// Under three voxels of radius the field does not resolve the bowl.
bool unresolved(const Cutter& cutter, double voxel_mm) { return cutter.bur.radius_mm < 3.0 * voxel_mm; }

Row speed_row(std::string_view measure, const DrillRun& run) {
  Row row;
  row.method = key_of(run.method);
  row.measure = measure;
  row.bur = run.cutter.name;
  row.bur_radius_mm = run.cutter.bur.radius_mm;
  row.voxel_mm = run.voxel_mm;
  row.tick_ms = run.tick_ms;
  row.alpha = run.alpha;
  row.target_mm_s = run.target_mm_s;
  row.unresolved = unresolved(run.cutter, run.voxel_mm);
  for (const Direction& d : directions())
    if (length(d.unit - run.direction) < 1e-9) row.direction = d.name;
  return row;
}

void fill_speed(Row& row, const DrillSpeed& speed) {
  row.target_mm_s = speed.target_mm_s;
  row.deepest_mm_s = speed.by_deepest_mm_s;
  row.volume_mm_s = speed.by_volume_mm_s;
  row.samples = speed.ticks;
  // The worse of both readings; an unresolved bur has only the deepest one.
  row.measured_mm_s = speed.by_deepest_mm_s;
  if (!row.unresolved && !std::isnan(speed.by_volume_mm_s) &&
      std::fabs(speed.by_volume_mm_s - row.target_mm_s) > std::fabs(speed.by_deepest_mm_s - row.target_mm_s))
    row.measured_mm_s = speed.by_volume_mm_s;
  row.error_percent = 100.0 * (row.measured_mm_s / row.target_mm_s - 1.0);
}

void add_speeds(const Options& options, Method method, std::vector<Row>& rows) {
  for (const DrillRun& run : speed_runs(options, method)) {
    Row& row = rows.emplace_back(speed_row("speed", run));
    row.tissue = tissue_name(run.tissue(Vec3(0.0)));
    fill_speed(row, drill(run));
  }
}

/// The seam contains the feed direction and divides the bur in halves, to a part of a voxel. The target is the harmonic
/// mean over the voxels ahead of the front.
void add_mixed(const Options& options, Method method, std::vector<Row>& rows) {
  const RemovalTissue &soft = kRemovalMaterials[0], &hard = kRemovalMaterials[2];
  for (const Direction& d : directions())
    for (int turn = 0; turn < 3; ++turn) {
      if (!asked(options.directions, d.name)) continue;
      DrillRun run = run_in(method, round_cutter(1.0), kPaperVoxelMm, soft, 1.0);
      run.direction = d.unit;
      const Vec3 u = across(run.direction), w = glm::cross(run.direction, u);
      constexpr double kTurn[3][2] = {{1.0, 0.0}, {0.8, 0.6}, {0.28, -0.96}};
      const Vec3 normal = u * kTurn[turn][0] + w * kTurn[turn][1];
      run.tissue = [normal, above = soft.tissue, below = hard.tissue](Vec3 p) { return glm::dot(p, normal) > 0.0 ? above : below; };
      run.target_mm_s = front_of_voxels_mm_s(run);
      Row& row = rows.emplace_back(speed_row("mixed", run));
      row.tissue = fmt::format("{} and {}", tissue_name(soft.tissue), tissue_name(hard.tissue));
      row.variant = fmt::format("seam {}", turn + 1);
      fill_speed(row, drill(run));
    }
}

Row path_row(std::string_view measure, const Cutter& cutter, double voxel_mm, Path path) {
  Row row;
  row.method = key_of(Method::surface);
  row.measure = measure;
  row.bur = cutter.name;
  row.bur_radius_mm = cutter.bur.radius_mm;
  row.voxel_mm = voxel_mm;
  row.direction = key_of(path);
  row.tick_ms = 1.0;
  row.unresolved = unresolved(cutter, voxel_mm);
  return row;
}

/// One stroke along a known path: remaining surface and removed volume.
Row stroke_row(std::string_view measure, const Cutter& cutter, double voxel_mm, Path path, double speed_mm_s) {
  Row row = path_row(measure, cutter, voxel_mm, path);
  row.speed_mm_s = speed_mm_s;
  const std::vector<Vec3> points = points_of(path, cutter, {.speed_mm_s = speed_mm_s});
  const RemainingSurface left = lead_along(cutter, voxel_mm, path, points, 1.0, 1);
  row.removed_mm3 = left.removed_mm3;
  if (measure == "shape") {
    row.deviation_um_mean = left.mean_um;
    row.deviation_um_max = left.most_um;
    row.place = fmt::format("{:.2f} {:.2f} {:.2f}", left.worst_mm.x, left.worst_mm.y, left.worst_mm.z);
    row.samples = left.points;
    row.skipped = left.edges;
  } else {
    row.exact_mm3 = exact_removed_mm3(cutter, path, points);
    row.error_percent = 100.0 * (row.removed_mm3 / row.exact_mm3 - 1.0);
  }
  return row;
}

/// A row for each cutter. A cutter with the head and neck of an earlier one copies its figures.
template <class RowOf>
void each_head(BurSet burs, std::vector<Row>& rows, RowOf&& row_of_head) {
  const std::vector<Cutter> cutters = shape_cutters(burs);
  for (std::size_t i = 0; i < cutters.size(); ++i) {
    std::size_t first = 0;
    const auto alike = [](const Bur& a, const Bur& b) {
      return a.head == b.head && a.radius_mm == b.radius_mm && a.neck_radius_mm == b.neck_radius_mm &&
             a.neck_length_mm == b.neck_length_mm;
    };
    while (!alike(cutters[first].bur, cutters[i].bur)) ++first;
    if (first == i) {
      for (Row& row : row_of_head(cutters[i])) rows.push_back(std::move(row));
      continue;
    }
    const std::size_t so_far = rows.size();
    for (std::size_t k = 0; k < so_far; ++k) {
      if (rows[k].bur != cutters[first].name) continue;
      Row same = rows[k];
      same.bur = cutters[i].name;
      rows.push_back(std::move(same));
    }
  }
}

void add_shapes(const Options& options, std::vector<Row>& out) {
  std::vector<Row> rows;
  for (const double voxel : chosen(options.voxels_mm, {kPaperVoxelMm}))
    each_head(options.full ? BurSet::whole_catalogue : BurSet::one_per_shape, rows, [&](const Cutter& cutter) {
      std::vector<Row> own;
      for (const Path path : {Path::straight, Path::curved, Path::tilted})
        for (const double speed : chosen(options.speeds_mm_s, {1.0, 50.0, 200.0}))
          own.push_back(stroke_row("shape", cutter, voxel, path, speed));
      return own;
    });
  std::ranges::move(rows, std::back_inserter(out));
}

/// Upright strokes by closed forms, the others by the exact profile's swept volume.
void add_volumes(const Options& options, std::vector<Row>& out) {
  std::vector<Row> rows;
  for (const double voxel : chosen(options.voxels_mm, {kPaperVoxelMm}))
    each_head(options.full ? BurSet::whole_catalogue : BurSet::one_per_shape, rows, [&](const Cutter& cutter) {
      std::vector<Row> own;
      for (const Path path : {Path::drilled, Path::sideways, Path::straight, Path::curved, Path::tilted})
        for (const double speed : chosen(options.speeds_mm_s, {50.0}))
          own.push_back(stroke_row("volume", cutter, voxel, path, speed));
      return own;
    });
  std::ranges::move(rows, std::back_inserter(out));
}

void add_orders(std::vector<Row>& rows) {
  const Cutter cutter = round_cutter(1.0);
  constexpr double kSpeed = 25.0, kCornerMm = 0.1;
  for (const Path path : {Path::straight, Path::curved}) {
    double whole = 0.0;
    struct Stroke {
      double tick_ms;
      int parts;
    };
    for (const Stroke stroke : {Stroke{1.0, 1}, Stroke{1.0, 2}, Stroke{0.25, 1}, Stroke{4.0, 1}}) {
      Row& row = rows.emplace_back(path_row("order", cutter, kPaperVoxelMm, path));
      row.tick_ms = stroke.tick_ms;
      row.speed_mm_s = kSpeed;
      row.variant = stroke.parts == 1 ? "whole" : "halves";
      row.removed_mm3 = lead_along(cutter, kPaperVoxelMm, path,
                                   points_of(path, cutter, {kSpeed, stroke.tick_ms, kCornerMm}), stroke.tick_ms,
                                   stroke.parts)
                            .removed_mm3;
      if (whole == 0.0) whole = row.removed_mm3;
      row.error_percent = 100.0 * (row.removed_mm3 / whole - 1.0);
    }
  }
}

void add_slides(std::uint64_t seed, std::vector<Row>& rows) {
  for (const Cutter& cutter : removal_cutters()) {
    if (cutter.feed == Feed::sideways || !cutter.bur.head.ball()) continue;  // the exact excess is known for a ball
    Row& row = rows.emplace_back(path_row("slide", cutter, kPaperVoxelMm, Path::curved));
    row.direction = "circle";
    row.speed_mm_s = 50.0;
    row.seed = static_cast<std::int64_t>(seed);
    const SlideExcess excess = slide_cutting(cutter, kPaperVoxelMm, {.speed_mm_s = 50.0}, seed);
    row.excess_um_p99 = excess.p99_um;
    row.excess_um_max = excess.most_um;
    row.samples = excess.ticks;
  }
}

void add_ridges(std::vector<Row>& rows) {
  for (const double speed : {50.0, 10.0})
    for (const Cutter& cutter : ridge_cutters()) {
      const RidgeError kept = ridge_between(cutter, kPaperVoxelMm, speed);
      for (const bool after : {false, true}) {
        Row& row = rows.emplace_back(path_row("ridge", cutter, kPaperVoxelMm, Path::straight));
        row.speed_mm_s = speed;
        row.variant = after ? "after 40 passes" : "between two cuts";
        row.ridge_um = after ? kept.after_um : kept.felt_um;
      }
    }
}

void add_costs(const Options& options, Method method, std::vector<Row>& rows) {
  const Cutter cutter = round_cutter(kLargestBurMm);
  Row& row = rows.emplace_back(path_row("tick", cutter, kPaperVoxelMm, Path::straight));
  row.method = key_of(method);
  row.direction.clear();
  row.alpha = 1.0;
  const CutCost cost = cost_of_cutting(cutter, method, kPaperVoxelMm, options.budget_s);
  row.tick_us_p50 = cost.p50_us;
  row.tick_us_p99 = cost.p99_us;
  row.tick_us_max = cost.most_us;
  row.samples = cost.ticks;
}

void print_removal(const std::vector<Row>& rows) {
  const auto number = [](double v, int digits) { return std::isnan(v) ? std::string("-") : fmt::format("{:.{}f}", v, digits); };
  fmt::print("{:<10} {:<8} {:<11} {:<20} {:>6} {:>6} {:<10} {:>6} {:>8} {:>8} {:>8} {:>9} {:>9} {:>9} {:>9}\n", "method",
             "measure", "bur", "tissue", "voxel", "ms", "direction", "alpha", "target", "mm/s", "%", "um", "um max",
             "us p50", "us p99");
  for (const Row& row : rows) {
    const double um = !std::isnan(row.deviation_um_mean) ? row.deviation_um_mean
                      : !std::isnan(row.excess_um_p99)   ? row.excess_um_p99
                                                         : row.ridge_um;
    const double most = !std::isnan(row.deviation_um_max) ? row.deviation_um_max : row.excess_um_max;
    fmt::print("{:<10} {:<8} {:<11} {:<20} {:>6} {:>6} {:<10} {:>6} {:>8} {:>8} {:>8} {:>9} {:>9} {:>9} {:>9}{}\n",
               row.method, row.measure, row.bur, row.tissue.empty() ? row.variant : row.tissue, number(row.voxel_mm, 3),
               number(row.tick_ms, 2), row.direction, number(row.alpha, 2), number(row.target_mm_s, 3),
               number(row.measured_mm_s, 4), number(row.error_percent, 3),
               number(um, 3), number(most, 2), number(row.tick_us_p50, 1), number(row.tick_us_p99, 1),
               row.unresolved ? "  unresolved" : "");
  }
}

}  // namespace

std::vector<Row> removal_rows(const Options& options) {
  std::vector<Row> rows;
  const auto wants = [&options](std::string_view measure) { return asked(options.measures, measure); };
  std::vector<std::string> methods = options.methods;
  if (methods.empty()) methods = {std::string(key_of(Method::surface)), std::string(key_of(Method::occupancy))};
  const bool surface = asked(methods, key_of(Method::surface));
  for (const Method method : {Method::surface, Method::penalty, Method::gradient, Method::occupancy, Method::occupancy_pivot, Method::ray}) {
    if (!asked(methods, key_of(method))) continue;
    const bool banded = reading_of(method) == Reading::banded;
    if (wants("speed")) add_speeds(options, method, rows);
    if (wants("depth") && !options.full && (method == Method::surface || method == Method::occupancy)) add_depths(method, rows);
    if (wants("mixed") && banded && !options.full) add_mixed(options, method, rows);
    if (wants("tick") && !options.full) add_costs(options, method, rows);
  }
  if (surface && wants("shape")) add_shapes(options, rows);
  if (surface && wants("volume")) add_volumes(options, rows);
  if (options.full) {
    for (Row& row : rows) row.sweep = kFullSweep;
    return rows;
  }
  if (!surface) return rows;
  if (wants("order")) add_orders(rows);
  if (wants("slide")) add_slides(options.seed, rows);
  if (wants("ridge")) add_ridges(rows);
  if (wants("hole")) add_holes(rows);
  return rows;
}

int run_removal(const Options& options) {
  if ((asked(options.measures, "tick") || asked(options.measures, "hole")) && !pin_to_core()) std::cerr << "cusp-bench: this thread could not be kept on one core\n";
  Report report = empty_report();
  report.rows = removal_rows(options);
  return write_report(report, options.json, print_removal);
}

}  // namespace cusp::bench
