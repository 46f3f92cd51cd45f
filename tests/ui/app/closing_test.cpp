// What the desktop asks before its window closes, where no draft, form or comment is at stake.
#include <gtest/gtest.h>

#include <QTest>
#include <memory>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/app/asking_desktop.h"
#include "ui/admin/station_page.h"
#include "ui/app/shell.h"
#include "ui/drill/drill_screen.h"
#include "ui/report/marking_card.h"
#include "ui/signin/sign_in.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/number_field.h"

namespace cusp::test {
namespace {

constexpr int kClosingMs = 60'000;  // waits for progress, never decides

struct Closing : AskingDesktop {};

TEST_F(Closing, asks_over_typed_points_and_the_lock_does_not_say_that_they_are_kept) {
  sign_in(instructor());
  auto result = std::make_shared<SessionResult>();
  result->session = records.attempt(records.student("1", "Lena Brandt"), "channel-1", 66, 90);
  result->scenario = *load_builtin("channel-1");
  result->grade = (*records.store().grades.newest(result->session))->grade;
  desktop->end_attempt(result, std::nullopt);
  const auto card = [this] { return desktop->page()->findChild<MarkingCard*>(); };
  ASSERT_TRUE(QTest::qWaitFor([&] { return card() != nullptr; }, kClosingMs));
  card()->set_criterion(&result->grade.criteria.back());
  auto* points = card()->findChild<NumberField*>();
  ASSERT_LT(points->value(), points->maximum());
  points->setValue(points->maximum());
  desktop->close();
  ASSERT_EQ(asked, QStringList{QStringLiteral("Close without the changed points?")});
  EXPECT_TRUE(desktop->isVisible());
  desktop->lock_idle();
  ASSERT_FALSE(desktop->account());
  const auto* page = qobject_cast<SignIn*>(desktop->page());
  ASSERT_NE(page, nullptr);
  EXPECT_TRUE(page->message().contains(QStringLiteral("but for the points"))) << page->message().toStdString();
}

TEST_F(Closing, asks_over_work_whose_outcome_would_be_shown_nowhere) {
  settings.set_backup_folder(folder.filePath(QStringLiteral("backups")));
  sign_in(records.administrator());
  desktop->shell()->show_page(QStringLiteral("station"));
  auto* station = qobject_cast<StationPage*>(desktop->shell()->page());
  ASSERT_NE(station, nullptr);
  station->back_up();
  desktop->close();
  ASSERT_EQ(asked, QStringList{QStringLiteral("Close before the work has ended?")});
  answer(false);
  EXPECT_TRUE(desktop->isVisible());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !station->working(); }, kClosingMs));
  desktop->close();
  EXPECT_EQ(asked.size(), 1) << "its outcome was shown";
  EXPECT_FALSE(desktop->isVisible());
}

TEST_F(Closing, calls_off_an_attempt_that_is_being_opened_and_shows_that) {
  show();
  desktop->start();
  Exercise exercise;
  exercise.scenario = *load_builtin("class-1-36");
  exercise.scenario.specimen.voxel_mm = 0.08;  // grown in some ten seconds
  desktop->drill(exercise);
  const auto* screen = qobject_cast<DrillScreen*>(desktop->page());
  ASSERT_NE(screen, nullptr);
  ASSERT_FALSE(screen->running());
  EXPECT_FALSE(desktop->close());
  EXPECT_TRUE(desktop->isVisible());
  EXPECT_EQ(screen->findChild<Busy*>()->accessibleName(), QStringLiteral("Leaving the attempt"));
  EXPECT_TRUE(QTest::qWaitFor([this] { return !desktop->isVisible(); }, kClosingMs));
  EXPECT_TRUE(asked.isEmpty());
}

}  // namespace
}  // namespace cusp::test
