/// A Falcon on the bench, outside any exercise: opened, homed, watched, and put through trials. Runs on a thread of its
/// own, as real time as the platform lets it; the page looks on and asks. No Qt.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "device/falcon/emulated_body.h"
#include "device/falcon/trial.h"
#include "engine/loop/realtime.h"
#include "ui/modules.h"
#include "ui/session/session_device.h"

namespace cusp::ui {

enum class BenchPhase : std::uint8_t {
  opening,   // looking for it, loading, or homing: see falcon.session
  running,   // homed, exchanging: trials may start
  lost,      // was there, and is looked for by itself
  failed,    // open() failed; see `failure`; try again by a new bench
};

/// Plain values, about a thousand times a second.
struct BenchView {
  BenchPhase phase = BenchPhase::opening;
  FalconView falcon{};
  RealtimeGrant grant{};
  double answers_per_s = 0;     // over the last second
  double late_p50_us = 0, late_p99_us = 0, late_max_us = 0;  // readings after their millisecond, of the last second
  std::uint64_t silences = 0, lost_answers = 0;
  bool trial_runs = false;
  double trial_share = 0;
  int trial_step = 0;           // of what the trial counts: axes, pushes, places
  falcon::TrialEnd trial_end = falcon::TrialEnd::none;  // of the last one
  Vec3 force_n{0.0};            // that a trial asks for, device's frame
};

class DeviceBench {
 public:
  /// Begins at once. `choice.kind` "falcon", or "emulated-falcon": the driver over an emulated one with `body`, that an
  /// unseen hand homes.
  explicit DeviceBench(const DeviceChoice& choice, const falcon::EmulatedBodySettings& body = {});
  /// Force to zero, device given back. An upload under way is cancelled.
  ~DeviceBench();
  DeviceBench(const DeviceBench&) = delete;
  DeviceBench& operator=(const DeviceBench&) = delete;

  // One thread, the window's.
  const BenchView& view() noexcept;
  /// Why it failed; once phase is failed.
  std::optional<PortFailure> failure() const;
  /// Starts a trial while running and none is under way; false otherwise.
  bool start(std::unique_ptr<falcon::Trial> trial);
  void stop_trial() noexcept;
  /// The trial that is over, once.
  std::unique_ptr<falcon::Trial> take_trial();
  /// While no trial runs: Calibration::force_gain of what is pushed from now on.
  void set_force_gain(double gain) noexcept;
  /// falcon::control bits.
  void set_leds(std::uint8_t leds) noexcept;

 private:
  struct Inner;
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp::ui
