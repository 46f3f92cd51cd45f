/// A scripted attempt in virtual time, as fast as the processor goes: the same ticks, mirror, recorder and grade as a live one.
/// Thread: the caller's plays, the mirror has its own; observers are called on that one. `cusp play`, the editor's "check with the expert".
#pragma once

#include <cstdint>
#include <functional>

#include "ui/session/exercise_session.h"

namespace cusp::ui {

struct PlaySettings {
  std::function<std::uint32_t()> elapsed_us;            // length of the next tick; empty: 1 ms each
  std::function<bool(std::uint64_t elapsed_us)> go_on;  // each second of the session; false ends it as interrupted
  std::uint32_t show_every_us = 1'000'000;              // how often observers see the state
};

/// Runs until the port has no more samples. Writes each second as it is played: what was played before a crash is there.
Outcome<SessionResult> play_through(SessionPlan plan, HapticPort& port, const PlaySettings& settings = {});

}  // namespace cusp::ui
