#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "tests/bench/candidates.h"
#include "tests/bench/cavity.h"
#include "tests/bench/frame.h"
#include "tests/bench/pin.h"

namespace cusp::bench {

namespace {

constexpr double kHalfX = 2.025, kHalfY = 0.55;  // of the box of the bur's centres, mm
constexpr double kFirstZ = 0.2, kFloorZ = -1.4, kLayerMm = 0.2, kRowMm = 0.22;
constexpr std::array<double, 3> kExplorers = {0.25, 0.4, 0.5};
constexpr auto kMillBur = static_cast<std::uint16_t>(kExplorers.size());
constexpr double kFreeStepMm = 0.05;         // a tick, through free space
const Vec3 kInside(0.0, 0.0, -0.8);          // free for every explorer, in the frame's own axes

/// Its distance and its key are all that the scene needs.
class SolidBlock : public Shape {
 public:
  SolidBlock() : Shape("cavity", kMillRadiusMm) {}
  std::string key() const override { return "face"; }
  double distance_mm(Vec3 p) const override { return oblique_frame().to_local(p).z; }
  Vec3 tool_axis() const override { return oblique_frame().z; }
  Vec3 home() const override { return oblique_frame().to_world({0.0, 0.0, 3.0}); }
  std::unique_ptr<Truth> truth() const override { return nullptr; }
  Spot spot(Random&) const override { return {}; }
  Leg leg(Random&, const Vec3*) const override { return {}; }
  Vec3 before(Vec3 first) const override { return first; }
};

}  // namespace

std::shared_ptr<Scene> cavity_scene(Method method, double mill_radius_mm) {
  auto scene = scene_of(SolidBlock(), method, kCavityVoxelMm);
  scene->burs.resize(1);
  const Bur model = scene->burs.front();
  scene->burs.clear();
  std::vector<double> radii(kExplorers.begin(), kExplorers.end());
  radii.push_back(mill_radius_mm);
  for (const double radius : radii) {
    Bur bur = model;
    bur.radius_mm = radius;
    bur.neck_radius_mm = bur.shank_radius_mm = 0.1;
    scene->burs.push_back(bur);
  }
  scene->full_force_n = 0.25;
  for (TissueFeel& feel : scene->tissues) feel = {1.0, 20.0};
  return scene;
}

std::uint16_t Cavity::bur_of(double radius_mm) {
  const auto found = std::ranges::find(kExplorers, radius_mm);
  if (found == kExplorers.end()) throw std::invalid_argument(fmt::format("no bur of {} mm explores the cavity", radius_mm));
  return static_cast<std::uint16_t>(found - kExplorers.begin());
}

MillMotion::MillMotion(const MillHand& hand) : hand_(hand), random_(hand.seed) {
  for (auto& axis : wave_)
    for (Wave& wave : axis) wave = {random_.between(8.0, 12.0), random_.between(0.0, 6.283185307179586)};
  corners_ = {{-kHalfX, -kHalfY, 1.0}};
  plan_pass();
}

void MillMotion::plan_rows(double z_mm, int lane_axis, double shift_mm) {
  const double half_across = lane_axis == 0 ? kHalfY : kHalfX, half_along = lane_axis == 0 ? kHalfX : kHalfY;
  double side = -1.0;
  for (double across = -half_across + shift_mm;; across += kRowMm) {
    const double row = std::min(across, half_across);
    for (const double end : {side, -side})
      corners_.push_back(lane_axis == 0 ? Vec3(end * half_along, row, z_mm) : Vec3(row, end * half_along, z_mm));
    side = -side;
    if (row == half_across) return;
  }
}

void MillMotion::plan_round(double z_mm) {
  const double x = kHalfX, y = kHalfY;
  for (const Vec3 corner : {Vec3(-x, -y, z_mm), Vec3(x, -y, z_mm), Vec3(x, y, z_mm), Vec3(-x, y, z_mm), Vec3(-x, -y, z_mm)})
    corners_.push_back(corner);
}

/// Layers first; then floor, wall, floor across, wall, at random heights and phases.
void MillMotion::plan_pass() {
  const Vec3 last = corners_.back();
  corners_.assign(1, last);
  corner_ = 0;
  constexpr int kLayers = 9;
  if (pass_ < kLayers) {
    plan_rows(std::max(kFloorZ, kFirstZ - kLayerMm * pass_), pass_ % 2, 0.0);
  } else if (pass_ % 2 == 0) {
    plan_round(random_.between(kFloorZ, -0.3));
  } else {
    plan_rows(kFloorZ, pass_ / 2 % 2, random_.between(0.0, kRowMm));
  }
  ++pass_;
}

Vec3 MillMotion::trembling(Vec3 at) const {
  // kWaves sines of amplitude a in each of three axes have the rms a sqrt(3 kWaves / 2).
  const double amplitude = hand_.tremor_mm * std::sqrt(2.0 / (3.0 * kWaves));
  const double t = 1e-3 * static_cast<double>(tick_);
  for (int axis = 0; axis < 3; ++axis)
    for (const Wave& wave : wave_[axis]) at[axis] += amplitude * std::sin(6.283185307179586 * wave.hz * t + wave.phase);
  return at;
}

Vec3 MillMotion::next() {
  along_mm_ += kMillSpeedMmS * 1e-3;
  for (;;) {
    if (corner_ + 1 >= corners_.size()) plan_pass();
    const double whole = length(corners_[corner_ + 1] - corners_[corner_]);
    if (along_mm_ < whole) break;
    along_mm_ -= whole;
    ++corner_;
  }
  ++tick_;
  const Vec3 way = unit(corners_[corner_ + 1] - corners_[corner_]);
  Vec3 at = oblique_frame().to_world(trembling(corners_[corner_] + way * along_mm_));
  if (hand_.encoder_mm > 0.0)
    for (int axis = 0; axis < 3; ++axis) at[axis] = hand_.encoder_mm * std::round(at[axis] / hand_.encoder_mm);
  return at;
}

void lead_bur(StepState& state, std::uint16_t bur, Vec3 to_mm, double per_tick_mm) {
  const auto stepper = [bur](StepState& at, const StepInput& input) {
    StepInput with = input;
    with.bur = bur;
    return step(at, with);
  };
  lead(state, stepper, to_mm, per_tick_mm);
}

void enter_cavity(StepState& state, std::uint16_t bur) {
  const Frame frame = oblique_frame();
  Vec3 above = frame.to_local(state.last().proxy_mm);
  above.z = 2.0;
  lead_bur(state, state.last().bur, frame.to_world(above), kFreeStepMm);
  lead_bur(state, bur, frame.to_world({0.0, 0.0, 2.0}), kFreeStepMm);
  lead_bur(state, bur, frame.to_world(kInside), kFreeStepMm);
}

Cavity::Cavity(Method method, const MillHand& hand, double mill_radius_mm)
    : state_(cavity_scene(method, mill_radius_mm)), motion_(hand) {
  lead_bur(state_, kMillBur, SolidBlock().home(), 1.0);
}

void Cavity::resume() {
  enter_cavity(state_, kMillBur);
  lead_bur(state_, kMillBur, device_, kFreeStepMm);
}

double Cavity::mill_tick() {
  ++ticks_;
  device_ = motion_.next();
  StepInput input = input_at(device_, Button::down);
  input.bur = kMillBur;
  const double before = core_time_s();
  step(state_, input);
  const double spent = core_time_s() - before;
  record();
  return spent;
}

void Cavity::record() {
  Sweep now;
  if (!newest_sweep(state_, now.a, now.b)) return;
  if (!sweeps_.empty() && sweeps_.back().a == now.a) {
    sweeps_.back() = now;
  } else {
    sweeps_.push_back(now);
  }
}

std::shared_ptr<const SweptSurface> cavity_surface(const std::vector<Sweep>& sweeps) {
  const Frame frame = oblique_frame();
  return std::make_shared<const SweptSurface>(SweptPath(sweeps, kMillRadiusMm),
                                              [&](Vec3 p) { return -0.05 - frame.to_local(p).z; });
}

std::shared_ptr<const SweptSurface> cavity_surface_about(const std::vector<Sweep>& sweeps, Vec3 place, double reach_mm) {
  std::vector<Sweep> near;
  std::ranges::copy_if(sweeps, std::back_inserter(near), [&](const Sweep& s) {
    return length(nearest_on(s, place) - place) < kMillRadiusMm + reach_mm;
  });
  return std::make_shared<const SweptSurface>(SweptPath(std::move(near), kMillRadiusMm),
                                              [&](Vec3 p) { return reach_mm - length(p - place); });
}

std::vector<Vec3> exploring_points(double radius_mm, double speed_mm_s, std::uint64_t seed, int ticks) {
  Random random(seed);
  const Frame frame = oblique_frame();
  // A ball stands against floor and walls where its device point is on this box's faces.
  const double beyond = kMillRadiusMm - radius_mm + kDepthMm;
  const Vec3 low(-kHalfX - beyond, -kHalfY - beyond, kFloorZ - beyond), high(kHalfX + beyond, kHalfY + beyond, -0.55);
  std::vector<Vec3> out;
  Vec3 at(0.0, 0.0, -0.8);
  int face = 0;  // floor, then the walls: -x, +x, -y, +y
  const auto on_face = [&](int f) {
    Vec3 p = random.in(low, high);
    if (f == 0) p.z = low.z;
    if (f == 1 || f == 2) p.x = f == 1 ? low.x : high.x;
    if (f == 3 || f == 4) p.y = f == 3 ? low.y : high.y;
    return p;
  };
  const auto go = [&](Vec3 to) {
    const double whole = length(to - at);
    const int steps = static_cast<int>(whole / (speed_mm_s * 1e-3)) + 1;
    for (int k = 1; k <= steps && static_cast<int>(out.size()) < ticks; ++k)
      out.push_back(frame.to_world(at + (to - at) * (static_cast<double>(k) / steps)));
    at = to;
  };
  go(on_face(0));
  while (static_cast<int>(out.size()) < ticks) {
    if (random.between(0.0, 1.0) < 0.6) {
      go(on_face(face));
      continue;
    }
    // Round the edge between floor and wall.
    const int wall = face == 0 ? 1 + static_cast<int>(random.between(0.0, 4.0)) : face;
    Vec3 edge = on_face(wall);
    edge.z = low.z;
    go(edge);
    face = face == 0 ? wall : 0;
    go(on_face(face));
  }
  return out;
}

}  // namespace cusp::bench
