#include "device/pointer/pointer_port.h"

#include <thread>

namespace cusp::device {

PointerPort::PointerPort(Vec3 start_mm, const PointerTuning& tuning)
    : hand_(start_mm), motion_(hand_.wish().target_mm, tuning) {
  feedback_.proxy_mm = motion_.device_mm();
}

Result<void, PortFailure> PointerPort::open() {
  open_ = true;
  has_before_ = false;
  return {};
}

Sample PointerPort::wait(std::chrono::steady_clock::time_point deadline) noexcept {
  std::this_thread::sleep_until(deadline);
  const double dt_s = has_before_ ? std::chrono::duration<double>(deadline - before_).count() : 0.0;
  before_ = deadline;
  has_before_ = true;
  const PointerWish& wish = hand_.latest();
  Sample sample;
  sample.status = open_ ? Sample::Status::fresh : Sample::Status::gone;
  sample.position_mm = motion_.advance(wish, feedback_, dt_s);
  sample.buttons = wish.cut ? 1 : 0;
  sample.pedal = wish.cut ? 65535 : 0;
  sample.bur = wish.bur;
  sample.orientation = wish.orientation;
  return sample;
}

void PointerPort::write(const Feedback& feedback) noexcept { feedback_ = feedback; }

DeviceLimits PointerPort::limits() const {
  DeviceLimits limits;
  limits.name = "Mouse and keys";
  limits.device_class = "pointer";
  limits.max_force_n = PointerHand::kMaxPushN;
  limits.max_stiffness_n_per_mm = 20.0;  // no hand stands in the loop: any stiffness a scenario may name
  limits.closed_loop = false;
  return limits;
}

void PointerPort::close() noexcept {
  open_ = false;
  feedback_ = Feedback{};
  feedback_.proxy_mm = motion_.device_mm();
}

}  // namespace cusp::device
