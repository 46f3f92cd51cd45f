// A ball within what one ball as wide or wider has swept is admissible. If the sweep's wall stands where it keeps the ball from
// the device, the pose is a minimum: no other constraint need be known.
#include <algorithm>

#include "engine/contact/cavity/cavity_walls.h"

namespace cusp::engine {

namespace {

constexpr int kAbout = Sweeps::kBeside;  // sweeps before and after the wall's owner among which the ball's holder is looked for
constexpr int kMostAlong = 64;        // sweeps that the ball passes in a tick
constexpr double kAtDeviceMm = 1e-6;  // a ball so near to the device is pulled nowhere
constexpr int kHeldWork = 16;  // units of 25 ns

}  // namespace

/// The sweep near `about`, or of the cutting, that holds the ball; kNone if none does.
std::int32_t CavityWalls::holder(const Ball& ball, std::int32_t about) const noexcept {
  Sweeps::Nearest found = sweeps_.nearest(sweeps_.about(about, kAbout, kAbout), ball.at);
  if (cutting_.any()) {
    const Sweeps::Nearest uncarved = sweeps_.nearest(cutting_.uncarved, ball.at);
    if (uncarved.distance_mm < found.distance_mm) found = uncarved;
  }
  return found.distance_mm <= sweeps_.radius_mm(found.sweep) - ball.radius_mm + kTieMm ? found.sweep : Sweeps::kNone;
}

/// Goes from sweep to sweep while the next one comes nearer to the device. False if the way is too long.
bool CavityWalls::along_way(const Ball& ball, Vec3 device, std::int32_t& sweep) const noexcept {
  const auto distance2 = [&](std::int32_t id) {
    const Vec3 off = device - sweeps_[id].nearest_on(device);
    return glm::dot(off, off);
  };
  double best = distance2(sweep);
  for (const int way : {1, -1}) {
    for (int k = 0;; ++k) {
      const SweepRun next = sweeps_.about(sweep, 1, 1);
      const std::int32_t id = way > 0 ? next.to : next.from;
      if (id == sweep || sweeps_.radius_mm(id) < ball.radius_mm) break;
      const double there = distance2(id);
      if (there >= best) break;
      if (k == kMostAlong) return false;
      best = there;
      sweep = id;
    }
  }
  return true;
}

CavityWalls::Held CavityWalls::held_by_sweep(const Volume& volume, const Ball& ball, Vec3 device) noexcept {
  Held out;
  const Vec3 way = device - ball.at;
  const double far = length_of(way);
  if (far < kAtDeviceMm) return out;
  const Vec3 front = ball.at + way * (ball.radius_mm / far);
  const SweptRuns& first = void_.runs_at(volume, front, cutting_.end);
  if (!first.known) return out;
  work_ += kHeldWork;
  std::int32_t sweep = deepest(first, front).sweep;
  if (sweep == Sweeps::kNone) return out;
  sweep = holder(ball, sweep);
  if (sweep == Sweeps::kNone || !along_way(ball, device, sweep)) return out;
  work_ += kHeldWork;
  const Sweep s = sweeps_[sweep];
  const double room = s.radius_mm - ball.radius_mm;
  const Vec3 on = s.nearest_on(device), off = device - on;
  const double distance = length_of(off);
  if (distance <= room) return {true, device, 0.0, Vec3(0.0), Vec3(0.0)};
  const Vec3 to = off / distance;
  out.pose = on + to * room;
  out.gap_mm = distance - room;
  out.n = -to;
  out.foot = on + to * s.radius_mm;
  const SweptRuns& runs = void_.runs_at(volume, out.foot, cutting_.end);
  if (!runs.known) return out;
  const Sweeps::Deepest deep = deepest(runs, out.foot);
  if (deep.sweep != sweep && deep.depth_mm > SweptVoid::kTakenMm) return out;
  out.held = !runs.near_base || void_.base(volume, out.foot).d_mm < -SweptVoid::kBaseTakenMm;
  return out;
}

}  // namespace cusp::engine
