// A student's own results.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <optional>
#include <utility>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/student/own_history.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

// As the migrations make them.
constexpr const char* kIndexOfStudent =
    "CREATE INDEX summaries_of_student ON session_summaries "
    "(student, listed, started_at, sequence, session, scenario, device_class, passed, operator, kind)";
constexpr const char* kIndexOfGraded =
    "CREATE INDEX graded_of_student ON session_summaries (student, listed, scenario, started_at, sequence, attempt, score, pass_mark, "
    "passed, elapsed_us, device_class, operator) WHERE score IS NOT NULL";

constexpr QStringView kNoResult = u"No result yet, so there is nothing to draw.";

bool says(const OwnHistory& page, QStringView text) {
  return std::ranges::any_of(page.findChildren<QLabel*>(), [&](const QLabel* label) { return label->text() == text; });
}

struct OwnResults : ::testing::Test {
  DeskRecords records;
};

TEST_F(OwnResults, are_filtered_by_exercise_and_open_a_report) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 60, 300);
  const SessionId block = records.attempt(lena, "paper-block", 70, 200);
  OwnHistory page(records.store(), lena.actor());
  page.show();
  EXPECT_EQ(page.table()->model()->rowCount(), 2);
  std::optional<SessionId> wanted;
  QObject::connect(&page, &OwnHistory::report_wanted, [&](const SessionId& id) { wanted = id; });
  QTest::keyClick(page.table(), Qt::Key_Return);
  EXPECT_EQ(wanted, block);  // the newest first
  page.exercise()->setCurrentIndex(2);
  EXPECT_EQ(page.table()->model()->rowCount(), 1);
}

TEST_F(OwnResults, open_a_report_from_each_point_of_their_charts) {
  const Account lena = records.student("1", "Lena Brandt");
  const SessionId older = records.attempt(lena, "channel-1", 60, 300);
  records.broken_attempt(lena, "channel-1");  // no point stands for it
  const SessionId newer = records.attempt(lena, "channel-1", 70, 200);
  OwnHistory page(records.store(), lena.actor());
  page.show();
  std::optional<SessionId> wanted;
  QObject::connect(&page, &OwnHistory::report_wanted, [&](const SessionId& id) { wanted = id; });
  int drawn = 0;
  for (Chart* chart : page.findChildren<Chart*>()) {
    if (!chart->isVisible()) continue;
    ++drawn;
    ASSERT_EQ(chart->data().series[0].points.size(), 2);
    Q_EMIT chart->point_opened(0, 0);
    EXPECT_EQ(wanted, older);
    Q_EMIT chart->point_opened(0, 1);
    EXPECT_EQ(wanted, newer);
  }
  EXPECT_EQ(drawn, 2);
}

TEST_F(OwnResults, without_a_result_draw_no_empty_charts_and_say_why) {
  const Account lena = records.student("1", "Lena Brandt");
  records.broken_attempt(lena, "channel-1");
  const auto shows = [](const OwnHistory& page) {
    int charts = 0;
    for (const Chart* chart : page.findChildren<Chart*>()) charts += chart->isVisible() ? 1 : 0;
    return std::pair{charts, says(page, kNoResult)};
  };
  OwnHistory page(records.store(), lena.actor());
  page.show();
  EXPECT_EQ(page.table()->model()->rowCount(), 1);
  EXPECT_EQ(shows(page), std::pair(0, true));
  records.attempt(lena, "channel-1", 60, 300);
  ASSERT_TRUE(page.read_again());
  EXPECT_EQ(shows(page), std::pair(2, false));
}

TEST_F(OwnResults, draw_what_the_student_drilled_and_no_scripted_operator) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 60, 300);
  records.scripted_attempt(lena, "channel-1", 100, 100);
  OwnHistory page(records.store(), lena.actor());
  page.show();
  EXPECT_EQ(page.table()->model()->rowCount(), 2);
  int drawn = 0;
  for (const Chart* chart : page.findChildren<Chart*>()) {
    if (!chart->isVisible()) continue;
    ++drawn;
    ASSERT_EQ(chart->data().series.size(), 1);
    ASSERT_EQ(chart->data().series[0].points.size(), 1);
    EXPECT_EQ(chart->data().series[0].points[0].y, 60);
  }
  EXPECT_EQ(drawn, 2);
}

TEST_F(OwnResults, keep_exercise_and_row_after_the_first_attempt_at_a_new_exercise) {
  const Account lena = records.student("1", "Lena Brandt");
  const SessionId older = records.attempt(lena, "paper-block", 60, 300);
  records.attempt(lena, "paper-block", 70, 300);
  OwnHistory page(records.store(), lena.actor());
  page.show();
  page.exercise()->setCurrentIndex(1);
  const QVariant chosen = page.exercise()->currentData();
  page.table()->choose_row(1);
  records.attempt(lena, "channel-1", 80, 200);
  records.attempt(lena, "class-1-36", 80, 200);
  ASSERT_TRUE(page.read_again()) << "a page made anew shows all exercises";
  EXPECT_EQ(page.exercise()->count(), 4);
  EXPECT_EQ(page.exercise()->currentData(), chosen);
  EXPECT_EQ(page.table()->model()->rowCount(), 2);
  std::optional<SessionId> wanted;
  QObject::connect(&page, &OwnHistory::report_wanted, [&](const SessionId& id) { wanted = id; });
  QTest::keyClick(page.table(), Qt::Key_Return);
  EXPECT_EQ(wanted, older);
  page.exercise()->setCurrentIndex(0);
  EXPECT_EQ(page.table()->model()->rowCount(), 4);
}

