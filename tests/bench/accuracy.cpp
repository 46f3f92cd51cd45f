#include "tests/bench/accuracy.h"

#include <iostream>

#include "tests/bench/channel.h"
#include "tests/bench/measure.h"
#include "tests/bench/names.h"

namespace cusp::bench {

namespace {

constexpr double kVoxel = 10.0 / 128;  // 128^3 in 10 mm
constexpr int kHoles = 30;             // of a channel: ten upright, twenty oblique; sixteen more across a slot

/// A voxel size and bur at which a shape is measured.
struct Size {
  double voxel_mm;
  double bur_radius_mm;
};

std::vector<Size> sizes_of(std::string_view shape, const Options& options) {
  std::vector<Size> out;
  if (!options.voxels_mm.empty() || !options.bur_radii_mm.empty()) {
    for (const double voxel : chosen(options.voxels_mm, {kVoxel}))
      for (const double radius : chosen(options.bur_radii_mm, {0.25, 0.5})) out.push_back({voxel, radius});
    return out;
  }
  out = {{kVoxel, 0.25}, {kVoxel, 0.5}};
  const bool plain = shape == "face" || shape == "sphere";
  if (plain) out.insert(out.end(), {{kVoxel, 1.15}, {kVoxel, 3.0}});
  // One bur for the order of the error: at 0.2 mm the small one is hardly more than a voxel.
  if (plain || shape == "cylinder") out.insert(out.end(), {{0.2, 0.5}, {0.1, 0.5}, {0.04, 0.5}});
  return out;
}

void shape_accuracy_rows(const Options& options, const Shape& shape, Measure what, std::vector<Row>& rows) {
  for (const Method method : kMethods) {
    if (!asked(options.methods, key_of(method))) continue;
    what.method = method;
    if (asked(options.motions, "press")) rows.push_back(measure_presses(shape, what));
    if (!asked(options.motions, "slide")) continue;
    for (const double speed : chosen(options.speeds_mm_s, {5.0, 50.0, 200.0})) {
      what.speed_mm_s = speed;
      rows.push_back(measure_slide(shape, what));
    }
  }
}

void channel_accuracy_rows(const Options& options, const Size& size, Measure what, std::vector<Row>& rows) {
  if (!asked(options.motions, "slide")) return;
  for (const HoleKind kind : {HoleKind::straight, HoleKind::oblique, HoleKind::slot}) {
    const int count = kind == HoleKind::straight ? kHoles / 3 : kind == HoleKind::oblique ? 2 * kHoles / 3 : 16;
    const auto holes = unambiguous_holes(size.bur_radius_mm, kind, options.seed, count);
    for (const Method method : kMethods) {
      if (!asked(options.methods, key_of(method))) continue;
      what.method = method;
      for (const double speed : chosen(options.speeds_mm_s, {5.0, 50.0, 200.0})) {
        what.speed_mm_s = speed;
        rows.push_back(measure_channel(holes, what));
      }
    }
  }
}

}  // namespace

std::vector<Row> accuracy_rows(const Options& options) {
  std::vector<Row> rows;
  Measure what = measure_of(options);
  for (const std::string_view name : kShapeNames) {
    if (!asked(options.shapes, name)) continue;
    for (const Size& size : sizes_of(name, options)) {
      what.voxel_mm = size.voxel_mm;
      if (name == "channel") {
        channel_accuracy_rows(options, size, what, rows);
        continue;
      }
      const std::vector<std::string_view> variants =
          name == "cut" ? std::vector<std::string_view>{"single", "crossing", "drilled"} : std::vector<std::string_view>{""};
      for (const std::string_view variant : variants)
        shape_accuracy_rows(options, *make_shape(name, size.bur_radius_mm, variant), what, rows);
    }
  }
  return rows;
}

int run_accuracy(const Options& options) {
  Report report = empty_report();
  report.rows = accuracy_rows(options);
  return write_report(report, options.json, [](const std::vector<Row>& rows) { print_table(rows, std::cout); });
}

}  // namespace cusp::bench
