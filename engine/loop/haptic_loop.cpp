#include "engine/loop/haptic_loop.h"

#include <algorithm>
#include <limits>

#include "engine/base/fp_guard.h"

namespace cusp::engine {

namespace {
using Clock = std::chrono::steady_clock;
/// Late samples that may come before a session's first tick, 2 ms each; after them the guard reports the device.
constexpr int kLateAtFirst = 50;

std::uint64_t ns_between(Clock::time_point from, Clock::time_point to) noexcept {
  return to > from ? static_cast<std::uint64_t>(std::chrono::nanoseconds(to - from).count()) : 0;
}

// A grant in one word, so that another thread never reads half of it: level, refusal, locked, priority, a byte each.
std::uint32_t packed(const RealtimeGrant& grant) noexcept {
  return static_cast<std::uint32_t>(grant.level) | static_cast<std::uint32_t>(grant.refusal) << 8 |
         (grant.memory_locked ? 1u << 16 : 0u) | static_cast<std::uint32_t>(grant.priority & 0xFF) << 24;
}
RealtimeGrant unpacked(std::uint32_t word) noexcept {
  return {static_cast<RealtimeLevel>(word & 0xFF), static_cast<RealtimeRefusal>(word >> 8 & 0xFF),
          static_cast<int>(word >> 24), (word >> 16 & 1) != 0};
}
}  // namespace

HapticLoop::HapticLoop(HapticPort& port, StepState state, const LoopSettings& settings)
    : port_(port),
      settings_(settings),
      hand_over_(settings.ring_inputs),
      ticker_(std::move(state), hand_over_),
      grant_(packed({})),
      own_clock_(port.limits().has_own_clock) {}

HapticLoop::~HapticLoop() { stop(); }

void HapticLoop::start() {
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
}

void HapticLoop::stop() {
  stop_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
}

RealtimeGrant HapticLoop::grant() const noexcept { return unpacked(grant_.load(std::memory_order_acquire)); }

void HapticLoop::run() noexcept {
  name_this_thread("cusp-haptic");
  const FpGuard fp;
  prefault_stack();
  if (settings_.ask_realtime) grant_.store(packed(ask_for_realtime()), std::memory_order_release);
  const Clock::time_point start = Clock::now();
  Clock::time_point deadline = start;
  std::uint64_t last_us = 0;
  int late_at_first = kLateAtFirst;  // still allowed; 0 once a sample has come
  while (!stop_.load(std::memory_order_acquire) && !ticker_.ended()) {
    // A device with its own clock delivers before this deadline; after two periods without a sample, it is late.
    deadline = own_clock_ ? Clock::now() + 2 * settings_.period : deadline + settings_.period;
    const Sample sample = port_.wait(deadline);
    Clock::time_point now = Clock::now();
    if (sample.status != Sample::Status::fresh && now < deadline) {
      std::this_thread::sleep_until(deadline);  // a lost device returns at once; the sleep keeps the pace
      now = Clock::now();
    }
    watchdog_.beat(now);
    const std::uint64_t us = ns_between(start, now) / 1000;
    const auto elapsed = std::clamp<std::uint64_t>(us - last_us, 1, std::numeric_limits<std::uint32_t>::max());
    last_us = us;
    // A late first sample names no position: the step would begin there, and the next sample would be a jump.
    late_at_first = sample.status == Sample::Status::late ? std::max(late_at_first - 1, 0) : 0;
    if (late_at_first > 0) continue;

    const std::uint64_t cpu = thread_cpu_ns();
    const Feedback feedback = ticker_.tick(sample, static_cast<std::uint32_t>(elapsed));
    stats_.tick_cpu.add_ns(thread_cpu_ns() - cpu);

    const Clock::time_point before_write = Clock::now();
    port_.write(feedback);
    const Clock::time_point after = Clock::now();
    stats_.exchange.add_ns(ns_between(before_write, after));
    if (!own_clock_) {
      stats_.late.add_ns(ns_between(deadline, now));
      // After a long tick the loop skips deadlines and does not run a burst.
      if (after > deadline + settings_.period) {
        const auto behind = (after - deadline) / settings_.period;
        stats_.missed.fetch_add(static_cast<std::uint64_t>(behind), std::memory_order_relaxed);
        deadline += behind * settings_.period;
      }
    }
  }
  ticker_.end(LoopEnd::asked);
  port_.write(ticker_.tick({}, 1));  // after the end every tick returns zero force
}

VirtualLoop::VirtualLoop(HapticPort& port, StepState state, const LoopSettings& settings)
    : port_(port), settings_(settings), hand_over_(settings.ring_inputs), ticker_(std::move(state), hand_over_) {
  ticker_.rearm_by_itself();
}

std::uint64_t VirtualLoop::run(std::uint64_t ticks) noexcept {
  const FpGuard fp;
  const auto period_us = static_cast<std::uint32_t>(settings_.period.count());
  std::uint64_t done = 0;
  while (done < ticks && !ticker_.ended()) {
    // Deadlines begin at the clock's epoch, long past, so a port that sleeps to its deadline does not sleep.
    now_ += settings_.period;
    const Sample sample = port_.wait(now_);
    if (sample.status == Sample::Status::gone && port_.over()) {
      ticker_.end(LoopEnd::port_over);
      break;
    }
    port_.write(ticker_.tick(sample, elapsed_us_ ? elapsed_us_() : period_us));
    if (!ticker_.ended()) ++done;
  }
  return done;
}

}  // namespace cusp::engine
