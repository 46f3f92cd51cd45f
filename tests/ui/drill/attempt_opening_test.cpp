// What an attempt shows is the tooth that its session cuts.
#include "ui/drill/attempt_opening.h"

#include <gtest/gtest.h>

#include <future>

#include "tests/modules.h"
#include "tests/ui/session/small_exercise.h"
#include "ui/session/scene_builder.h"

namespace cusp::test {
namespace {

struct Opened {
  std::shared_ptr<OpenedAttempt> attempt;
  std::optional<SessionFailure> failure;
};

/// The opening's answer, when it has come.
Opened open_attempt(SessionPlan plan) {
  AttemptOpening::Order order;
  order.plan = std::move(plan);
  order.port = std::make_unique<DrillingPort>(1u << 30, DrillingPort::Pace::to_deadline);
  std::promise<Opened> answered;
  auto answer = answered.get_future();
  const AttemptOpening opening(std::move(order), [&answered](std::shared_ptr<OpenedAttempt> attempt, std::optional<SessionFailure> failure) {
    answered.set_value({std::move(attempt), std::move(failure)});
  });
  return answer.get();
}

TEST(AttemptOpening, a_resumed_attempt_shows_the_tooth_that_it_began_with_where_another_one_is_grown_now) {
  const Workplace work;
  SessionPlan plan = work.plan();
  {
    DrillingPort port(1u << 30, DrillingPort::Pace::to_deadline);
    auto started = ExerciseSession::start(plan, port);
    ASSERT_TRUE(started) << key_of(started.error().code) << ' ' << started.error().where;
    plan.resumes = (*started)->session();
    ASSERT_TRUE(eventually([&] { return (*started)->view().removed_mm3[index_of(Tissue::plastic)] > 0; }));
  }
  plan.specimen = nullptr;
  const auto grown = build_specimen(plan.scenario, {});
  ASSERT_TRUE(grown);
  const Opened opened = open_attempt(plan);
  ASSERT_FALSE(opened.failure) << key_of(opened.failure->code) << ' ' << opened.failure->where << ' ' << opened.failure->detail;
  const Specimen& cut = *opened.attempt->session->scene()->specimen;
  ASSERT_NE(cut.hash(), (*grown)->hash()) << "the exercise grows another block than the test's";
  EXPECT_EQ(opened.attempt->bounds.low, cut.grid().origin_mm);
  EXPECT_EQ(opened.attempt->bounds.high, cut.grid().centre_mm(cut.grid().size));
}

}  // namespace
}  // namespace cusp::test
