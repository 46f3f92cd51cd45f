#include "device/pointer/pointer_hand.h"

#include <algorithm>
#include <cmath>

namespace cusp::device {
namespace {

constexpr double kRadians = 3.14159265358979323846 / 180.0;

bool finite(Vec3 v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

PointerHand::PointerHand(Vec3 start_mm) {
  wish_.target_mm = finite(start_mm) ? start_mm : Vec3(0.0);
  hand_over();
}

void PointerHand::move_to(Vec3 target_mm) noexcept {
  if (!finite(target_mm)) return;
  wish_.target_mm = target_mm;
  hand_over();
}

void PointerHand::nudge(double right_mm, double up_mm) noexcept {
  move_to(wish_.target_mm + right_ * right_mm + up_ * up_mm);
}

void PointerHand::set_push(double push_n) noexcept {
  wish_.push_n = push_n > 0.0 ? std::min(push_n, kMaxPushN) : 0.0;  // NaN releases
  hand_over();
}

void PointerHand::set_cut(bool cut) noexcept {
  wish_.cut = cut;
  hand_over();
}

void PointerHand::set_height(double& height_mm, const std::optional<Vec3>& pivot_mm) noexcept {
  if (pivot_mm && !finite(*pivot_mm)) return;
  height_mm = pivot_mm ? glm::dot(*pivot_mm, wish_.approach) : std::numeric_limits<double>::infinity();
  hand_over();
}

void PointerHand::set_floor(const std::optional<Vec3>& pivot_mm) noexcept { set_height(wish_.floor_mm, pivot_mm); }

void PointerHand::hold_depth(const std::optional<Vec3>& pivot_mm) noexcept { set_height(wish_.stop_mm, pivot_mm); }

void PointerHand::set_bur(std::uint16_t bur) noexcept {
  wish_.bur = bur;
  hand_over();
}

void PointerHand::turn(double right_deg, double up_deg) noexcept {
  if (!std::isfinite(right_deg) || !std::isfinite(up_deg)) return;
  // The shank points against the approach.
  const Vec3 by = glm::cross(-wish_.approach, right_ * right_deg + up_ * up_deg) * kRadians;
  turned_ += by;
  const double angle = glm::length(turned_);
  if (angle > turn_limit_) turned_ = angle > 0.0 ? turned_ * (turn_limit_ / angle) : Vec3(0.0);
  const double left = glm::length(turned_);
  wish_.orientation = left > 1e-9 ? Quat(std::cos(left / 2), turned_ * (std::sin(left / 2) / left)) : Quat(1.0, 0.0, 0.0, 0.0);
  hand_over();
}

void PointerHand::turn_back() noexcept {
  turned_ = Vec3(0.0);
  turn(0, 0);
}

void PointerHand::set_turn_limit(double degrees) noexcept {
  turn_limit_ = degrees > 0.0 ? std::min(degrees, 60.0) * kRadians : 0.0;
  turn(0, 0);
}

double PointerHand::turned_deg() const noexcept { return glm::length(turned_) / kRadians; }

void PointerHand::set_view(Vec3 approach, Vec3 right) noexcept {
  const double length = glm::length(approach);
  if (!finite(approach) || !finite(right) || !(length > 1e-6)) return;
  const Vec3 along = approach / length;
  const Vec3 across = right - along * glm::dot(right, along);
  const double width = glm::length(across);
  if (!(width > 1e-6) || !std::isfinite(width)) return;
  wish_.approach = along;
  right_ = across / width;
  up_ = glm::cross(right_, along);
  hand_over();
}

}  // namespace cusp::device
