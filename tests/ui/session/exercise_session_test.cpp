#include "tests/modules.h"
#include "ui/session/exercise_session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <barrier>
#include <thread>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "storage/sqlite/database.h"
#include "tests/refused_rows.h"
#include "tests/ui/session/gate.h"
#include "tests/ui/session/small_exercise.h"
#include "tests/ui/session/sticking_port.h"
#include "ui/session/replay.h"

namespace cusp::test {
namespace {

using test::DrillingPort;
using test::eventually;
using test::Workplace;

class Counter final : public Observer {
 public:
  void on_state(const StepState& state, const StateNews& news) override {
    if (news.first) ++firsts;
    if (news.last) ++lasts;
    cut_bricks = state.volume().cut_bricks().size();
  }
  std::atomic<std::size_t> firsts{0}, lasts{0}, cut_bricks{0};
};

/// The mirror works through no input until the gate opens.
class Lagging final : public Observer {
 public:
  void on_tick(const StepInput&, const StepState&) override { gate.pass(); }
  void on_state(const StepState&, const StateNews&) override {}
  Gate gate;
};

/// Its driver comes back from open() when the gate opens.
class ShutPort final : public DrillingPort {
 public:
  ShutPort(std::shared_ptr<Gate> gate, std::shared_ptr<std::atomic<bool>> closed)
      : DrillingPort(1u << 30, Pace::to_deadline), gate_(std::move(gate)), closed_(std::move(closed)) {}
  Result<void, PortFailure> open() override {
    gate_->pass();
    return {};
  }
  void close() noexcept override { *closed_ = true; }

 private:
  std::shared_ptr<Gate> gate_;
  std::shared_ptr<std::atomic<bool>> closed_;
};

TEST(ExerciseSession, DrillsRecordsAndGradesWhatTheReplayConfirms) {
  const Workplace work;
  Counter counter;
  SessionPlan plan = work.plan();
  plan.observers = {&counter};
  DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
  auto started = ExerciseSession::start(plan, port);
  ASSERT_TRUE(started) << key_of(started.error().code) << ' ' << started.error().where << ' ' << started.error().detail;
  // Panels and gauges read all the while.
  ASSERT_TRUE(eventually([&] {
    const LiveView view = (*started)->view();
    return view.seconds > 1.2 && view.removed_mm3[index_of(Tissue::plastic)] > 0 && view.shown_tick > 0;
  }));
  const LiveView view = (*started)->view();
  EXPECT_EQ(view.phase, LoopPhase::running);
  EXPECT_EQ(view.recording, RecordingState::recording);
  EXPECT_FALSE(view.mismatch);
  EXPECT_GT(view.peak_push_n, 0.0);
  EXPECT_GT(view.depth_mm, 0.0);
  EXPECT_GT(view.loop.ticks, 0u);
  const auto result = (*started)->finish();
  ASSERT_TRUE(result) << key_of(result.error().code) << ' ' << result.error().where << ' ' << result.error().detail;
  EXPECT_EQ(counter.firsts, 1u);
  EXPECT_EQ(counter.lasts, 1u);
  EXPECT_EQ(counter.cut_bricks, result->volume->cut_bricks().size());
  EXPECT_EQ(port.last_force_n(), 0.0);
  EXPECT_FALSE((*started)->finish()) << "an attempt is finished once";
  started->reset();

  const auto store = work.store();
  const auto proof = prove_session(*store, result->session);
  ASSERT_TRUE(proof);
  EXPECT_TRUE(proof->holds());
  EXPECT_TRUE(proof->has_grade && proof->grade_equal && proof->volume_equal);
  const auto opened = open_result(*store, result->session);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->volume_hash, result->volume_hash);
  EXPECT_EQ(opened->grade.score, result->grade.score);
}

TEST(ExerciseSession, HoldsItselfAtTheTimeLimitAndIsGradedAsUsedUp) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.scenario.time_limit_s = 0.5;
  DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
  auto session = ExerciseSession::start(plan, port);
  ASSERT_TRUE(session);
  ASSERT_TRUE(eventually([&] { return (*session)->view().time_is_up && (*session)->view().phase == LoopPhase::paused; }));
  EXPECT_GE((*session)->view().seconds, 0.5);
  const double at = (*session)->view().seconds;
  (*session)->resume();
  const auto written = port.writes();
  ASSERT_TRUE(eventually([&] { return port.writes() > written + 30; }));
  EXPECT_EQ((*session)->view().phase, LoopPhase::paused) << "nobody resumes a session whose time is up";
  EXPECT_EQ((*session)->view().seconds, at);
  EXPECT_EQ(port.last_force_n(), 0.0);
  const auto result = (*session)->finish();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->seconds, at);
  EXPECT_FALSE(result->interrupted);
  const auto events = work.store()->sessions.events(result->session);
  ASSERT_TRUE(events);
  EXPECT_TRUE(std::ranges::any_of(*events, [](const SessionEvent& e) { return e.reason == "time_limit"; }));
}

