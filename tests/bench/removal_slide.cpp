// Cutting while sliding, ridges between cuts, and the cost of a cutting tick.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "engine/step/state.h"
#include "tests/bench/frame.h"
#include "tests/bench/motions.h"
#include "tests/bench/pin.h"
#include "tests/bench/removal_paths.h"
#include "tests/bench/tick_times.h"
#include "tests/modules.h"
#include "tests/random.h"

namespace cusp::bench {

namespace {

using test::Random;

constexpr double kCircleMm = 1.0;     // mm; radius of the circle
constexpr double kSlidePressMm = 0.12;     // mm of the device point below the offset surface at the start
constexpr double kTremorMm = 0.02;    // mm; amplitude of the tremor, 9 Hz
constexpr double kNoiseMm = 0.002;    // mm; noise of the device from tick to tick
constexpr double kSlideS = 1.5;
constexpr double kRidgeWearMmS = 1e-3;
constexpr int kRidgeRestTicks = 100;
constexpr int kSkip = 3;              // the exact excess is computed every kSkip ticks

/// The swept ball of all cutting ticks so far.
class SlidPath {
 public:
  SlidPath(double radius, double face_mm, Vec3 up) : radius_(radius), face_(face_mm), up_(up) {}
  void add(Vec3 a, Vec3 b) { segments_.push_back({a, b}); }
  /// Selects the segments within reach of y.
  void gather(Vec3 y) {
    near_.clear();
    for (const Segment& s : segments_)
      if (distance(s, y) < 2.0 * radius_ + 0.01) near_.push_back(s);
  }
  /// Depth of a place in the tissue before this tick: distance to the face and to the swept ball; negative outside.
  double depth(Vec3 x) const {
    double d = face_ - glm::dot(x, up_);
    for (const Segment& s : near_) {
      d = std::min(d, distance(s, x) - radius_);
      if (d <= 0.0) return d;
    }
    return d;
  }

 private:
  struct Segment {
    Vec3 a, b;
  };
  static double distance(const Segment& s, Vec3 x) {
    const Vec3 along = s.b - s.a;
    const double square = glm::dot(along, along);
    const double t = square > 1e-18 ? std::clamp(glm::dot(x - s.a, along) / square, 0.0, 1.0) : 0.0;
    return length(x - s.a - along * t);
  }
  double radius_, face_;
  Vec3 up_;
  std::vector<Segment> segments_, near_;
};

/// Recession of the surface for a ball at y: the largest depth of a point of the ball's surface.
double recession(SlidPath& way, Vec3 y, double radius, Vec3 up) {
  way.gather(y);
  const Frame f = Frame::of(up, {1.0, 0.51, 0.0}, Vec3(0.0));
  double best = 0.0;
  Vec3 best_u = -up;
  constexpr int kRings = 14;
  for (int i = 0; i <= kRings; ++i) {
    const double polar = 0.5 * std::numbers::pi * i / kRings;
    const int count = std::max(1, static_cast<int>(4.0 * kRings * std::sin(polar)));
    for (int j = 0; j < count; ++j) {
      const double around = 2.0 * std::numbers::pi * (j + 0.5 * (i & 1)) / count;
      const Vec3 u = f.direction({std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), -std::cos(polar)});
      const double d = way.depth(y + u * radius);
      if (d > best) {
        best = d;
        best_u = u;
      }
    }
  }
  if (best <= 0.0) return 0.0;
  for (double part = 0.05; part > 5e-4; part *= 0.5)
    for (bool moved = true; moved;) {
      moved = false;
      const Frame g = Frame::of(best_u, {0.3, 0.7, 0.2}, Vec3(0.0));
      for (const Vec3& side : {g.x, -g.x, g.y, -g.y}) {
        const Vec3 u = unit(best_u + side * part);
        const double d = way.depth(y + u * radius);
        if (d > best + 1e-9) {
          best = d;
          best_u = u;
          moved = true;
        }
      }
    }
  return best;
}

}  // namespace

