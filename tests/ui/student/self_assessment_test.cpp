// The own assessment: how the page is filled in, and what the history charts of it.
#include <gtest/gtest.h>

#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/student/history_charts.h"
#include "ui/student/own_history.h"
#include "ui/student/self_assessment_page.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

QPushButton* button(QWidget& page, const char* text) {
  for (QPushButton* b : page.findChildren<QPushButton*>())
    if (b->text() == QString::fromUtf8(text)) return b;
  ADD_FAILURE() << "no button " << text;
  return nullptr;
}

struct OwnPage : ::testing::Test {
  Scenario scenario = *load_builtin("channel-1");
  SelfAssessmentPage page{scenario, SelfAssessmentPage::Then::result};
  std::optional<SelfAssessment> decided;
  OwnPage() {
    QObject::connect(&page, &SelfAssessmentPage::decided, [this](const SelfAssessment& own) { decided = own; });
    page.show();
    page.setFocus();
  }
};

TEST_F(OwnPage, NothingIsChosenAtFirstAndTheResultWaitsForARating) {
  EXPECT_TRUE(page.own().skipped());
  EXPECT_FALSE(button(page, "Show the result")->isEnabled());
  page.row(0)->choose(2);
  EXPECT_TRUE(button(page, "Show the result")->isEnabled());
  button(page, "Show the result")->click();
  ASSERT_TRUE(decided);
  EXPECT_EQ(*decided, (SelfAssessment{{{scenario.rubric.criteria[0].metric, OwnRating::not_met}}}));
}

TEST(OwnPageOfAVolume, NamesATissueAsTheVolumeDoes) {
  Scenario scenario = *load_builtin("channel-1");
  scenario.rubric.criteria.front().metric = "removed_16";
  const SelfAssessmentPage page(scenario, SelfAssessmentPage::Then::result, {{16, "pulp stone"}});
  EXPECT_EQ(page.row(0)->button(0)->accessibleName().toStdString(), "pulp stone removed: met");
}

TEST_F(OwnPage, KeysRateARowAndGoOnToTheNext) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
  const std::size_t criteria = scenario.rubric.criteria.size();
  for (std::size_t i = 0; i < criteria; ++i) QTest::keyClick(QApplication::focusWidget(), i % 2 == 0 ? Qt::Key_1 : Qt::Key_3);
  for (std::size_t i = 0; i < criteria; ++i) EXPECT_EQ(page.row(i)->chosen(), i % 2 == 0 ? 0 : 2) << i;
  EXPECT_EQ(QApplication::focusWidget(), button(page, "Show the result"));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  ASSERT_TRUE(decided);
  EXPECT_EQ(decided->ratings.size(), criteria);
}

TEST_F(OwnPage, AKeyThatIsHeldRatesNoFurtherRow) {
  ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
  QKeyEvent held(QEvent::KeyPress, Qt::Key_1, Qt::NoModifier, QStringLiteral("1"), true);
  QApplication::sendEvent(QApplication::focusWidget(), &held);
  EXPECT_TRUE(page.own().skipped());
}

TEST_F(OwnPage, SkippingDecidesWithoutARatingAlsoAfterOne) {
  page.row(0)->choose(0);
  button(page, "Skip")->click();
  ASSERT_TRUE(decided);
  EXPECT_TRUE(decided->skipped());
}

TEST_F(OwnPage, AfterAFailureOneGoesOnWithoutIt) {
  QSignalSpy passed_over(&page, &SelfAssessmentPage::passed_over);
  page.show_failure({QStringLiteral("The disk is full."), {}});
  EXPECT_TRUE(page.findChild<Band*>()->text().contains(QStringLiteral("The disk is full.")));
  button(page, "Go on without it")->click();
  EXPECT_EQ(passed_over.count(), 1);
  EXPECT_FALSE(decided);
}

TEST_F(OwnPage, OfAnAssessmentEndsInHandingIn) {
  SelfAssessmentPage exam(scenario, SelfAssessmentPage::Then::handed_in);
  EXPECT_NE(button(exam, "Hand in"), nullptr);
}

TEST(OwnAgainstMeasured, IsTheDifferenceInPointsByAttempt) {
  const ChartData d = own_against_measured({{.attempt = 1, .points = {3, 80, 55.4}}, {.attempt = 2, .points = {}}, {.attempt = 3, .points = {2, 50, 62}}});
  ASSERT_EQ(d.series.size(), 1);
  const auto& points = d.series[0].points;
  ASSERT_EQ(points.size(), 2) << "without a rated criterion that brings points there is nothing to compare";
  EXPECT_EQ(points[0].x, 1);
  EXPECT_EQ(points[0].y, 25);
  EXPECT_EQ(points[1].x, 3);
  EXPECT_EQ(points[1].y, -12);
  EXPECT_TRUE(points[1].strong);
  EXPECT_EQ(d.mark, 0);
  EXPECT_EQ(d.y.least, -40);
  EXPECT_EQ(d.y.most, 40);
  EXPECT_EQ(d.x.least, 1);
  EXPECT_EQ(d.summary, QStringLiteral("Rated attempts: 2. The last was rated 12 of 100 points lower than it was measured."));
  EXPECT_EQ(own_against_measured({{.attempt = 1, .points = {3, 61, 60}}}).summary,
            QStringLiteral("Rated attempts: 1. The last was rated 1 of 100 points higher than it was measured."));
}

TEST(OwnAgainstMeasured, IsTheDifferenceOfThePointsThatItsLabelShows) {
  const ChartData d = own_against_measured({{.attempt = 1, .points = {2, 70.4, 60.6}}});
  const ChartPoint& point = d.series[0].points[0];
  EXPECT_TRUE(point.label.endsWith(QStringLiteral("own 70, measured 61"))) << point.label.toStdString();
  EXPECT_EQ(point.y, 9) << "9.8 would read as 10";
}

TEST(OwnAgainstMeasured, IsChartedInOwnHistoryOnceAnAttemptIsRated) {
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  const SessionId session = records.attempt(lena, "channel-1", 66, 90);
  const auto chart = [&](QWidget& page) -> Chart* {
    for (Chart* c : page.findChildren<Chart*>())
      if (c->data().title == QStringLiteral("Own assessment") && !c->parentWidget()->isHidden()) return c;
    return nullptr;
  };
  OwnHistory before(records.store(), lena.actor());
  EXPECT_EQ(chart(before), nullptr);
  const std::string criterion = (*records.store().grades.newest(session))->grade.criteria[0].id;
  ASSERT_TRUE(records.store().statements.assess_own(lena.actor(), session, {{{criterion, OwnRating::partly}}}));
  OwnHistory after(records.store(), lena.actor());
  ASSERT_NE(chart(after), nullptr);
  EXPECT_EQ(chart(after)->data().series[0].points[0].y, -50);
}

}  // namespace
}  // namespace cusp::test
