#include "ui/session/play_through.h"

#include <chrono>
#include <thread>

#include "engine/loop/haptic_loop.h"
#include "engine/mirror/fragment_finder.h"
#include "ui/modules.h"
#include "ui/session/session_follower.h"
#include "ui/session/session_setup.h"

namespace cusp::ui {

namespace {

/// Waits until the record holds `due_us` of the session. False if it failed.
bool holds(const Recorder& recorder, std::uint64_t due_us) {
  while (recorder.stored_us() < due_us) {
    if (recorder.state() == RecordingState::failed) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return true;
}

/// Runs loop and mirror until the script ends, `go_on` refuses or the record fails.
SessionEnd run_script(VirtualLoop& loop, Mirror& mirror, const Recorder* recorder, const PlaySettings& settings) {
  // The mirror follows on the other core. Short turns and a short wait keep it within a fraction of a second of the session.
  constexpr std::uint64_t kTurn = 25;
  constexpr std::size_t kMostWaiting = 600;
  SessionEnd end = SessionEnd::script;
  std::uint64_t asked_at_s = 0;
  const std::uint64_t begun_us = loop.state().last().elapsed_us;
  // Between turns, not by the mirror: when a fragment is removed must not depend on threads.
  FragmentFinder finder(loop.hand_over());
  mirror.start();
  while (loop.run(kTurn) == kTurn) {
    finder.search(loop.state());
    while (loop.hand_over().inputs.size() > kMostWaiting) std::this_thread::sleep_for(std::chrono::microseconds(200));
    if (recorder && recorder->state() == RecordingState::failed) break;
    const std::uint64_t elapsed = loop.state().last().elapsed_us;
    if (settings.go_on && elapsed / 1'000'000 > asked_at_s) {
      asked_at_s = elapsed / 1'000'000;
      // go_on() reports a second. After a crash at most that second is missing.
      const std::uint64_t due_us = (asked_at_s - 1) * 1'000'000;
      if (recorder && due_us > begun_us && !holds(*recorder, due_us - begun_us)) break;
      if (!settings.go_on(elapsed)) {
        end = SessionEnd::stopped;
        break;
      }
    }
  }
  return end;
}

}  // namespace

Outcome<SessionResult> play_through(SessionPlan plan, HapticPort& port, const PlaySettings& settings) {
  if (auto opened = port.open(); !opened) return session_fail(SessionError::device, opened.error());
  auto made = set_up(plan, port.limits());
  if (!made) {
    port.close();
    return std::unexpected(made.error());
  }
  SessionSetup setup = std::move(*made);
  std::unique_ptr<Recorder> recorder;
  if (setup.store) {
    recorder = std::make_unique<Recorder>(std::move(setup.store), setup.session, Recorder::Writing::at_once);
  }
  // A script ends by itself: no time limit, nothing to hold.
  SessionFollower follower(setup.reference, *setup.mirror_start, {recorder.get(), setup.process, 0.0, {}, SessionFollower::Scores::for_the_record});
  VirtualLoop loop(port, std::move(*setup.loop_start));
  if (settings.elapsed_us) loop.take_elapsed_from(settings.elapsed_us);
  MirrorSettings mirror_settings;
  mirror_settings.show_every_us = settings.show_every_us;
  Mirror mirror(std::move(*setup.mirror_start), loop.hand_over(), mirror_settings);
  mirror.add(follower);
  for (Observer* observer : plan.observers) mirror.add(*observer);

  const SessionEnd end = run_script(loop, mirror, recorder.get(), settings);
  loop.ticker().end(LoopEnd::asked);
  mirror.stop();
  port.close();

  std::unique_ptr<Store> store;
  if (recorder) {
    if (!recorder->drain()) {
      const auto failure = recorder->failure();
      store = recorder->take_store();
      if (store) static_cast<void>(store->sessions.interrupt(setup.session, "recording_failed"));
      return failure ? session_fail(SessionError::recording_failed, *failure)
                     : session_fail(SessionError::recording_failed, plan.database.string());
    }
    store = recorder->take_store();
  }
  if (const auto mismatch = mirror.mismatch(); mismatch || loop.state().hash() != mirror.state().hash()) {
    if (store) static_cast<void>(store->sessions.interrupt(setup.session, "not_deterministic"));
    return session_fail(SessionError::not_deterministic, std::to_string(mismatch ? mismatch->tick : mirror.ticks()));
  }
  return conclude(plan, setup, store.get(), mirror.state(), follower.process(), end);
}

}  // namespace cusp::ui