SlideExcess slide_cutting(const Cutter& cutter, double voxel_mm, const Feeding& feeding, std::uint64_t seed) {
  const double radius = cutter.bur.radius_mm;
  auto scene = soft_scene(cutter, Method::surface, voxel_mm, Path::straight);
  constexpr double kWearMmS = 1.0;
  for (TissueFeel& feel : scene->tissues) feel = {1.0, kWearMmS};
  scene->full_force_n = kFullForceN;
  StepState state(scene);
  const Frame f = Frame::of(kPathUp, {1.0, 0.51, 0.0}, Vec3(0.0));
  Random random(seed);
  const double dt_s = feeding.tick_ms * 1e-3;
  const auto tick_us = static_cast<std::uint32_t>(feeding.tick_ms * 1000.0 + 0.5);
  const auto place = [&](std::int64_t k) {
    const double t = static_cast<double>(k) * dt_s;
    const double a = feeding.speed_mm_s * t / kCircleMm;
    const double tremor = kTremorMm * std::sin(2.0 * std::numbers::pi * 9.0 * t);
    const Vec3 noise{random.between(-kNoiseMm, kNoiseMm), random.between(-kNoiseMm, kNoiseMm),
                     random.between(-kNoiseMm, kNoiseMm)};
    return f.to_world(Vec3{kCircleMm * std::cos(a) + 0.5 * tremor, kCircleMm * std::sin(a), radius - kSlidePressMm + tremor} + noise);
  };
  lead(state, step, place(0) + f.z * 0.4, 0.05);
  lead(state, step, place(0), 0.02);
  SlidPath way(radius, 0.0, f.z);
  const auto ticks = static_cast<std::int64_t>(kSlideS / dt_s + 0.5);
  std::vector<double> excess;
  SlideExcess out;
  out.ticks = ticks;
  bool cutting = false;
  Vec3 pose{0.0};
  for (std::int64_t k = 0; k < ticks; ++k) {
    StepInput input = input_at(place(k), Button::down);
    input.elapsed_us = tick_us;
    const StepOutput got = step(state, input);
    const StepState::Inner& inner = state.inner();
    const bool valid = inner.cut_valid;
    if (valid && got.advance_mm > 0.0) {
      const bool whole = cutting && length(inner.cut_pose - pose) <= 0.3;
      const Vec3 from = whole ? pose : inner.cut_pose;
      if (k % kSkip == 0) {
        double most = recession(way, inner.cut_pose, radius, f.z);
        if (whole) most = std::max(most, recession(way, 0.5 * (from + inner.cut_pose), radius, f.z));
        excess.push_back((most - got.advance_mm) * 1e3);
      }
      way.add(from, inner.cut_pose);
      out.depth_um = std::max(out.depth_um, (radius - f.to_local(inner.cut_pose).z) * 1e3);
    }
    cutting = valid;
    pose = inner.cut_pose;
  }
  if (excess.empty()) return out;
  std::sort(excess.begin(), excess.end());
  out.most_um = excess.back();
  out.p99_um = excess[static_cast<std::size_t>(0.99 * static_cast<double>(excess.size() - 1))];
  return out;
}

namespace {

/// Two grooves of one bur side by side, and the ridge between them, in the frame of the face.
class RidgeBench {
 public:
  RidgeBench(const Cutter& cutter, double voxel_mm, double speed_mm_s)
      : radius_(cutter.bur.radius_mm),
        step_mm_(speed_mm_s * 1e-3),
        apart_(0.6 * radius_),
        pivot_(0.6 * radius_),
        ridge_(pivot_ - 0.8 * radius_),
        probe_(round_cutter(radius_)),
        soft_(soft_scene(cutter, Method::surface, voxel_mm, Path::straight)) {
    soft_->burs.push_back(probe_.bur);
  }

  /// The state after both strokes.
  StepState cut_grooves() const {
    StepState state(soft_);
    constexpr double kHalf = 1.2;
    for (const double side : {-1.0, 1.0}) {
      const auto place = [&](double y) { return frame_.to_world({side * apart_, y, pivot_}); };
      lead(state, step, place(-kHalf) + frame_.z * (2.0 * radius_), 0.2);
      lead(state, step, place(-kHalf) + frame_.z * (0.4 * radius_), 0.02);
      step(state, input_at(place(-kHalf), Button::down));
      for (double y = -kHalf; y < kHalf; y += step_mm_) step(state, input_at(place(y), Button::down));
      step(state, input_at(place(kHalf), Button::up));
      lead(state, step, place(kHalf) + frame_.z * (2.0 * radius_), 0.2);
    }
    return state;
  }

  /// The largest height error that the probe, half as wide as the bur, feels on the ridge at nine places, um.
  double felt_um(StepState& state) const {
    double most = 0.0;
    for (int i = 0; i < 9; ++i) {
      const double highest = highest_mm(state, -0.8 + 0.2 * i + 0.037, i == 0 ? kRidgeRestTicks : 0);
      most = std::max(most, std::fabs(ridge_ - highest) * 1e3);
    }
    return most;
  }

