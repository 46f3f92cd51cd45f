/// Figures by criterion: whose points count, and which are full.
#include <gtest/gtest.h>

#include "tests/storage/many_sessions.h"

namespace cusp::test {
namespace {

TEST(ByCriterion, figures_count_the_points_that_stand_the_hardest_first) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  const Account lena = make_student(*store);
  const Actor reader = make_instructor(*store).actor();
  const ScenarioVersion version = keep(*store);
  const SessionId a = complete_session(*store, lena, version);
  complete_session(*store, lena, version);
  const auto by_criterion = [&](const Actor& actor) { return must(store->history.by_criterion(actor, {.scenario = version.scenario})); };
  auto figures = by_criterion(reader);  // of small_grade(): 18 of 20 and 4 of 10
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0].id, "floor_depth_max");
  EXPECT_EQ(figures[0].attempts, 2);
  EXPECT_EQ(figures[0].full, 0);
  EXPECT_NEAR(figures[0].mean_share, 0.4, 1e-12);
  EXPECT_NEAR(figures[1].mean_share, 0.9, 1e-12);
  must(store->statements.override_points(reader, a, "floor_depth_max", 10, "Worn."));
  figures = by_criterion(lena.actor());
  EXPECT_EQ(figures[0].full, 1);
  EXPECT_NEAR(figures[0].mean_share, 0.7, 1e-12);
  EXPECT_TRUE(by_criterion(make_student(*store, "2", "Omar").actor()).empty()) << "of others nothing";
}

TEST(ByCriterion, a_loss_that_the_report_of_an_old_grade_shows_is_not_full_points) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  const ScenarioVersion version = keep(*store);
  const SessionId id = complete_session(*store, make_student(*store), version);
  Grade old = small_grade();  // of evaluator 2, whose points are of weights
  old.evaluator = "2";
  for (CriterionGrade& c : old.criteria) c.points_max = 1;
  old.criteria[0].points = 1;
  old.criteria[1].points = 0.96;  // two points of 100 less
  old.score = 98;
  must(store->grades.save(id, old, {}));
  const auto figures = must(store->history.by_criterion(make_instructor(*store).actor(), {.scenario = version.scenario}));
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0].id, "floor_depth_max");
  EXPECT_EQ(figures[0].full, 0);
  EXPECT_EQ(figures[1].full, 1);
}

}  // namespace
}  // namespace cusp::test
