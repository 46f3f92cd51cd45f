#include "device/falcon/kinematics.h"

#include <algorithm>
#include <cmath>

#include "device/falcon/protocol.h"

namespace cusp::device::falcon {

namespace {

constexpr double kLongestStepM = 0.030;  // longer steps diverge from some cold starts
constexpr double kSolvedRad = 1e-12;
constexpr double kGoodEnoughRad = 1e-9;  // under a tenth of a micrometre everywhere; reached where rounding ends Newton
constexpr int kWarmSteps = 16;           // a warm start 1 mm away takes 4
constexpr int kHalvings = 8;

struct LegFrame {
  double cosine, sine;
};

LegFrame frame_of(const Geometry& g, int leg) noexcept {
  const double phi = g.leg_rad[static_cast<std::size_t>(leg)];
  return {std::cos(phi), std::sin(phi)};
}

/// Solves M x = b for M with these rows; nullopt if M is nearly singular.
std::optional<Vec3> solve(const Jacobian& rows, Vec3 b) noexcept {
  const Vec3 c0 = glm::cross(rows[1], rows[2]);
  const double det = glm::dot(rows[0], c0);
  const double size = glm::length(rows[0]) * glm::length(rows[1]) * glm::length(rows[2]);
  if (!(std::abs(det) > 1e-6 * size)) return std::nullopt;  // NaN too
  return (b.x * c0 + b.y * glm::cross(rows[2], rows[0]) + b.z * glm::cross(rows[0], rows[1])) / det;
}

bool finite(Vec3 v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

double largest(Vec3 v) noexcept { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

std::optional<Pose> pose_at(const Geometry& geometry, Vec3 grip_m) noexcept {
  const auto legs = inverse(geometry, grip_m);
  if (!legs) return std::nullopt;
  const auto rows = jacobian(geometry, *legs);
  if (!rows) return std::nullopt;
  return Pose{grip_m, *legs, *rows};
}

/// Newton with a limited step. Halves a step that leaves the reach or increases the error.
std::optional<Pose> newton(const Geometry& geometry, Vec3 arm_rad, Vec3 start_m, int steps) noexcept {
  auto pose = pose_at(geometry, start_m);
  if (!pose) return std::nullopt;
  double error = largest(arm_rad - pose->legs.arm_rad);
  for (int step = 0; step < steps && error > kSolvedRad; ++step) {
    const auto full = solve(pose->rows, arm_rad - pose->legs.arm_rad);
    if (!full || !finite(*full)) return std::nullopt;
    const double length = glm::length(*full);
    Vec3 move = length > kLongestStepM ? *full * (kLongestStepM / length) : *full;
    std::optional<Pose> next;
    double left = error;
    for (int halving = 0; halving < kHalvings; ++halving, move *= 0.5) {
      next = pose_at(geometry, pose->grip_m + move);
      if (!next) continue;
      left = largest(arm_rad - next->legs.arm_rad);
      if (left < error) break;
      next.reset();
    }
    if (!next) break;
    pose = next;
    error = left;
  }
  if (!(error <= kGoodEnoughRad)) return std::nullopt;
  return pose;
}

}  // namespace

std::optional<Legs> inverse(const Geometry& g, Vec3 p) noexcept {
  Legs legs;
  for (int i = 0; i < 3; ++i) {
    const LegFrame frame = frame_of(g, i);
    const double u = p.x * frame.cosine + p.y * frame.sine - g.base_out;
    const double v = -p.x * frame.sine + p.y * frame.cosine - g.base_side;
    const double w = p.z;
    const double lean = (v + g.wrist_side) / g.shin;
    if (!(std::abs(lean) < 1.0)) return std::nullopt;
    const double side = std::acos(lean);
    const double reach = g.links + g.shin * std::sin(side);
    const double out = u + g.wrist_out;
    const double far = std::sqrt(out * out + w * w);
    const double bend = (g.arm * g.arm + out * out + w * w - reach * reach) / (2.0 * g.arm * far);
    if (!(std::abs(bend) < 1.0)) return std::nullopt;
    const double arm = std::atan2(w, out) - std::acos(bend);
    legs.side_rad[i] = side;
    legs.arm_rad[i] = arm;
    legs.knee_rad[i] = std::atan2(w - g.arm * std::sin(arm), out - g.arm * std::cos(arm));
  }
  return legs;
}

std::optional<Jacobian> jacobian(const Geometry& g, const Legs& legs) noexcept {
  Jacobian rows;
  for (int i = 0; i < 3; ++i) {
    const LegFrame frame = frame_of(g, i);
    const double sin_side = std::sin(legs.side_rad[i]);
    const double below = g.arm * sin_side * std::sin(legs.knee_rad[i] - legs.arm_rad[i]);
    if (!(std::abs(below) > 1e-6)) return std::nullopt;
    const double nu = std::cos(legs.knee_rad[i]) * sin_side;
    const double nv = std::cos(legs.side_rad[i]);
    const double nw = std::sin(legs.knee_rad[i]) * sin_side;
    rows[static_cast<std::size_t>(i)] =
        Vec3(nu * frame.cosine - nv * frame.sine, nu * frame.sine + nv * frame.cosine, nw) / below;
  }
  return rows;
}

std::optional<Pose> forward(const Geometry& geometry, Vec3 arm_rad, Vec3 start_m) noexcept {
  if (!finite(arm_rad)) return std::nullopt;
  if (finite(start_m)) {
    if (auto pose = newton(geometry, arm_rad, start_m, kWarmSteps)) return pose;
  }
  return newton(geometry, arm_rad, kMiddleM, kForwardSteps - kWarmSteps);
}

Vec3 torque_nm(const Jacobian& rows, Vec3 force) noexcept {
  // Power in equals power out: tau . (J v) = F . v for every v, so J^T tau = F.
  const Jacobian transposed = {Vec3(rows[0].x, rows[1].x, rows[2].x), Vec3(rows[0].y, rows[1].y, rows[2].y),
                               Vec3(rows[0].z, rows[1].z, rows[2].z)};
  return solve(transposed, force).value_or(Vec3(0.0));
}

Vec3 force_n(const Jacobian& rows, Vec3 torque) noexcept {
  return rows[0] * torque.x + rows[1] * torque.y + rows[2] * torque.z;
}

Vec3 arm_rad_s(const Jacobian& rows, Vec3 grip) noexcept {
  return {glm::dot(rows[0], grip), glm::dot(rows[1], grip), glm::dot(rows[2], grip)};
}

Vec3 grip_m_s(const Jacobian& rows, Vec3 arm) noexcept { return solve(rows, arm).value_or(Vec3(0.0)); }

Vec3 arm_rad_of_ticks(const Geometry& geometry, const Calibration& calibration,
                      std::array<std::int16_t, 3> ticks) noexcept {
  return Vec3(ticks[0], ticks[1], ticks[2]) * geometry.rad_per_tick + geometry.zero_rad + calibration.trim_rad;
}

Vec3 ticks_of_arm_rad(const Geometry& geometry, const Calibration& calibration, Vec3 arm_rad) noexcept {
  return (arm_rad - calibration.trim_rad - geometry.zero_rad) / geometry.rad_per_tick;
}

std::array<std::int16_t, 3> counts_of_torque(const Calibration& calibration, Vec3 torque) noexcept {
  Vec3 counts = torque * -(calibration.counts_per_nm * calibration.force_gain);
  if (!finite(counts)) return {};
  const double most = largest(counts);
  if (most > kMaxTorqueCounts) counts *= kMaxTorqueCounts / most;
  std::array<std::int16_t, 3> words{};
  for (int i = 0; i < 3; ++i) {
    const double word = std::clamp(std::round(counts[i]), -1.0 * kMaxTorqueCounts, 1.0 * kMaxTorqueCounts);
    words[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(word);
  }
  return words;
}

Vec3 torque_of_counts(const Calibration& calibration, std::array<std::int16_t, 3> counts) noexcept {
  return Vec3(counts[0], counts[1], counts[2]) / -(calibration.counts_per_nm * calibration.force_gain);
}

}  // namespace cusp::device::falcon