  /// Moves the bur across the ridge 40 times, the button down, in tissue that wears by kRidgeWearMmS.
  StepState wear(const StepState& state, int& ticks) const {
    auto hard = std::make_shared<Scene>(*soft_);
    for (TissueFeel& feel : hard->tissues) feel = {1.0, kRidgeWearMmS};
    hard->full_force_n = kFullForceN;
    StepState worn = *StepState::restore(hard, state.save());
    lead(worn, step, frame_.to_world({-apart_, -1.0, pivot_ + 1.0}), 0.05);
    lead(worn, step, frame_.to_world({-apart_, -1.0, pivot_ - 0.05}), 0.02);
    const double wide = 1.5 * apart_, z = ridge_ + radius_ - 0.1;
    ticks = static_cast<int>(40.0 * 2.0 * wide / step_mm_);
    for (int k = 0; k < ticks; ++k) {
      const double phase = std::fmod(k * step_mm_ / (2.0 * wide), 2.0);
      const double x = phase < 1.0 ? -wide + 2.0 * wide * phase : wide - 2.0 * wide * (phase - 1.0);
      step(worn, input_at(frame_.to_world({x, -1.0 + 2.0 * k / ticks, z}), Button::down));
    }
    step(worn, input_at(frame_.to_world({0.0, 1.0, z}), Button::up));
    return worn;
  }

 private:
  Vec3 probe_at(StepState& state, Vec3 local) const {
    StepInput input = input_at(frame_.to_world(local));
    input.bur = 1;
    return step(state, input).proxy_mm;
  }
  /// Height of the probe's lowest point at the top of its way from groove to groove. The probe first rests in its groove
  /// for rest_ticks, in which the method finds the edges about it.
  double highest_mm(StepState& state, double y, int rest_ticks) const {
    const double radius = probe_.bur.radius_mm, z = ridge_ + radius - 0.1;
    for (double up = 2.0; up > 0.0; up -= 0.05) probe_at(state, {-0.5 * apart_, y, z + up});
    for (int k = 0; k < rest_ticks; ++k) probe_at(state, {-0.5 * apart_, y, z});
    double highest = -1e9;
    for (double x = -0.5 * apart_; x <= 0.5 * apart_; x += 0.004)
      highest = std::max(highest, frame_.to_local(probe_at(state, {x, y, z})).z - radius);
    for (double up = 0.0; up < 2.0; up += 0.05) probe_at(state, {0.5 * apart_, y, z + up});
    return highest;
  }

  Frame frame_ = Frame::of(kPathUp, {1.0, 0.51, 0.0}, Vec3(0.0));
  double radius_, step_mm_;
  double apart_, pivot_;  // of each groove from the ridge; of the bur above the face
  double ridge_;          // height of the exact ridge
  Cutter probe_;
  std::shared_ptr<Scene> soft_;
};

}  // namespace

RidgeError ridge_between(const Cutter& cutter, double voxel_mm, double speed_mm_s) {
  const RidgeBench bench(cutter, voxel_mm, speed_mm_s);
  StepState state = bench.cut_grooves();
  RidgeError out;
  out.felt_um = bench.felt_um(state);
  int ticks = 0;
  StepState worn = bench.wear(state, ticks);
  out.after_um = bench.felt_um(worn) - kRidgeWearMmS * ticks;  // kRidgeWearMmS is um a tick of 1 ms as well
  return out;
}

CutCost cost_of_cutting(const Cutter& cutter, Method method, double voxel_mm, double budget_s) {
  DrillRun run;
  run.method = method;
  run.cutter = cutter;
  run.voxel_mm = voxel_mm;
  run.speed_mm_s.fill(1.2);
  run.stroke_mm = 1.4;  // of the block; half of it down, the rest across
  const auto scene = drill_scene(run);
  constexpr double kAheadMm = 0.25, kDownMm = 0.5;
  std::vector<double> us;
  const double begin = core_time_s();
  do {
    StepState state(scene);
    const Vec3 in = run.direction, side{1.0, 0.0, 0.0};
    const double r = cutter.bur.radius_mm;
    lead(state, step, -in * (r + 0.2), 0.05);
    lead(state, step, -in * (r - kAheadMm), 0.02);
    StepOutput out = state.last();
    for (const Vec3& way : {in, side})
      for (int k = 0; k < static_cast<int>(kDownMm / 1.2e-3); ++k) {
        const StepInput input = input_at(out.proxy_mm + way * kAheadMm, Button::down);
        const double before = core_time_s();
        out = step(state, input);
        us.push_back((core_time_s() - before) * 1e6);
      }
  } while (core_time_s() - begin < budget_s);
  CutCost cost;
  cost.ticks = static_cast<std::int64_t>(us.size());
  cost.p50_us = percentile(us, 0.5);
  cost.p99_us = percentile(us, 0.99);
  cost.most_us = us.back();
  return cost;
}

}  // namespace cusp::bench
