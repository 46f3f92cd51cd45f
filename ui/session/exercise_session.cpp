#include "ui/session/exercise_session.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "engine/loop/haptic_loop.h"
#include "engine/loop/realtime.h"
#include "engine/mirror/fragment_finder.h"
#include "ui/modules.h"
#include "ui/session/bur_depth.h"
#include "ui/session/session_follower.h"
#include "ui/session/session_setup.h"
#include "ui/session/watching_port.h"

namespace cusp::ui {

namespace {
// Of session time. A frame takes some 30 ms under software OpenGL: what it shows is then a third of one old at most.
constexpr std::uint32_t kShowUs = 10'000;
/// At the end of a session, or of an opening that was called off. A tick takes some ms even on a machine that is far too slow.
constexpr std::chrono::seconds kDriverPatience{3};
constexpr std::chrono::milliseconds kOpeningLook{5};

/// Shared by whoever waits for a port to open and the thread that opens it.
struct Opening {
  std::atomic<bool> settled{false};  // the first to set it decides: the port is open, or it was given up
  std::promise<Result<void, PortFailure>> opened;
};

/// Opens the port. If that can be called off, the thread "cusp-driver" opens it: once it is called off and the driver has not come back
/// within kDriverPatience, this thread keeps the port, and closes it when the driver comes back. It ends with the process at the latest.
Result<void, PortFailure> open_port(const std::shared_ptr<HapticPort>& port, const std::function<bool()>& called_off) {
  if (!called_off || port.use_count() == 0) return port->open();  // not owned: the port may go with the caller
  const std::string name = port->limits().name;
  const auto opening = std::make_shared<Opening>();
  auto opened = opening->opened.get_future();
  std::thread driver([port, opening] {
    name_this_thread("cusp-driver");
    auto result = port->open();
    if (!opening->settled.exchange(true)) return opening->opened.set_value(std::move(result));
    if (result) port->close();
  });
  std::optional<std::chrono::steady_clock::time_point> until;
  while (opened.wait_for(kOpeningLook) != std::future_status::ready) {
    const auto now = std::chrono::steady_clock::now();
    if (!until && called_off()) until = now + kDriverPatience;
    if (!until || now < *until || opening->settled.exchange(true)) continue;
    driver.detach();
    return fail(PortError::io, name, std::string(kStandsStill));
  }
  driver.join();
  return opened.get();
}
}  // namespace

struct ExerciseSession::Inner {
  /// What the haptic thread uses. A driver that does not come back keeps it beyond the session.
  struct Driven {
    Driven(std::shared_ptr<HapticPort> device_port, const SessionPlan& plan, StepState start)
        : port(std::move(device_port)),
          watching(*port, plan.pedal, plan.operator_name == kUserOperator ? std::optional(HeldCut()) : std::nullopt),
          loop(watching, std::move(start)) {
      watching.watch(loop);
    }

    std::shared_ptr<HapticPort> port;
    WatchingPort watching;  // what the loop reads
    HapticLoop loop;

    void end() {
      loop.stop();
      port->close();
    }
  };

  /// Ends the loop and closes the port. False if the driver has not come back within kDriverPatience. Then the thread "cusp-haptic"
  /// stays in the driver and "cusp-driver" waits for it: when the driver comes back, they close the port and free what they hold.
  /// If the program ends before, both end with the process.
  static bool end_within_patience(const std::shared_ptr<Driven>& driven) {
    if (driven->port.use_count() == 0) {  // not owned: the port may go with the session
      driven->end();
      return true;
    }
    std::promise<void> came_back;
    const auto ended = came_back.get_future();
    std::thread waiting([driven, came_back = std::move(came_back)]() mutable {
      name_this_thread("cusp-driver");
      driven->end();
      came_back.set_value();
    });
    if (ended.wait_for(kDriverPatience) != std::future_status::ready) {
      waiting.detach();
      return false;
    }
    waiting.join();
    return true;
  }

  Inner(SessionPlan p, SessionSetup s) : plan(std::move(p)), setup(std::move(s)) {}

  SessionPlan plan;
  SessionSetup setup;
  std::unique_ptr<Recorder> recorder;
  std::shared_ptr<Driven> driven;
  std::unique_ptr<Mirror> mirror;
  std::unique_ptr<SessionFollower> follower;
  std::unique_ptr<FragmentFinder> fragments;
  std::unique_ptr<Store> store;  // back from the recorder, once all is written
  bool stopped = false, over = false;
  bool stands_still = false;  // the driver did not come back: the haptic thread still has the loop's state

  // For ticks_per_s; the window's thread only.
  std::chrono::steady_clock::time_point rate_at{};
  std::uint64_t rate_ticks = 0;
  double ticks_per_s = 0;

  HapticLoop& loop() const { return driven->loop; }

