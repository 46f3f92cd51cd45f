// A thinned attempt opens with its result; replay, proof and a new grade name the moment of thinning.
#include <gtest/gtest.h>

#include "storage/retention/thinning.h"
#include "tests/modules.h"
#include "tests/ui/session/small_exercise.h"
#include "ui/session/play_through.h"
#include "ui/session/replay.h"

namespace cusp::test {
namespace {

TEST(ThinnedSession, OpensItsResultAndIsNeitherReplayedNorGradedAgain) {
  const Workplace work;
  DrillingPort port(2400);
  const auto played = play_through(work.plan(), port);
  ASSERT_TRUE(played);
  const SessionId session = played->session;
  auto options = quick_store();
  options.clock = [] { return system_utc_us() + 91 * std::int64_t{86'400'000'000}; };
  const auto store = std::move(Store::open(work.database(), options).value());
  const auto whole = open_result(*store, session);
  ASSERT_TRUE(whole);
  const auto report = thin_traces(store->context(), {UserId{}, Role::administrator}, {.mode = ThinningMode::carry_out});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->attempts, 1u);

  const auto opened = open_result(*store, session);
  ASSERT_TRUE(opened) << opened.error().where;
  EXPECT_EQ(opened->seconds, whole->seconds);
  EXPECT_EQ(opened->volume_hash, whole->volume_hash);
  EXPECT_EQ(opened->grade.score, whole->grade.score);
  const auto refusal = [](const auto& outcome) { return outcome ? std::string("succeeded") : outcome.error().where; };
  const auto again = open_session(*store, session);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->ticks, 2400u);
  EXPECT_EQ(refusal(Replay::open(*store, *again)), "thinned");
  EXPECT_EQ(refusal(prove_session(*store, session)), "thinned");
  EXPECT_EQ(refusal(grade_session(*store, session, nullptr, Keep::nothing)), "thinned");
}

}  // namespace
}  // namespace cusp::test
