#include "tests/bench/carved_truth.h"

#include "tests/bench/frame.h"

namespace cusp::bench {

namespace {
constexpr double kFreeMm = 1e-9;
constexpr double kCarvedVanishedMm = 0.05;  // mm: more than a sub-step moves along a surface
}  // namespace

Vec3 CarvedTruth::place(Vec3 centre) {
  y_ = centre;
  return centre;
}

void CarvedTruth::start(Vec3 centre) {
  Truth::start(centre);
  begin_ = device_ = centre;
  done_ = 0;
  memory_->running = nullptr;
}

Exact CarvedTruth::follow(Vec3 device) {
  if (done_ == 0) memory_->running = &memory_->from(begin_, device);
  std::vector<CarvedMemory::Tick>& run = *memory_->running;
  if (done_ >= run.size() || run[done_].device != device) {
    // The last tick's pose is the whole state, so the path continues from it.
    run.resize(done_);
    CarvedMemory::Tick tick;
    tick.device = device;
    for (int k = 1; k <= kSubSteps; ++k) {
      const Exact now =
          move_to(device_ + (device - device_) * (static_cast<double>(k) / kSubSteps), k < kSubSteps ? kCoarse : kFine);
      tick.exact.pose_mm = now.pose_mm;
      tick.exact.contact = now.contact;
      tick.exact.vanished = tick.exact.vanished || now.vanished;
    }
    run.push_back(tick);
  }
  const Exact exact = run[done_++].exact;
  y_ = exact.pose_mm;
  device_ = device;
  keep(exact);
  return exact;
}

Exact CarvedTruth::move_to(Vec3 device, double precision_mm) {
  const Vec3 before = y_;
  y_ = block_->settle(y_, device, precision_mm);
  return {y_, length(y_ - device) > kFreeMm, length(y_ - before) > kCarvedVanishedMm + length(device - device_)};
}

}  // namespace cusp::bench
