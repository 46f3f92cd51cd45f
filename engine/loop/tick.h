/// One tick of an exercise, the same in the live loop and in virtual time: quantise, store the input, step, publish.
/// The constructor takes all memory; tick() has no heap, no lock and no I/O.
#pragma once

#include <atomic>
#include <cstdint>

#include "engine/base/haptic_port.h"
#include "engine/base/spsc_ring.h"
#include "engine/base/triple_buffer.h"
#include "engine/loop/running_digest.h"
#include "engine/step/step.h"

namespace cusp::engine {

enum class LoopPhase : std::uint8_t {
  ready,  // made, not started
  running,
  paused,  // by pause(): force zero, clock stopped, nothing is recorded
  held,    // the guard latched or the device is lost: as paused, and resume() re-arms
  ended,
};

enum class LoopEnd : std::uint8_t {
  none,
  asked,      // stop()
  port_over,  // virtual time: the scripted port has no more samples
  ring_full,  // the mirror did not take inputs off in time: force zero, the session is interrupted
};

/// The newest state of the loop, for a screen. Plain values.
struct LoopLatest {
  StepOutput output;
  Vec3 contact_normal{0.0, 0.0, 1.0};
  Quat orientation{1.0, 0.0, 0.0, 0.0};  // of the device, for ports with rotation
  LoopPhase phase = LoopPhase::ready;
  LoopEnd end = LoopEnd::none;
  Fault fault = Fault::none;
  Sample::Status device = Sample::Status::fresh;
  std::uint16_t wanted_bur = 0;          // output.bur has the one in use
  bool ring_warning = false;             // three quarters of the input ring are waiting
};

/// Queues between the tick and other threads. The tick fills each ring and the mirror empties it, unless a comment
/// names others.
struct HandOver {
  explicit HandOver(std::size_t ring_inputs) : inputs(ring_inputs), marks(256), fragments(64) {}
  SpscRing<StepInput> inputs;       // every input that was stepped, in order
  SpscRing<DigestMark> marks;       // one a second of ticks; dropped if full: the next one covers it
  SpscRing<std::uint32_t> fragments;   // to the tick: names of severed fragments (voxel_name()), from one thread
  TripleBuffer<LoopLatest> latest;  // reader: one screen thread
  std::atomic<LoopPhase> phase{LoopPhase::ready};
  std::atomic<LoopEnd> end{LoopEnd::none};
  std::atomic<std::uint64_t> ticks{0};
};

class Ticker {
 public:
  /// Not on the haptic thread. `hand_over` outlives the ticker.
  Ticker(StepState state, HandOver& hand_over);

  /// Haptic thread. Runs the step on the sample and returns the port's feedback. While paused or held the force is zero
  /// at the last proxy, and nothing is stored. After the end the force is zero. Feedback::bur names the bur that was wanted last.
  Feedback tick(const Sample& sample, std::uint32_t elapsed_us) noexcept;
  /// Haptic thread. Publishes the end. Later ticks return zero force.
  void end(LoopEnd why) noexcept;
  bool ended() const noexcept { return phase_ == LoopPhase::ended; }
  LoopPhase phase() const noexcept { return phase_; }

  // Any thread. The next tick takes the last request. The later of change_bur() and the port's own choice wins.
  void pause() noexcept { want_.store(Want::pause, std::memory_order_release); }
  void resume() noexcept { want_.store(Want::resume, std::memory_order_release); }
  void change_bur(std::uint16_t index) noexcept { want_bur_.store(index, std::memory_order_release); }
  /// Coolant on or off; off at the start. The device's own button turns it on, too.
  void set_coolant(bool on) noexcept { coolant_.store(on, std::memory_order_release); }
  /// Virtual time: a latched guard is re-armed by the next tick instead of holding. Before the first tick.
  void rearm_by_itself() noexcept { rearm_by_itself_ = true; }

  /// The loop's own state; only where no tick can run.
  const StepState& state() const noexcept { return state_; }

 private:
  enum class Want : std::uint8_t { nothing, pause, resume };
  /// Takes pause, resume and bur requests. port_bur: the bur that the sample asks for.
  void take_requests(std::uint16_t port_bur) noexcept;
  StepInput input_of(const Sample& sample, std::uint32_t elapsed_us) noexcept;
  void add_digest() noexcept;
  void publish(Sample::Status device) noexcept;
  Feedback zero_force() const noexcept;
  /// StepInput::fragment of the next input: a name's first half, then its second; 0: none.
  std::uint16_t fragment_name_half() noexcept;

  static constexpr std::uint32_t kNoBur = 0xFFFFFFFF;
  StepState state_;
  HandOver& hand_over_;
  StepInput last_input_;
  StepOutput output_;
  RunningDigest digest_;
  Vec3 normal_{0.0, 0.0, 1.0};
  Quat orientation_{1.0, 0.0, 0.0, 0.0};
  double softest_n_per_mm_ = 1.0;
  std::uint16_t bur_ = 0;
  std::uint16_t port_bur_ = 0;
  std::uint16_t second_half_ = 0;  // of a name, still to be sent; 0: none
  LoopPhase phase_ = LoopPhase::ready;
  LoopEnd end_ = LoopEnd::none;
  bool rearm_ = false;
  bool rearm_by_itself_ = false;
  std::atomic<Want> want_{Want::nothing};
  std::atomic<std::uint32_t> want_bur_{kNoBur};
  std::atomic<bool> coolant_{false};
};

}  // namespace cusp::engine