TEST(ExerciseSession, HoldsItselfAtTheTimeLimitAlsoWhereItsMirrorLags) {
  const Workplace work;
  Lagging mirror;
  SessionPlan plan = work.plan();
  plan.scenario.time_limit_s = 0.5;
  plan.observers = {&mirror};
  DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
  auto session = ExerciseSession::start(plan, port);
  ASSERT_TRUE(session);
  EXPECT_TRUE(eventually([&] { return (*session)->view().time_is_up && (*session)->view().phase == LoopPhase::paused; }));
  EXPECT_FALSE(mirror.gate.gave_up()) << "the loop's own clock decides";
  const double at = (*session)->view().seconds;
  const auto written = port.writes();
  (*session)->resume();
  EXPECT_TRUE(eventually([&] { return port.writes() > written + 30; }));
  EXPECT_EQ((*session)->view().phase, LoopPhase::paused);
  EXPECT_EQ((*session)->view().shown_tick, 0u) << "the mirror has worked through nothing yet";
  mirror.gate.open();
  const auto result = (*session)->finish();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->seconds, at);
  const auto events = work.store()->sessions.events(result->session);
  ASSERT_TRUE(events);
  EXPECT_TRUE(std::ranges::any_of(*events, [](const SessionEvent& e) { return e.reason == "time_limit"; }));
}

TEST(ExerciseSession, HoldsItselfLaterForAStudentWithExtraTimeAlsoAfterResuming) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.scenario.time_limit_s = 0.5;
  {
    const auto store = work.store();
    const Actor administrator = store->accounts.create_first_administrator({"ada", "Ada", Role::administrator, "correct horse", ""})->actor();
    const Actor instructor = store->accounts.create(administrator, {"okafor", "Dr Okafor", Role::instructor, "battery staple", ""})->actor();
    const CohortId cohort = store->cohorts.create(instructor, "Year 2")->id;
    ASSERT_TRUE(store->cohorts.add(instructor, cohort, work.demo.id));
    const auto version = store->scenarios.publish(instructor, plan.scenario, canonical_json(plan.scenario), content_hash(plan.scenario).bytes);
    ASSERT_TRUE(version);
    plan.version = version->id;
    plan.assignment = store->assignments.create(instructor, {.version = version->id, .cohort = cohort})->id;
    ASSERT_TRUE(store->assignments.adjust(instructor, *plan.assignment, work.demo.id, {.extra_time_percent = 400}));
  }
  DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
  auto session = ExerciseSession::start(plan, port);
  ASSERT_TRUE(session);
  EXPECT_EQ((*session)->time_limit_s(), 2.5);
  ASSERT_TRUE(eventually([&] { return (*session)->view().seconds > 0.55; }));
  EXPECT_FALSE((*session)->view().time_is_up);
  const SessionId id = (*session)->session();
  (*session)->abandon();
  session->reset();
  SessionPlan again = work.plan();
  again.resumes = id;
  DrillingPort other(1u << 30, DrillingPort::Pace::to_deadline);
  auto resumed = ExerciseSession::start(again, other);
  ASSERT_TRUE(resumed);
  EXPECT_EQ((*resumed)->time_limit_s(), 2.5);
}

TEST(ExerciseSession, PausedItsClockStandsStill) {
  const Workplace work;
  DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
  auto started = ExerciseSession::start(work.plan(), port);
  ASSERT_TRUE(started);
  ASSERT_TRUE(eventually([&] { return (*started)->view().seconds > 0.1; }));
  (*started)->pause();
  ASSERT_TRUE(eventually([&] { return (*started)->view().phase == LoopPhase::paused; }));
  const double at = (*started)->view().seconds;
  const auto written = port.writes();
  ASSERT_TRUE(eventually([&] { return port.writes() > written + 30; }));
  EXPECT_EQ((*started)->view().seconds, at);
  EXPECT_EQ(port.last_force_n(), 0.0);
  (*started)->change_bur(1);
  (*started)->resume();
  EXPECT_TRUE(eventually([&] { return (*started)->view().seconds > at && (*started)->view().wanted_bur == 1; }));
  EXPECT_TRUE((*started)->finish());
}

