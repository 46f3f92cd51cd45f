#include "tests/bench/removal_drill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/tool/heads.h"
#include "engine/tool/swept.h"
#include "engine/volume/cell_field.h"
#include "engine/volume/cut_volume.h"
#include "tests/bench/frame.h"
#include "tests/bench/motions.h"
#include "tests/bench/rows.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"

namespace cusp::bench {

namespace {

constexpr double kStandOffMm = 0.2;      // mm from bur to face at the start
constexpr double kApproachMm = 0.02;     // a tick
constexpr double kDrillPaddingVoxels = 4.0;   // empty voxels on every side
constexpr double kAroundVoxels = 4.0;    // tissue around the reach of the bur, plus kAroundMm
constexpr double kAroundMm = 0.2;
constexpr double kSideShare = 0.9;       // of the radius: deepest sideways stroke, with the neck outside
constexpr int kLeastLayers = 10;         // shortest stroke of a method on voxels

/// From the pivot to the furthest point of the head towards `direction`.
double furthest(const Bur& bur, Vec3 axis, Vec3 direction) {
  if (bur.head.ball()) return bur.radius_mm;
  const double t = glm::dot(direction, axis);
  const Vec3 off = direction - axis * t;
  const OnHalf d{t, std::sqrt(glm::dot(off, off))};
  const OnHalf p = bur.head.support(d, {0.0, 0.0});
  return p.t * d.t + p.rho * d.rho;
}

Vec3 axis_of(const DrillRun& run) { return run.cutter.feed == Feed::sideways ? across(run.direction) : -run.direction; }

/// Distance to half a ball of tissue about the origin, behind the face with the inward normal `in`.
double half_ball(Vec3 p, Vec3 in, double radius) {
  return std::max(-glm::dot(p, in), length(p) - radius);
}

/// Zero of the cut's field on the line from `from` along `in`, within `reach`; kAbsent if there is none.
double surface_on_line(const Volume& volume, Vec3 from, Vec3 in, double reach) {
  const Grid& grid = volume.grid();
  const auto depth = [&](double s) {  // positive in the cut, mm
    const Vec3 x = (from + in * s - grid.origin_mm) / grid.voxel_mm;
    const IVec3 cell{static_cast<int>(std::floor(x.x)), static_cast<int>(std::floor(x.y)),
                     static_cast<int>(std::floor(x.z))};
    CellField field;
    field.load(volume, Field::cut, cell);
    Vec3 g;
    return -field.eval(x - Vec3(cell), g);
  };
  double in_cut = -reach, in_tissue = reach;
  if (!(depth(in_cut) < 0.0) || !(depth(in_tissue) > 0.0)) return kAbsent;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (in_cut + in_tissue);
    (depth(middle) < 0.0 ? in_cut : in_tissue) = middle;
  }
  return 0.5 * (in_cut + in_tissue);
}

/// Distance along the bur's line, from `from` on, to the first solid voxel.
double voxels_on_line(const Volume& volume, double from, Vec3 in) {
  const Grid& grid = volume.grid();
  const double part = 0.02 * grid.voxel_mm;
  for (double s = from;; s += part) {
    const Vec3 x = (in * s - grid.origin_mm) / grid.voxel_mm + 0.5;
    const IVec3 v{static_cast<int>(std::floor(x.x)), static_cast<int>(std::floor(x.y)),
                  static_cast<int>(std::floor(x.z))};
    if (!grid.contains(v) || volume.occupied(v)) return s;
  }
}

/// Depth at which the exact bur has removed mm3.
double depth_of(const Cutter& cutter, double mm3, double about) {
  double low = 0.5 * about, high = 1.5 * about;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (closed_form_mm3(cutter, middle) < mm3 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Removed volume and deepest point of the surface.
struct Remaining {
  double mm3 = 0.0;
  double deepest_mm = 0.0;
};
Remaining remaining_after(const StepState& state, Vec3 device, Vec3 in, double about) {
  // A copy takes the button-up tick, which carves the pending sweep and ends the stroke.
  const std::vector<std::byte> bytes = state.save();
  std::optional<StepState> copy = StepState::restore(std::make_shared<Scene>(state.scene()), bytes);
  step(*copy, input_at(device, Button::up));
  return {removed_solid(copy->volume()).total_mm3(),
          about + surface_on_line(copy->volume(), in * about, in, 1.5 * state.volume().grid().voxel_mm)};
}

}  // namespace

Cutter round_cutter(double diameter_mm) {
  Cutter out;
  std::string digits = std::to_string(diameter_mm);
  out.name = "round " + digits.substr(0, digits.find('.') + 2);
  out.bur.name = out.name;
  out.bur.radius_mm = 0.5 * diameter_mm;
  out.bur.neck_radius_mm = 0.4 * out.bur.radius_mm;
  out.bur.neck_length_mm = 4.0 + out.bur.radius_mm;
  out.bur.shank_radius_mm = out.bur.neck_radius_mm;
  out.bur.shank_length_mm = 4.0;
  return out;
}

Cutter fissure_cutter(double diameter_mm, Feed feed) {
  Cutter out = round_cutter(diameter_mm);
  const double r = out.bur.radius_mm;
  out.name = "fissure" + out.name.substr(out.name.find(' ')) + (feed == Feed::sideways ? " side" : " end");
  out.bur.name = out.name;
  out.bur.head = flat_head(r, r, kFissureMm).value_or(Profile{});
  // A thin neck stays outside while the flank enters.
  if (feed == Feed::sideways) out.bur.neck_radius_mm = out.bur.shank_radius_mm = kThinNeckMm;
  out.feed = feed;
  out.flank_mm = kFissureMm;
  return out;
}

std::shared_ptr<Scene> drill_scene(const DrillRun& run) {
  const double stroke = run.stroke_mm;
  const double reach = head_reach(run.cutter.bur);
  const double around = std::sqrt(reach * reach + stroke * stroke) + kAroundVoxels * run.voxel_mm + kAroundMm;
  const Vec3 in = run.direction;
  const int n = 2 * static_cast<int>(std::ceil(around / run.voxel_mm + kBandVoxels + kDrillPaddingVoxels)) + 1;
  // The origin lies parts of a voxel off the grid planes.
  const Grid grid{IVec3(n), run.voxel_mm, Vec3(-0.5 * (n - 1) * run.voxel_mm) + Vec3(0.137, -0.211, 0.173) * run.voxel_mm};
  auto scene = std::make_shared<Scene>();
  scene->method = run.method;
  scene->specimen = carved::specimen(
      grid, reading_of(run.method), [&](Vec3 p) { return half_ball(p, in, around); }, run.tissue);
  scene->burs = {run.cutter.bur};
  scene->tool_axis = axis_of(run);
  for (std::size_t t = 0; t < kTissueCodes; ++t) scene->tissues[t] = {1.0, run.speed_mm_s[t]};
  scene->full_force_n = kFullForceN;
  scene->friction = false;
  scene->guard = unguarded();
  return scene;
}

double closed_form_mm3(const Cutter& cutter, double depth_mm) {
  const double r = cutter.bur.radius_mm, h = depth_mm;
  if (cutter.flank_mm == 0.0) return h < r ? std::numbers::pi * h * h * (r - h / 3.0) : std::numbers::pi * r * r * (2.0 / 3.0 * r + (h - r));
  if (cutter.feed == Feed::tip_first) return std::numbers::pi * r * r * h;
  return cutter.flank_mm * (r * r * std::acos(1.0 - h / r) - (r - h) * std::sqrt(h * (2.0 * r - h)));
}

double front_of_voxels_mm_s(const DrillRun& run) {
  const auto scene = drill_scene(run);
  const Specimen& specimen = *scene->specimen;
  const Grid& grid = specimen.grid();
  const Vec3 in = run.direction, u = across(in), w = glm::cross(in, u);
  const double r = run.cutter.bur.radius_mm;
  // Seen along the feed, the front is a disc whose parts all move equally far.
  constexpr int kAcross = 200, kPlaces = 50;
  double way_mm = 0.0, time_s = 0.0;
  for (int k = 0; k < kPlaces; ++k) {
    const double depth = run.stroke_mm * (kRunIn + (1.0 - kRunIn) * (k + 0.5) / kPlaces);
    double parts = 0.0, slowness = 0.0;
    for (int i = 0; i < kAcross * kAcross; ++i) {
      const double x = (2.0 * (i % kAcross) + 1.0) / kAcross - 1.0, y = (2.0 * (i / kAcross) + 1.0) / kAcross - 1.0;
      const double left = 1.0 - x * x - y * y;
      if (left <= 0.0) continue;
      const double ahead = depth - r + r * std::sqrt(left);
      if (ahead < 0.0) continue;  // before the face
      const IVec3 v(glm::floor((u * (r * x) + w * (r * y) + in * ahead - grid.origin_mm) / grid.voxel_mm + 0.5));
      parts += 1.0;
      slowness += 1.0 / run.speed_mm_s[index_of(specimen.tissue(v))];
    }
    way_mm += 1.0;
    time_s += slowness / parts;
  }
  return way_mm / time_s;
}

namespace {

/// The run with its stroke as the method and the feed allow it.
DrillRun with_stroke(DrillRun run) {
  if (reading_of(run.method) == Reading::filled) run.stroke_mm = std::max(run.stroke_mm, kLeastLayers * run.voxel_mm);
  if (run.cutter.feed == Feed::sideways) run.stroke_mm = std::min(run.stroke_mm, kSideShare * run.cutter.bur.radius_mm);
  return run;
}

/// One drilling: the state, the feed direction and the bur's foremost point.
class Drilling {
 public:
  explicit Drilling(const DrillRun& run)
      : run_(run),
        front_(furthest(run.cutter.bur, axis_of(run), run.direction)),
        lead_mm_(run.alpha * kFullForceN),
        state_(drill_scene(run)) {}

  /// Moves the device point to the face and lead_mm_ behind it, with the button up.
  void approach() {
    double s = -front_ - kStandOffMm;
    tick(s, Button::up);
    while (s < -front_ + lead_mm_) {
      s = std::min(s + kApproachMm, -front_ + lead_mm_);
      tick(s, Button::up);
    }
  }
  /// Holds the device point lead_mm_ ahead of the bur for a tick.
  void cut() { tick(glm::dot(out_.proxy_mm, run_.direction) + lead_mm_, Button::down); }
  /// Depth of the bur's foremost point behind the face.
  double depth_mm() const { return glm::dot(out_.proxy_mm, run_.direction) + front_; }
  Remaining remaining() const { return remaining_after(state_, out_.proxy_mm, run_.direction, depth_mm()); }
  const Volume& volume() const { return state_.volume(); }

 private:
  void tick(double s, Button button) {
    StepInput input = input_at(run_.direction * s, button);
    input.elapsed_us = static_cast<std::uint32_t>(run_.tick_ms * 1000.0 + 0.5);
    out_ = step(state_, input);
  }

  const DrillRun& run_;
  double front_;    // mm from the pivot to the foremost point
  double lead_mm_;  // spring length that gives the run's wear coefficient
  StepState state_;
  StepOutput out_;
};

/// Whether a stride belongs to the measured part of the stroke.
enum class Counting : std::uint8_t { no, yes };

/// Follows the first voxel on the bur's line, which recedes a voxel at a time.
class StrideWatch {
 public:
  StrideWatch(const Volume& volume, const DrillRun& run)
      : in_(run.direction), free_(voxels_on_line(volume, -run.voxel_mm, in_)) {}
  void update(const Volume& volume, double time_s, Counting counting) {
    const double now = voxels_on_line(volume, free_, in_);
    if (now > free_ && counting == Counting::yes) {
      last_ = {now, time_s};
      if (std::isnan(first_.depth_mm)) first_ = last_;
    }
    free_ = now;
  }
  /// kAbsent if fewer than two strides were seen.
  double speed_mm_s() const {
    if (!(last_.time_s > first_.time_s)) return kAbsent;
    return (last_.depth_mm - first_.depth_mm) / (last_.time_s - first_.time_s);
  }

 private:
  struct Stride {
    double depth_mm = kAbsent, time_s = 0.0;
  };
  Vec3 in_;
  double free_;
  Stride first_, last_;
};

struct TickCounts {
  std::int64_t total, run_in;
};
TickCounts ticks_of(const DrillRun& run) {
  const auto total = static_cast<std::int64_t>(run.stroke_mm / (run.target_mm_s * (run.tick_ms * 1e-3)) + 0.5);
  return {total, static_cast<std::int64_t>(kRunIn * static_cast<double>(total) + 0.5)};
}

/// A method on voxels: the speed at which the bur's line is freed.
DrillSpeed drill_voxels(const DrillRun& run) {
  Drilling drilling(run);
  drilling.approach();
  const auto [total, run_in] = ticks_of(run);
  StrideWatch strides(drilling.volume(), run);
  for (std::int64_t k = 1; k <= total; ++k) {
    drilling.cut();
    strides.update(drilling.volume(), static_cast<double>(k) * (run.tick_ms * 1e-3),
                    k > run_in ? Counting::yes : Counting::no);
  }
  return {kAbsent, strides.speed_mm_s(), kAbsent, run.target_mm_s, total};
}

/// A method on a surface: the remaining surface after the run-in and at the end.
DrillSpeed drill_surface(const DrillRun& run) {
  Drilling drilling(run);
  drilling.approach();
  const auto [total, run_in] = ticks_of(run);
  Remaining first{};
  double from = 0.0;
  for (std::int64_t k = 1; k <= total; ++k) {
    drilling.cut();
    if (k != run_in) continue;
    from = drilling.depth_mm();
    first = drilling.remaining();
  }
  const double seconds = static_cast<double>(total - run_in) * (run.tick_ms * 1e-3);
  const Remaining last = drilling.remaining();
  const double begin = depth_of(run.cutter, first.mm3, from), end = depth_of(run.cutter, last.mm3, drilling.depth_mm());
  const double exact = closed_form_mm3(run.cutter, last.deepest_mm);
  return {(end - begin) / seconds, (last.deepest_mm - first.deepest_mm) / seconds, 100.0 * (last.mm3 / exact - 1.0),
          run.target_mm_s, total};
}

}  // namespace

DrillSpeed drill(const DrillRun& asked_run) {
  const DrillRun run = with_stroke(asked_run);
  return reading_of(run.method) == Reading::filled ? drill_voxels(run) : drill_surface(run);
}

}  // namespace cusp::bench
