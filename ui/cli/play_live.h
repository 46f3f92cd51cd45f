/// `cusp play --device`: an attempt in real time on a device, without a window. The emulated Falcon is led by a scripted operator,
/// a real one by whoever holds it.
#pragma once

#include <csignal>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "ui/session/exercise_session.h"
#include "ui/session/session_device.h"

namespace cusp::ui {

struct LiveOptions {
  std::string script;          // of the operator of the emulated Falcon; repeated until `seconds`
  std::uint64_t seed = 1;
  double seconds = 0;          // of session time; 0: until the operator has finished or is stopped
  double silence_every_s = 0;  // the emulated Falcon answers nothing for 50 ms so often; 0: never
  bool progress = false;
};

/// What a live attempt was like, for --json.
struct LiveFigures {
  LoopTimes loop;
  RealtimeGrant grant;
  double wall_s = 0;
  double tick_max_at_s = 0;     // session time, within a twentieth of a second
  int holds = 0;                // the loop held because the device was lost, and went on by itself
  std::uint64_t silences = 0, lost_answers = 0, answers = 0;
  std::uint64_t stale_answers = 0, dropped_answers = 0;  // too old; flawed, asked for by nothing, or at a place not believed
};
nlohmann::ordered_json to_json(const LiveFigures& figures);

/// Whether such a device can be played on without a window.
bool can_play_live(const DeviceChoice& choice) noexcept;
/// `choice` of the station; `stop` is looked at twenty times a second. An opening driver that shows no life for two minutes, or that
/// does not come back within 3 s after `stop`, fails (device, kStandsStill).
Outcome<SessionResult> play_live(SessionPlan plan, const DeviceChoice& choice, const LiveOptions& options,
                         const std::function<bool()>& stop, LiveFigures& figures);

}  // namespace cusp::ui