TEST(ExerciseSession, WhoseDriverStandsStillIsInterruptedAndEndsWithoutIt) {
  const Workplace work;
  const auto stuck = std::make_shared<std::atomic<bool>>(false);
  auto port = std::make_shared<StickingPort>(stuck);
  const std::weak_ptr<HapticPort> device = port;
  auto started = ExerciseSession::start(work.plan(), std::move(port));
  ASSERT_TRUE(started);
  const SessionId session = (*started)->session();
  ASSERT_TRUE(eventually([&] { return (*started)->view().seconds > 1.2; }));
  *stuck = true;
  ASSERT_TRUE(eventually([&] { return (*started)->view().silent; }));
  const auto result = (*started)->finish();
  ASSERT_FALSE(result) << "its last inputs are still with the driver";
  EXPECT_EQ(result.error().code, SessionError::driver_silent);
  started->reset();
  EXPECT_FALSE(device.expired()) << "the haptic thread is in it";
  const auto store = work.store();
  EXPECT_EQ(store->sessions.state(session), SessionState::interrupted);
  EXPECT_TRUE(grade_session(*store, session, nullptr, Keep::nothing)) << "what was recorded is whole";
  *stuck = false;
  stuck->notify_all();
  EXPECT_TRUE(eventually([&] { return device.expired(); }));
}

TEST(ExerciseSession, OfWhichNothingIsKeptNamesADriverThatStandsStill) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.database.clear();
  plan.kind = SessionKind::try_it;
  const auto stuck = std::make_shared<std::atomic<bool>>(false);
  auto started = ExerciseSession::start(plan, std::make_shared<StickingPort>(stuck));
  ASSERT_TRUE(started);
  ASSERT_TRUE(eventually([&] { return (*started)->view().seconds > 0; }));
  *stuck = true;
  ASSERT_TRUE(eventually([&] { return (*started)->view().silent; }));
  const auto result = (*started)->finish();
  *stuck = false;
  stuck->notify_all();
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, SessionError::device);
  EXPECT_EQ(result.error().detail, kStandsStill);
}

TEST(ExerciseSession, WhoseDriverDoesNotOpenIsCalledOffWithoutIt) {
  const Workplace work;
  const auto gate = std::make_shared<Gate>();
  const auto closed = std::make_shared<std::atomic<bool>>(false);
  auto port = std::make_shared<ShutPort>(gate, closed);
  const std::weak_ptr<HapticPort> device = port;
  int asked = 0;
  const auto started = ExerciseSession::start(work.plan(), std::move(port), [&] { return ++asked > 3; });
  EXPECT_FALSE(gate->gave_up()) << "nobody waits for the driver";
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().code, SessionError::device);
  EXPECT_EQ(std::get<PortError>(started.error().cause), PortError::io);
  EXPECT_EQ(started.error().detail, kStandsStill);
  EXPECT_EQ(started.error().where, "Test device");
  EXPECT_FALSE(device.expired()) << "its thread is in it";
  EXPECT_FALSE(*closed);
  EXPECT_TRUE(work.store()->history.list(work.demo.actor())->empty());
  gate->open();
  EXPECT_TRUE(eventually([&] { return device.expired(); }));
  EXPECT_TRUE(*closed);
}

TEST(ExerciseSession, ThatCouldBeCalledOffAndWasNotBegins) {
  const Workplace work;
  const auto gate = std::make_shared<Gate>();
  gate->open();
  const auto started = ExerciseSession::start(work.plan(), std::make_shared<ShutPort>(gate, std::make_shared<std::atomic<bool>>(false)), [] { return false; });
  ASSERT_TRUE(started);
  EXPECT_TRUE(eventually([&] { return (*started)->view().seconds > 0; }));
}

/// An attempt that is left once something is cut.
SessionId left_after_cutting(const Workplace& work) {
  DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
  auto started = ExerciseSession::start(work.plan(), port);
  if (!started) {
    ADD_FAILURE() << "it does not start";
    return {};
  }
  EXPECT_TRUE(eventually([&] { return (*started)->view().removed_mm3[index_of(Tissue::plastic)] > 0; }));
  return (*started)->session();
}

TEST(ExerciseSession, LeftItIsInterruptedAndCanBeGradedOnceAsItStands) {
  const Workplace work;
  const SessionId session = left_after_cutting(work);
  const auto store = work.store();
  EXPECT_EQ(store->sessions.state(session), SessionState::interrupted);
  const auto graded = grade_session(*store, session, nullptr, Keep::grade);
  ASSERT_TRUE(graded) << key_of(graded.error().code) << graded.error().where;
  EXPECT_TRUE(graded->interrupted);
  EXPECT_TRUE(store->traces.final_volume(session)->has_value());
  const auto proof = prove_session(*store, session);
  EXPECT_TRUE(proof->holds());
  EXPECT_TRUE(proof->has_grade && proof->grade_equal);
}

