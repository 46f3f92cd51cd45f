#include "device/hid/pedal_finder.h"

#include <algorithm>
#include <cmath>

namespace cusp::device::hid {

namespace {

double way(std::int32_t from, std::int32_t to) noexcept {
  return std::abs(static_cast<double>(to) - static_cast<double>(from));
}

std::optional<FoundControl> between(const Control& control, std::int32_t released, std::int32_t pressed, double dead_zone) {
  const auto calibration = PedalCalibration::from(released, pressed, control.kind == ControlKind::axis ? dead_zone : 0.0);
  if (!calibration) return std::nullopt;
  return FoundControl{control.id, control.kind, *calibration};
}

}  // namespace

void PedalFinder::rest(const std::vector<Control>& controls) {
  ways_.clear();
  for (const Control& control : controls) ways_.push_back({control, control.value});
}

void PedalFinder::press(const std::vector<Control>& controls) {
  for (const Control& control : controls) {
    auto at = std::find_if(ways_.begin(), ways_.end(), [&](const Way& w) { return w.rest.id == control.id; });
    if (at == ways_.end()) {  // the controls at rest omit keys that were up
      Control up = control;
      if (control.kind != ControlKind::axis) up.value = 0;
      at = ways_.insert(ways_.end(), {up, up.value});
    }
    if (!at->rest.reported && control.reported && control.kind == ControlKind::axis) {
      at->rest = control;  // the first known value is the best estimate of its rest
      at->furthest = control.value;
    }
    move(*at, control.value);
  }
  for (Way& w : ways_) {  // the controls omit keys that are up
    const bool there = std::any_of(controls.begin(), controls.end(), [&](const Control& c) { return c.id == w.rest.id; });
    if (!there && w.rest.kind != ControlKind::axis) move(w, 0);
  }
}

void PedalFinder::move(Way& of, std::int32_t to) {
  if (way(of.rest.value, to) > way(of.rest.value, of.furthest)) of.furthest = to;
}

std::optional<Control> PedalFinder::down_at_rest() const {
  for (const Way& w : ways_) {
    if (w.rest.kind != ControlKind::axis && w.rest.value != w.rest.least) return w.rest;
  }
  return std::nullopt;
}

const PedalFinder::Way* PedalFinder::best() const {
  const Way* best = nullptr;
  double best_share = 0;
  for (const Way& w : ways_) {
    const bool axis = w.rest.kind == ControlKind::axis;
    const double range = way(w.rest.least, w.rest.most);
    const double share = range > 0 ? way(w.rest.value, w.furthest) / range : 0;
    if (share < (axis ? kLeastWay : 1e-9)) continue;
    const double weight = axis ? 1.0 + share : 0.5;
    if (weight > best_share) {
      best_share = weight;
      best = &w;
    }
  }
  return best;
}

std::optional<FoundControl> PedalFinder::found(double dead_zone) const {
  const Way* moved = best();
  if (moved == nullptr) return std::nullopt;
  return between(moved->rest, moved->rest.value, moved->furthest, dead_zone);
}

std::optional<FoundControl> PedalFinder::released(const std::vector<Control>& controls, double dead_zone) const {
  const Way* moved = best();
  if (moved == nullptr) return std::nullopt;
  const auto now = std::find_if(controls.begin(), controls.end(), [&](const Control& c) { return c.id == moved->rest.id; });
  const bool known = now != controls.end() && now->reported;
  if (!known && moved->rest.kind == ControlKind::axis) return std::nullopt;
  const std::int32_t off = known ? now->value : 0;  // the controls omit keys that are up
  const std::int32_t rest = moved->rest.value, pressed = moved->furthest;
  if (way(rest, off) > kMostApart * way(rest, pressed)) return std::nullopt;
  // The one nearer to the pressed end: at neither value the pedal drills.
  return between(moved->rest, way(off, pressed) < way(rest, pressed) ? off : rest, pressed, dead_zone);
}

}  // namespace cusp::device::hid