  /// By the loop's own clock: on a slow machine the mirror lags behind it, and the follower hears of the limit too late.
  bool time_is_up(const LoopLatest& latest) const {
    const double limit_us = setup.time_limit_s * 1e6;
    if (limit_us > 0 && static_cast<double>(latest.output.elapsed_us) >= limit_us) return true;
    return follower->time_is_up();
  }

  /// Loop, then mirror: every input of the loop is worked through. A driver that stands still gives none.
  void stop() {
    if (stopped) return;
    stopped = true;
    stands_still = !end_within_patience(driven);
    mirror->stop();
  }
  SessionEnd end() const {
    if (loop().hand_over().end.load() == LoopEnd::ring_full) return SessionEnd::recorder_full;
    return follower->time_is_up() ? SessionEnd::time_limit : SessionEnd::student;
  }
};

ExerciseSession::ExerciseSession(std::unique_ptr<Inner> inner) : inner_(std::move(inner)) {}

ExerciseSession::~ExerciseSession() {
  if (inner_) abandon();
}

Outcome<std::unique_ptr<ExerciseSession>> ExerciseSession::start(SessionPlan plan, HapticPort& port) {
  return start(std::move(plan), std::shared_ptr<HapticPort>(std::shared_ptr<void>(), &port));
}

Outcome<std::unique_ptr<ExerciseSession>> ExerciseSession::start(SessionPlan plan, std::shared_ptr<HapticPort> port,
                                                                 const std::function<bool()>& called_off) {
  if (auto opened = open_port(port, called_off); !opened) return session_fail(SessionError::device, opened.error());
  auto setup = set_up(plan, port->limits(), called_off);
  if (!setup) {
    port->close();
    return std::unexpected(setup.error());
  }
  auto inner = std::make_unique<Inner>(std::move(plan), std::move(*setup));
  Inner& in = *inner;
  if (in.setup.store) {
    in.recorder = std::make_unique<Recorder>(std::move(in.setup.store), in.setup.session, Recorder::Writing::on_a_thread);
  }
  in.follower = std::make_unique<SessionFollower>(
      in.setup.reference, *in.setup.mirror_start,
      SessionFollower::Settings{in.recorder.get(), in.setup.process, in.setup.time_limit_s,
                                [&in] { in.loop().pause(); }});
  in.driven = std::make_shared<Inner::Driven>(std::move(port), in.plan, std::move(*in.setup.loop_start));
  in.mirror = std::make_unique<Mirror>(std::move(*in.setup.mirror_start), in.loop().hand_over(),
                                        MirrorSettings{.show_every_us = kShowUs});
  in.setup.loop_start.reset();
  in.setup.mirror_start.reset();
  // The picture before the scores.
  for (Observer* observer : in.plan.observers) in.mirror->add(*observer);
  in.mirror->add(*in.follower);
  in.fragments = std::make_unique<FragmentFinder>(in.loop().hand_over());
  in.mirror->add(*in.fragments);
  in.rate_at = std::chrono::steady_clock::now();
  in.mirror->start();
  // Who continues holds the bur elsewhere than the record ends: the guard would call that a jump. resume() re-arms it.
  if (!in.plan.resumes.is_nil()) in.loop().pause();
  in.loop().start();
  return std::unique_ptr<ExerciseSession>(new ExerciseSession(std::move(inner)));
}

void ExerciseSession::pause() { inner_->loop().pause(); }

void ExerciseSession::set_idle(bool on) { inner_->driven->watching.set_idle(on); }

void ExerciseSession::resume() {
  if (inner_->time_is_up(inner_->loop().hand_over().latest.read())) return;
  if (inner_->recorder && inner_->recorder->state() == RecordingState::failed) inner_->recorder->retry();
  inner_->loop().resume();
}

void ExerciseSession::change_bur(std::size_t index) {
  if (index < inner_->setup.scene->burs.size()) inner_->loop().change_bur(static_cast<std::uint16_t>(index));
}

void ExerciseSession::set_coolant(bool on) { inner_->loop().set_coolant(on); }

Outcome<SessionResult> ExerciseSession::finish(const MeasureProgress& progress) {
  Inner& in = *inner_;
  if (in.over) return session_fail(SessionError::wrong_state, in.setup.session.text());
  in.stop();
  if (in.stands_still) {
    abandon();
    if (in.setup.session.is_nil()) return session_fail(SessionError::device, PortFailure{PortError::io, in.setup.device.name, std::string(kStandsStill)});
    return session_fail(SessionError::driver_silent, in.setup.device.name);
  }
  if (in.recorder) {
    if (in.recorder->state() == RecordingState::failed) in.recorder->retry();
    if (!in.recorder->drain()) {
      const auto failure = in.recorder->failure();
      return failure ? session_fail(SessionError::recording_failed, *failure)
                     : session_fail(SessionError::recording_failed, in.plan.database.string());
    }
    in.store = in.recorder->take_store();
    in.recorder.reset();
  }
  const bool differs = in.mirror->mismatch() || in.loop().state().hash() != in.mirror->state().hash();
  if (differs) {
    in.over = true;
    const auto mismatch = in.mirror->mismatch();
    const std::uint64_t tick = mismatch ? mismatch->tick : in.mirror->ticks();
    // Kept as it was recorded, for whoever looks into it; a grade of it would be of a volume that nobody felt.
    if (in.store) static_cast<void>(in.store->sessions.interrupt(in.setup.session, "not_deterministic"));
    return session_fail(SessionError::not_deterministic, std::to_string(tick));
  }
  auto result = conclude(in.plan, in.setup, in.store.get(), in.mirror->state(), in.follower->process(), in.end(), progress);
  if (result || result.error().code != SessionError::recording_failed) in.over = true;
  return result;
}

bool ExerciseSession::abandon() {
  Inner& in = *inner_;
  in.stop();
  if (in.over) return true;
  in.over = true;
  if (in.recorder) {
    // What could not be written may be written by now: it is tried once more.
    if (in.recorder->state() == RecordingState::failed) in.recorder->retry();
    in.recorder->drain();
    in.store = in.recorder->take_store();
    in.recorder.reset();
  }
  const bool marked = !in.store || in.store->sessions.interrupt(in.setup.session, "left").has_value();
  in.store.reset();
  return marked;
}

LiveView ExerciseSession::view() const {
  Inner& in = *inner_;
  LiveView view;
  const LoopLatest& latest = in.loop().hand_over().latest.read();
  view.output = latest.output;
  view.orientation = latest.orientation;
  view.phase = latest.phase;
  view.end = latest.end;
  view.fault = latest.fault;
  if (view.phase == LoopPhase::paused && in.driven->watching.stalled()) {
    view.phase = LoopPhase::held;
    view.fault = Fault::late;
  }
  view.device = latest.device;
  view.cut_ignored = in.driven->watching.ignores_cut();
  const bool alive = latest.phase != LoopPhase::ready && latest.phase != LoopPhase::ended;
  view.silent = alive && in.loop().silence() > kSilent;
  view.wanted_bur = latest.wanted_bur;
  view.ring_warning = latest.ring_warning;
  view.push_n = glm::length(latest.output.force_raw_n);
  view.seconds = static_cast<double>(latest.output.elapsed_us) * 1e-6;

  const FollowedView followed = in.follower->view();
  const LiveReading& scores = followed.scores;
  const auto over = [&scores](Place place) { return scores.overcut_mm3[static_cast<std::size_t>(place)]; };
  view.time_is_up = in.time_is_up(latest);
  if (view.time_is_up && view.phase == LoopPhase::running) in.loop().pause();
  view.shown_tick = followed.tick;
  view.shown_seconds = static_cast<double>(followed.elapsed_us) * 1e-6;
  view.target_removed_percent = scores.target_measured ? scores.target_removed : 0.0;
  if (scores.target_measured) view.removed_of_percent = scores.removed_of;
  view.over_leeway_mm3 = over(Place::tolerated_floor) + over(Place::tolerated_side);
  view.over_beyond_mm3 = over(Place::beyond_floor) + over(Place::beyond_side);
  view.removed_mm3 = scores.removed_mm3;
  view.depth_mm = followed.deepest_mm;
  view.over_pulp_mm = scores.remaining_over_pulp_mm;
  view.pulp_exposed = scores.pulp_exposed;
  view.peak_push_n = followed.peak_push_n;
  const auto& burs = in.setup.scene->burs;
  const Bur& bur = burs[std::min<std::size_t>(latest.output.bur, burs.size() - 1)];
  view.bur_depth_mm = bur_depth_mm(in.setup.reference->shape(), latest.output, bur);

  if (in.recorder) {
    view.recording = in.recorder->state();
    view.recording_failure = in.recorder->failure();
  }
  view.mismatch = in.mirror->mismatch();
  view.loop = in.loop().times();
  view.grant = in.loop().grant();
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double> since = now - in.rate_at;
  if (since.count() >= 1.0) {
    in.ticks_per_s = static_cast<double>(view.loop.ticks - in.rate_ticks) / since.count();
    in.rate_ticks = view.loop.ticks;
    in.rate_at = now;
  }
  view.ticks_per_s = in.ticks_per_s;
  return view;
}

SessionId ExerciseSession::session() const { return inner_->setup.session; }
const Scenario& ExerciseSession::scenario() const { return inner_->plan.scenario; }
const std::shared_ptr<const Scene>& ExerciseSession::scene() const { return inner_->setup.scene; }
const std::shared_ptr<const Reference>& ExerciseSession::reference() const { return inner_->setup.reference; }
DeviceLimits ExerciseSession::device() const { return inner_->setup.device; }
double ExerciseSession::stiffness_share() const { return inner_->setup.stiffness_share; }
double ExerciseSession::time_limit_s() const { return inner_->setup.time_limit_s; }

}  // namespace cusp::ui