TEST(ExerciseSession, LeftItKeepsWhatItCouldNotWriteBeforeIfItCanByNow) {
  const Workplace work;
  DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
  auto started = ExerciseSession::start(work.plan(), port);
  ASSERT_TRUE(started);
  const SessionId session = (*started)->session();
  auto database = storage::Database::open(work.database());
  ASSERT_TRUE(database);
  // From the third second on.
  ASSERT_TRUE(refuse_rows(*database, "trace_chunks", "row <= 1"));
  ASSERT_TRUE(eventually([&] { return (*started)->view().recording == RecordingState::failed && (*started)->view().phase == LoopPhase::paused; }));
  ASSERT_TRUE(take_rows(*database, "trace_chunks"));
  (*started)->abandon();
  const double seconds = (*started)->view().seconds;
  started->reset();
  const auto store = work.store();
  const auto opened = open_session(*store, session);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->state, SessionState::interrupted);
  EXPECT_DOUBLE_EQ(static_cast<double>(opened->elapsed_us) * 1e-6, seconds) << "every second is kept";
  EXPECT_TRUE(prove_session(*store, session)->holds());
}

TEST(ExerciseSession, LeftAndGradedAtTwoDesksAtOnceItKeepsOneGrade) {
  const Workplace work;
  const SessionId session = left_after_cutting(work);
  std::barrier together(2);
  const auto open_it = [&] {
    const auto store = work.store();
    together.arrive_and_wait();
    const auto result = open_result(*store, session, Keep::grade);
    ASSERT_TRUE(result) << key_of(result.error().code) << result.error().where;
    EXPECT_TRUE(result->interrupted);
  };
  std::thread other(open_it);
  open_it();
  other.join();
  EXPECT_EQ(work.store()->grades.all(session)->size(), 1u);
  EXPECT_TRUE(prove_session(*work.store(), session)->holds());
}

TEST(ExerciseSession, AnInterruptedAttemptGoesOnWithItsToothAndItsClock) {
  const Workplace work;
  SessionId session;
  double before = 0, taken = 0;
  {
    DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
    auto started = ExerciseSession::start(work.plan(), port);
    ASSERT_TRUE(started);
    session = (*started)->session();
    ASSERT_TRUE(eventually([&] { return (*started)->view().removed_mm3[index_of(Tissue::plastic)] > 0; }));
    (*started)->abandon();
    before = (*started)->view().seconds;
    taken = (*started)->view().removed_mm3[index_of(Tissue::plastic)];
  }
  SessionPlan plan = work.plan();
  plan.resumes = session;
  DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
  auto started = ExerciseSession::start(plan, port);
  ASSERT_TRUE(started) << key_of(started.error().code) << ' ' << started.error().where << ' ' << started.error().detail;
  EXPECT_EQ((*started)->session(), session);
  // It waits for the operator, whose hand is elsewhere than the record ends.
  ASSERT_TRUE(eventually([&] { return (*started)->view().phase == LoopPhase::paused; }));
  EXPECT_EQ((*started)->view().fault, Fault::none);
  (*started)->resume();
  ASSERT_TRUE(eventually([&] { return (*started)->view().seconds > before + 0.05; }));
  EXPECT_EQ((*started)->view().fault, Fault::none);
  EXPECT_TRUE(eventually([&] { return (*started)->view().removed_mm3[index_of(Tissue::plastic)] >= taken; }));
  const auto result = (*started)->finish();
  ASSERT_TRUE(result) << key_of(result.error().code) << ' ' << result.error().where << ' ' << result.error().detail;
  const auto store = work.store();
  const auto proof = prove_session(*store, session);
  ASSERT_TRUE(proof);
  EXPECT_TRUE(proof->holds());
  EXPECT_TRUE(proof->grade_equal);
  EXPECT_FALSE(proof->differs_at_tick);
}

TEST(ExerciseSession, APortThatDoesNotOpenLeavesNoSession) {
  class Absent final : public HapticPort {
   public:
    Result<void, PortFailure> open() override { return fail(PortError::not_found, "falcon"); }
    Sample wait(std::chrono::steady_clock::time_point) noexcept override { return {}; }
    void write(const Feedback&) noexcept override {}
    DeviceLimits limits() const override { return {}; }
    void close() noexcept override {}
  };
  const Workplace work;
  Absent port;
  const auto started = ExerciseSession::start(work.plan(), port);
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().code, SessionError::device);
  EXPECT_EQ(std::get<PortError>(started.error().cause), PortError::not_found);
  EXPECT_TRUE(work.store()->history.list(work.demo.actor())->empty());
}

}  // namespace
}  // namespace cusp::test
