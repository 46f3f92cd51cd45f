// What a session does about its device.
#include <gtest/gtest.h>

#include "tests/modules.h"
#include "tests/ui/session/small_exercise.h"
#include "tests/ui/session/sticking_port.h"
#include "ui/session/exercise_session.h"
#include "ui/session/replay.h"

namespace cusp::test {
namespace {

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

}  // namespace
}  // namespace cusp::test
