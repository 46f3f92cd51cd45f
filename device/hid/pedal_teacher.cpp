#include "device/hid/pedal_teacher.h"

#include <algorithm>
#include <cmath>

namespace cusp::device::hid {

namespace {

double way(std::int32_t from, std::int32_t to) noexcept {
  return std::abs(static_cast<double>(to) - static_cast<double>(from));
}

}  // namespace

void PedalTeacher::rest(const std::vector<Control>& controls) {
  ways_.clear();
  for (const Control& control : controls) ways_.push_back({control, control.value});
}

void PedalTeacher::press(const std::vector<Control>& controls) {
  for (const Control& control : controls) {
    auto at = std::find_if(ways_.begin(), ways_.end(), [&](const Way& w) { return w.rest.id == control.id; });
    if (at == ways_.end()) {  // a key that was not down is not among the controls at rest
      Control up = control;
      if (control.kind != ControlKind::axis) up.value = 0;
      at = ways_.insert(ways_.end(), {up, up.value});
    }
    if (!at->rest.spoken && control.spoken && control.kind == ControlKind::axis) {
      at->rest = control;  // where it was first heard of is as near to its rest as is known
      at->furthest = control.value;
    }
    if (way(at->rest.value, control.value) > way(at->rest.value, at->furthest)) at->furthest = control.value;
  }
}

std::optional<Taught> PedalTeacher::found(double dead_zone) const {
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
  if (best == nullptr) return std::nullopt;
  const bool axis = best->rest.kind == ControlKind::axis;
  const auto calibration = PedalCalibration::from(best->rest.value, best->furthest, axis ? dead_zone : 0.0);
  if (!calibration) return std::nullopt;
  return Taught{best->rest.id, best->rest.kind, *calibration};
}

}  // namespace cusp::device::hid
