#include "device/falcon/workspace.h"

#include <cmath>

namespace cusp::device::falcon {

namespace {
constexpr double kMmPerM = 1000.0;

bool all_finite(Vec3 v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
}  // namespace

Workspace::Workspace(const WorkspaceSettings& settings) noexcept
    : settings_(settings), cosine_(std::cos(settings.yaw_rad)), sine_(std::sin(settings.yaw_rad)) {}

std::optional<Workspace> Workspace::from(const WorkspaceSettings& settings) noexcept {
  if (!all_finite(settings.centre_m) || !all_finite(settings.origin_mm) || !std::isfinite(settings.yaw_rad))
    return std::nullopt;
  if (!(settings.scale >= kMinScale && settings.scale <= kMaxScale)) return std::nullopt;
  return Workspace(settings);
}

Vec3 Workspace::turned(Vec3 device) const noexcept {
  const double x = device.x, y = -device.z;
  return {cosine_ * x - sine_ * y, sine_ * x + cosine_ * y, device.y};
}

Vec3 Workspace::specimen_mm(Vec3 grip_m) const noexcept {
  if (held_) return held_mm_;
  return settings_.origin_mm + turned(grip_m - settings_.centre_m) * (kMmPerM * settings_.scale);
}

Vec3 Workspace::device_n(Vec3 n) const noexcept {
  const double x = cosine_ * n.x + sine_ * n.y, y = -sine_ * n.x + cosine_ * n.y;
  return {x, n.z, -y};
}

Vec3 Workspace::grip_m(Vec3 specimen_mm) const noexcept {
  return settings_.centre_m + device_n(specimen_mm - settings_.origin_mm) / (kMmPerM * settings_.scale);
}

void Workspace::hold(Vec3 grip_m) noexcept {
  if (held_) return;
  held_mm_ = specimen_mm(grip_m);
  held_ = true;
}

void Workspace::release(Vec3 grip_m) noexcept {
  if (!held_) return;
  held_ = false;
  settings_.origin_mm += held_mm_ - specimen_mm(grip_m);
}

}  // namespace cusp::device::falcon
