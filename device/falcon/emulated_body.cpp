#include "device/falcon/emulated_body.h"

#include <algorithm>
#include <cmath>

namespace cusp::device::falcon {

namespace {

constexpr LinkTime kStep = std::chrono::microseconds(50);
constexpr double kStepS = 50e-6;
constexpr int kMostSteps = 400;  // of one call: a longer stall is skipped
constexpr double kInM = 0.080, kOutM = 0.170;

}  // namespace

EmulatedBody::EmulatedBody(Emulator& falcon, const EmulatedBodySettings& settings) noexcept
    : falcon_(falcon), settings_(settings) {}

void EmulatedBody::home(double dt_s) noexcept {
  Vec3 at = falcon_.grip_m();
  at.z += out_m_s_ * dt_s;
  if (at.z >= kOutM) out_m_s_ = -std::abs(out_m_s_);
  if (at.z <= kInM) out_m_s_ = std::abs(out_m_s_);
  falcon_.set_grip(at);
  speed_ = Vec3(0.0);
}

void EmulatedBody::advance(LinkTime now) noexcept {
  if (!before_) before_ = now;
  if (now - *before_ > kMostSteps * kStep) before_ = now - kMostSteps * kStep;
  const auto delay = std::min<std::size_t>(kPast - 1, static_cast<std::size_t>(settings_.motor_delay / kStep));
  for (; *before_ + kStep <= now; *before_ += kStep) {
    past_at_ = (past_at_ + 1) % kPast;
    past_[past_at_] = falcon_.force_n(*before_);
    if (falcon_.homed() != status::kHomed) {
      home(kStepS);
      continue;
    }
    const Vec3 at = falcon_.grip_m();
    const auto legs = inverse({}, at);
    const auto rows = legs ? jacobian({}, *legs) : std::nullopt;
    if (!rows) return;
    const Vec3 weight = device::falcon::force_n(*rows, gravity_torque_nm({}, {at, *legs, *rows}, settings_.weight));
    const Vec3 push = past_[(past_at_ + kPast - delay) % kPast] + hand_n_ - weight - speed_ * settings_.damping_ns_per_m;
    // Friction first brakes the motion, then holds the grip at rest.
    Vec3 next = speed_ + push * (kStepS / settings_.moving_kg);
    const double brake = settings_.friction_n * kStepS / settings_.moving_kg;
    const double after = glm::length(next);
    next = after > brake ? next - (next / after) * brake : Vec3(0.0);
    const Vec3 to = at + next * kStepS;
    falcon_.set_grip(to);
    // The grip stops at an end of its travel.
    speed_ = glm::length(falcon_.grip_m() - to) < 1e-12 ? next : Vec3(0.0);
  }
}

}  // namespace cusp::device::falcon
