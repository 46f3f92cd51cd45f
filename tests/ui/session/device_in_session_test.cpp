// What a session does about its device.
#include <gtest/gtest.h>

#include "tests/modules.h"
#include "tests/ui/session/small_exercise.h"
#include "tests/ui/session/sticking_port.h"
#include "ui/session/exercise_session.h"
#include "ui/session/replay.h"

namespace cusp::test {
namespace {

/// Senses so many axes of orientation: an Inverse3 with its handle, or without.
class TurningPort final : public DrillingPort {
 public:
  explicit TurningPort(int rotation_axes) : DrillingPort(1u << 30, Pace::to_deadline), rotation_axes_(rotation_axes) {}
  DeviceLimits limits() const override {
    DeviceLimits limits = DrillingPort::limits();
    limits.device_class = "inverse3";
    limits.rotation_axes = rotation_axes_;
    return limits;
  }

 private:
  int rotation_axes_;
};

/// Its button is down until the test releases it.
class ButtonPort final : public DrillingPort {
 public:
  ButtonPort() : DrillingPort(1u << 30, Pace::to_deadline) {}
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override {
    Sample sample = DrillingPort::wait(deadline);
    if (!pressed) sample.buttons = 0;
    return sample;
  }
  std::atomic<bool> pressed{true};
};

TEST(DeviceInSession, AButtonThatIsHeldOverAPauseCutsOnlyOnceItWasReleased) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.operator_name = kUserOperator;
  ButtonPort port;
  auto started = ExerciseSession::start(plan, port);
  ASSERT_TRUE(started);
  ExerciseSession& session = **started;
  const auto removed = [&] { return session.view().removed_mm3[index_of(Tissue::plastic)]; };
  const auto run_on = [&] {
    const std::uint64_t until = session.view().output.tick + 300;
    return eventually([&] { return session.view().shown_tick > until; });
  };
  ASSERT_TRUE(eventually([&] { return removed() > 0; }));
  EXPECT_FALSE(session.view().cut_ignored);
  session.pause();
  ASSERT_TRUE(eventually([&] { return session.view().phase == LoopPhase::paused; }));
  session.resume();
  ASSERT_TRUE(run_on());  // what was cut before the pause is shown
  const double before = removed();
  ASSERT_TRUE(run_on());
  EXPECT_EQ(removed(), before) << "its button is down since before the pause";
  EXPECT_TRUE(session.view().cut_ignored);
  port.pressed = false;
  ASSERT_TRUE(run_on());
  EXPECT_FALSE(session.view().cut_ignored);
  port.pressed = true;
  EXPECT_TRUE(eventually([&] { return removed() > before; }));
  const auto result = session.finish();
  ASSERT_TRUE(result);
  started->reset();
  EXPECT_TRUE(prove_session(*work.store(), result->session)->holds());
}

TEST(DeviceInSession, AfterItsDriverStoodStillTheSessionIsHeldAndItsClockLeavesThatTimeOut) {
  const Workplace work;
  const auto stuck = std::make_shared<std::atomic<bool>>(false);
  auto started = ExerciseSession::start(work.plan(), std::make_shared<StickingPort>(stuck));
  ASSERT_TRUE(started);
  ExerciseSession& session = **started;
  ASSERT_TRUE(eventually([&] { return session.view().seconds > 0.1; }));
  *stuck = true;
  ASSERT_TRUE(eventually([&] { return session.view().silent; }));
  const double at = session.view().seconds;
  *stuck = false;
  stuck->notify_all();
  ASSERT_TRUE(eventually([&] { return session.view().phase != LoopPhase::running && !session.view().silent; }));
  EXPECT_EQ(session.view().phase, LoopPhase::held);
  EXPECT_EQ(session.view().fault, Fault::late);
  EXPECT_LT(session.view().seconds, at + 0.5) << "it is silent after a whole second alone";
  session.resume();
  EXPECT_TRUE(eventually([&] { return session.view().seconds > at + 0.05; }));
  EXPECT_EQ(session.view().fault, Fault::none);
  session.pause();
  EXPECT_TRUE(eventually([&] { return session.view().phase == LoopPhase::paused; })) << "as somebody asked, not held";
  const auto result = session.finish();
  ASSERT_TRUE(result);
  started->reset();
  EXPECT_TRUE(prove_session(*work.store(), result->session)->holds());
}

TEST(DeviceInSession, AnInterruptedAttemptGoesOnOnlyWithADeviceThatSensesTheAxesItNeeds) {
  const Workplace work;
  SessionPlan plan = work.plan();
  plan.scenario.device.needs_dof = 6;
  SessionId session;
  {
    TurningPort port(3);
    auto started = ExerciseSession::start(plan, port);
    ASSERT_TRUE(started) << key_of(started.error().code) << ' ' << started.error().where << ' ' << started.error().detail;
    session = (*started)->session();
    ASSERT_TRUE(eventually([&] { return (*started)->view().seconds > 0; }));
  }
  plan.resumes = session;
  TurningPort without_handle(0);
  const auto refused = ExerciseSession::start(plan, without_handle);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, SessionError::device_axes);
  EXPECT_EQ(refused.error().where, "inverse3");
  EXPECT_EQ(refused.error().detail, "6");
  EXPECT_EQ(work.store()->sessions.state(session), SessionState::interrupted);
  TurningPort with_handle(3);
  EXPECT_TRUE(ExerciseSession::start(plan, with_handle));
}

}  // namespace
}  // namespace cusp::test
