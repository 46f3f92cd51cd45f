/// What a running session shows: plain values for panels (LiveView), and the whole state for drawing (Observer).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "engine/base/vec.h"
#include "engine/loop/loop_stats.h"
#include "engine/loop/realtime.h"
#include "engine/loop/tick.h"
#include "engine/mirror/mirror.h"
#include "engine/volume/tissue.h"
#include "scenarios/metrics/live.h"
#include "storage/base/error.h"
#include "ui/modules.h"

namespace cusp::ui {

/// Called on the mirror's thread about every 10 ms of session time with the state and the bricks that changed: the place
/// to rebuild surface patches from (state.volume() is consistent for the length of the call). on_tick may stay as it is.
using Observer = MirrorObserver;

enum class RecordingState : std::uint8_t {
  off,        // a try-out or guest attempt: nothing is kept
  recording,
  behind,     // seconds wait in memory: a slow or full disk, or a locked file; nothing is lost yet
  failed,     // could not be written: the attempt is held, see LiveView::recording_failure
};

/// One copy of everything that panels and gauges show, about 40 times a second. Plain values.
struct LiveView {
  // The loop's newest tick (bur, force); read it at frame rate.
  StepOutput output;
  Quat orientation{1.0, 0.0, 0.0, 0.0};
  LoopPhase phase = LoopPhase::ready;
  LoopEnd end = LoopEnd::none;
  Fault fault = Fault::none;
  Sample::Status device = Sample::Status::fresh;
  bool silent = false;                  // no tick for a second: the device's driver stands still, paused or not; afterwards it is held
  bool cut_ignored = false;             // a cut is held that counts for nothing until it was released (held_cut.h)
  double push_n = 0;                    // length of the force before the guard
  double seconds = 0;                   // session time: stands still while paused
  bool time_is_up = false;              // the scenario's time limit is reached: the session is held for good

  // The mirror's newest state; `shown_tick` is its tick, `shown_seconds` its session time.
  std::uint64_t shown_tick = 0;
  double shown_seconds = 0;
  double target_removed_percent = 0;    // of the target's volume
  std::array<double, LiveReading::kMostTargets> removed_of_percent{};  // of each of several targets (asked_targets())
  double over_leeway_mm3 = 0;           // cut outside the target, within the leeway shell
  double over_beyond_mm3 = 0;           // cut beyond the leeway
  std::array<double, kTissueCodes> removed_mm3{};
  double depth_mm = 0;                  // deepest cut below the target's reference plane
  double bur_depth_mm = 0;              // tip of the bur below the same plane now; negative above it
  std::optional<double> over_pulp_mm;   // least dentine left between the cut and the pulp; nullopt: no pulp within reach
  bool pulp_exposed = false;
  double peak_push_n = 0;

  RecordingState recording = RecordingState::off;
  std::optional<StorageFailure> recording_failure;
  std::uint16_t wanted_bur = 0;         // output.bur is in use until the bur is in the air
  bool ring_warning = false;            // inputs wait: the machine is too slow for this exercise
  std::optional<Mismatch> mismatch;     // loop and mirror differ
  LoopTimes loop;
  RealtimeGrant grant;
  double ticks_per_s = 0;               // over the last second
};

}  // namespace cusp::ui
