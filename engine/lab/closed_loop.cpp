#include "engine/lab/closed_loop.h"

#include <algorithm>
#include <cmath>

namespace cusp::engine::lab {

namespace {
constexpr double kSlicesPerMs = 1000.0 / kSliceUs;
constexpr double kMostMm = 1e5;  // range of a reading: 100 m
}  // namespace

ClosedLoop::ClosedLoop(const DeviceSettings& device, const TransportSettings& transport, const Grip& grip,
                       Vec3 start_mm, Vec3 encoder_phase)
    : device_(device),
      transport_(transport),
      plant_(device, grip, start_mm),
      phase_(encoder_phase),
      dice_(transport.seed) {}

std::int32_t ClosedLoop::read(int axis) const noexcept {
  double at = plant_.position_mm()[axis];
  if (device_.encoder_step_mm > 0.0) {
    at = (std::floor(at / device_.encoder_step_mm + phase_[axis]) + 0.5 - phase_[axis]) * device_.encoder_step_mm;
  }
  return static_cast<std::int32_t>(std::lround(std::clamp(at, -kMostMm, kMostMm) * 1e4));
}

std::int64_t ClosedLoop::one_way() noexcept {
  double ms = 0.5 * transport_.delay_ms;
  if (transport_.jitter_ms > 0.0) ms += 0.5 * transport_.jitter_ms * dice_.roll();
  return std::llround(ms * kSlicesPerMs);
}

void ClosedLoop::begin() noexcept {
  ++out_.tick;
  out_.from_mm = plant_.position_mm();
  out_.energy_mj = 0.0;
  out_.mean_n = Vec3(0.0);
  out_.answers = 0;
  out_.held_any = false;
  out_.over_limit = false;
  bool lost_up = unplugged_;
  if (transport_.lost_share > 0.0) lost_up = dice_.roll() < 0.5 * transport_.lost_share || lost_up;
  const std::int64_t arrives = now_ + one_way();
  if (!lost_up) up_.send(arrives, {read(0), read(1), read(2)});
}

bool ClosedLoop::receive(Reading& out) noexcept {
  if (now_ < stalled_until_ || up_.empty() || up_.arrives() > now_) return false;
  Sampled newest = up_.take();
  while (!up_.empty() && up_.arrives() <= now_) newest = up_.take();
  out.x = newest.x;
  out.y = newest.y;
  out.z = newest.z;
  out.elapsed_us = received_ < 0 ? 1000u : static_cast<std::uint32_t>((now_ - received_) * kSliceUs);
  received_ = now_;
  return true;
}

void ClosedLoop::answer(Vec3 wanted) noexcept {
  ++out_.answers;
  out_.wanted_n = wanted;
  const double square = glm::dot(wanted, wanted);
  const double most = device_.limit_n;
  Vec3 given = wanted;
  if (!(square <= most * most)) {  // NaN too
    out_.over_limit = true;
    given = std::isfinite(square) ? wanted * (most / std::sqrt(square)) : Vec3(0.0);
  }
  if (device_.force_quantum_n > 0.0)
    for (int a = 0; a < 3; ++a) given[a] = std::round(given[a] / device_.force_quantum_n) * device_.force_quantum_n;
  bool lost = unplugged_;
  if (transport_.lost_share > 0.0) lost = dice_.roll() < 0.5 * transport_.lost_share || lost;
  const std::int64_t arrives = now_ + one_way();
  if (!lost) down_.send(arrives, given);
}

void ClosedLoop::run(std::int64_t end) noexcept {
  while (!down_.empty() && down_.arrives() <= now_) held_ = down_.take();
  std::int64_t next = end;
  if (!down_.empty()) next = std::min(next, down_.arrives());
  if (!up_.empty()) next = std::min(next, std::max(up_.arrives(), stalled_until_));
  const auto slices = static_cast<int>(next - now_);
  const Vec3 before = plant_.position_mm();
  plant_.advance(held_, slices);
  now_ = next;
  out_.energy_mj += glm::dot(held_, plant_.position_mm() - before);
  out_.mean_n += held_ * (static_cast<double>(slices) / kSlicesPerTick);
  out_.held_any = out_.held_any || held_ != Vec3(0.0);
}

void ClosedLoop::finish() noexcept {
  out_.to_mm = plant_.position_mm();
  out_.velocity_mm_s = plant_.velocity_mm_s();
  out_.held_n = held_;
}

void ClosedLoop::stall_ms(double ms) noexcept {
  stalled_until_ = std::max<std::int64_t>(stalled_until_, now_ + std::llround(ms * kSlicesPerMs));
}

void ClosedLoop::unplug() noexcept {
  unplugged_ = true;
  while (!up_.empty()) up_.take();
  while (!down_.empty()) down_.take();
  held_ = Vec3(0.0);
}

}  // namespace cusp::engine::lab