TEST_F(OwnResults, that_cannot_be_read_leave_no_rows_of_another_exercise) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 60, 300);
  records.attempt(lena, "paper-block", 70, 200);
  OwnHistory page(records.store(), lena.actor());
  page.show();
  ASSERT_EQ(page.table()->model()->rowCount(), 2);
  ASSERT_TRUE(records.store().database().run("DROP INDEX summaries_of_student"));  // no list is read without it
  const auto refused = records.store().history.page(lena.actor(), {.student = lena.id}, std::nullopt, 1);
  ASSERT_FALSE(refused);
  page.exercise()->setCurrentIndex(1);
  EXPECT_EQ(page.table()->model()->rowCount(), 0);
  auto* unread = page.findChild<Band*>();
  ASSERT_TRUE(unread->isVisible());
  EXPECT_TRUE(unread->text().contains(describe(refused.error()).line())) << unread->text().toStdString();
  EXPECT_FALSE(says(page, kNoResult)) << "that there is none is not known";
  for (const Chart* chart : page.findChildren<Chart*>()) EXPECT_FALSE(chart->isVisible());
  ASSERT_TRUE(records.store().database().run(kIndexOfStudent));
  unread->findChild<QPushButton*>()->click();
  EXPECT_FALSE(unread->isVisible());
  EXPECT_EQ(page.table()->model()->rowCount(), 1);
}

TEST_F(OwnResults, whose_charts_cannot_be_read_stay_listed_and_offer_to_read_them_again) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 60, 300);
  ASSERT_TRUE(records.store().database().run("DROP INDEX graded_of_student"));  // no rated attempts are read without it
  OwnHistory page(records.store(), lena.actor());
  page.show();
  EXPECT_EQ(page.table()->model()->rowCount(), 1);
  auto* unread = page.findChild<Band*>();
  ASSERT_TRUE(unread->isVisible());
  EXPECT_TRUE(unread->text().contains(QStringLiteral("The charts are not shown"))) << unread->text().toStdString();
  EXPECT_FALSE(says(page, kNoResult)) << "there is one";
  for (const Chart* chart : page.findChildren<Chart*>()) EXPECT_FALSE(chart->isVisible());
  ASSERT_TRUE(records.store().database().run(kIndexOfGraded));
  unread->findChild<QPushButton*>()->click();
  EXPECT_FALSE(unread->isVisible());
  EXPECT_EQ(std::ranges::count_if(page.findChildren<Chart*>(), &QWidget::isVisible), 2);
}

TEST_F(OwnResults, whose_exercises_cannot_be_read_are_read_again_in_place) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 60, 300);
  ASSERT_TRUE(records.store().database().run("DROP INDEX summaries_of_student"));  // no list is read without it
  OwnHistory page(records.store(), lena.actor());
  page.show();
  ASSERT_EQ(page.table(), nullptr);
  page.findChild<QPushButton*>()->click();
  EXPECT_EQ(page.table(), nullptr) << "it failed once more";
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  ASSERT_TRUE(records.store().database().run(kIndexOfStudent));
  page.findChild<QPushButton*>()->click();
  ASSERT_NE(page.table(), nullptr);
  EXPECT_EQ(page.table()->model()->rowCount(), 1);
}

TEST_F(OwnResults, of_which_an_older_page_cannot_be_read_say_so_and_read_it_again) {
  const Account lena = records.student("1", "Lena Brandt");
  for (int i = 0; i < kAttemptsAtOnce + 1; ++i) records.attempt(lena, "channel-1", 60, 1);
  OwnHistory page(records.store(), lena.actor());
  auto* rows = page.table()->model();
  ASSERT_EQ(rows->rowCount(), kAttemptsAtOnce);
  ASSERT_TRUE(records.store().database().run("DROP INDEX summaries_of_student"));  // no list is read without it
  rows->fetchMore({});
  page.show();
  EXPECT_EQ(rows->rowCount(), kAttemptsAtOnce) << "those that were read stay";
  auto* unread = page.findChild<Band*>();
  ASSERT_NE(unread, nullptr);
  EXPECT_TRUE(unread->isVisible());
  EXPECT_TRUE(unread->text().contains(QStringLiteral("Older attempts are not shown"))) << unread->text().toStdString();
  auto* again = unread->findChild<QPushButton*>();
  ASSERT_NE(again, nullptr);
  again->click();
  EXPECT_TRUE(unread->isVisible()) << "it failed once more";
  ASSERT_TRUE(records.store().database().run(kIndexOfStudent));
  again->click();
  EXPECT_FALSE(unread->isVisible());
  EXPECT_EQ(rows->rowCount(), kAttemptsAtOnce + 1);
}

TEST_F(OwnResults, without_an_attempt_offer_the_exercises) {
  const Account lena = records.student("1", "Lena Brandt");
  OwnHistory page(records.store(), lena.actor());
  page.show();
  EXPECT_EQ(page.table(), nullptr);
  QSignalSpy wanted(&page, &OwnHistory::exercises_wanted);
  page.findChild<QPushButton*>()->click();
  EXPECT_EQ(wanted.count(), 1);
}

}  // namespace
}  // namespace cusp::test
