/// The haptic loop: one thread at 1 kHz that reads the device, runs the step and writes the force. The port paces it:
/// wait(deadline) returns at the deadline, or when a device with its own clock delivers.
/// No input is lost: the loop warns at three quarters of the ring. If the ring is full, it ends with zero force.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "engine/loop/loop_stats.h"
#include "engine/loop/realtime.h"
#include "engine/loop/tick.h"
#include "engine/loop/watchdog.h"

namespace cusp::engine {

struct LoopSettings {
  std::chrono::microseconds period{1000};
  std::size_t ring_inputs = 60'000;  // 60 s at 1 kHz, 32 bytes each
  bool ask_realtime = true;          // off in tests
};

class HapticLoop {
 public:
  /// Not on the haptic thread: takes all memory. `port` is open and outlives the loop.
  HapticLoop(HapticPort& port, StepState state, const LoopSettings& settings = {});
  ~HapticLoop();
  HapticLoop(const HapticLoop&) = delete;
  HapticLoop& operator=(const HapticLoop&) = delete;

  void start();
  /// Ends and joins the thread; the last force is zero. May be called twice.
  void stop();

  // Any thread.
  void pause() noexcept { ticker_.pause(); }
  void resume() noexcept { ticker_.resume(); }  // re-arms a latched guard, force ramps in
  void change_bur(std::uint16_t index) noexcept { ticker_.change_bur(index); }
  void set_coolant(bool on) noexcept { ticker_.set_coolant(on); }

  /// Rings and latest values; HandOver names their readers.
  HandOver& hand_over() noexcept { return hand_over_; }
  LoopTimes times() const noexcept { return times_of(stats_); }
  RealtimeGrant grant() const noexcept;
  /// Time since the loop last ticked.
  std::chrono::nanoseconds silence() const noexcept { return watchdog_.silence(Watchdog::Clock::now()); }

  /// After stop(): the final state.
  const StepState& state() const noexcept { return ticker_.state(); }

 private:
  void run() noexcept;

  HapticPort& port_;
  LoopSettings settings_;
  HandOver hand_over_;
  Ticker ticker_;
  LoopStats stats_;
  Watchdog watchdog_;
  std::atomic<bool> stop_{false};
  std::atomic<std::uint32_t> grant_;
  bool own_clock_;
  std::thread thread_;
};

/// The same ticks without a thread and without a clock, for `play` and tests. Each tick is `period` long. A `gone`
/// sample ends it if the port is over(); otherwise it is a tick, and the next tick re-arms. Thread: the caller's.
class VirtualLoop {
 public:
  VirtualLoop(HapticPort& port, StepState state, const LoopSettings& settings = {});
  /// Runs `ticks` ticks, fewer if the port ends or the ring is full. Returns their number.
  std::uint64_t run(std::uint64_t ticks) noexcept;
  /// Replaces `period` by a function that gives each tick's length, as a trace has it. Before run(); must not throw.
  void take_elapsed_from(std::function<std::uint32_t()> elapsed_us) { elapsed_us_ = std::move(elapsed_us); }
  Ticker& ticker() noexcept { return ticker_; }
  HandOver& hand_over() noexcept { return hand_over_; }
  const StepState& state() const noexcept { return ticker_.state(); }

 private:
  HapticPort& port_;
  LoopSettings settings_;
  HandOver hand_over_;
  Ticker ticker_;
  std::function<std::uint32_t()> elapsed_us_;
  std::chrono::steady_clock::time_point now_{};
};

}  // namespace cusp::engine
