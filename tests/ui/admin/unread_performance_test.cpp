// The performance page over records that cannot be read.

#include <gtest/gtest.h>

#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "tests/modules.h"
#include "tests/ui/admin/admin_pages.h"
#include "ui/admin/performance.h"
#include "ui/student/course.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

/// The band that offers to read rows again; nullptr while none is shown.
Band* unread_band(const Performance& page) {
  for (Band* band : page.findChildren<Band*>())
    if (band->isVisibleTo(&page) && band->findChild<QPushButton*>() != nullptr) return band;
  return nullptr;
}

TEST_F(AdminPages, performance_of_which_a_page_cannot_be_read_stays_newest_first_and_says_so) {
  const Account lena = records.student("1", "Lena Brandt");
  for (int i = 0; i < kAttemptsAtOnce + 1; ++i) records.attempt(lena, "channel-1", 50, 1);
  ports.now = [this] { return QDateTime::fromMSecsSinceEpoch(records.now_us / 1000, Qt::UTC); };
  Performance page(records.store(), records.administrator().actor(), ports);
  ASSERT_EQ(page.attempts().rowCount(), kAttemptsAtOnce);
  ASSERT_TRUE(records.store().database().run("DROP INDEX summaries_by_time"));  // no list of all is read without it
  page.show();
  page.table()->sortByColumn(AttemptsModel::kScore, Qt::AscendingOrder);
  EXPECT_TRUE(page.attempts().failed());
  const Band* unread = unread_band(page);
  ASSERT_NE(unread, nullptr);
  EXPECT_TRUE(unread->text().contains(QStringLiteral("Older attempts are not shown"))) << unread->text().toStdString();
  EXPECT_EQ(page.table()->horizontalHeader()->sortIndicatorSection(), AttemptsModel::kDate) << "the worst may be missing";
}

TEST_F(AdminPages, performance_reads_the_page_that_failed_again_when_asked) {
  const Account lena = records.student("1", "Lena Brandt");
  for (int i = 0; i < kAttemptsAtOnce + 1; ++i) records.attempt(lena, "channel-1", 50, 1);
  ports.now = [this] { return QDateTime::fromMSecsSinceEpoch(records.now_us / 1000, Qt::UTC); };
  Performance page(records.store(), records.administrator().actor(), ports);
  ASSERT_EQ(page.attempts().rowCount(), kAttemptsAtOnce);
  EXPECT_EQ(unread_band(page), nullptr);
  ASSERT_TRUE(records.store().database().run("DROP INDEX summaries_by_time"));  // no list of all is read without it
  page.show();
  page.table()->model()->fetchMore({});
  EXPECT_EQ(page.attempts().rowCount(), kAttemptsAtOnce) << "those that were read stay";
  ASSERT_NE(unread_band(page), nullptr);
  unread_band(page)->findChild<QPushButton*>()->click();
  ASSERT_NE(unread_band(page), nullptr) << "it failed once more";
  page.read();
  EXPECT_EQ(page.attempts().rowCount(), 0);
  ASSERT_NE(unread_band(page), nullptr);
  EXPECT_TRUE(unread_band(page)->text().contains(QStringLiteral("The attempts could not be read"))) << unread_band(page)->text().toStdString();
  ASSERT_TRUE(records.store().database().run(
      "CREATE INDEX summaries_by_time ON session_summaries (listed, started_at, sequence, session, device_class, passed, operator, kind)"));
  unread_band(page)->findChild<QPushButton*>()->click();
  EXPECT_EQ(unread_band(page), nullptr);
  EXPECT_GE(page.attempts().rowCount(), kAttemptsAtOnce);
}

TEST_F(AdminPages, performance_that_cannot_be_read_shows_no_figures_of_other_filters) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 60, 100);
  records.attempt(lena, "paper-block", 60, 100);
  Performance page(records.store(), records.administrator().actor(), ports);
  page.show();
  const auto charts = [&] { return std::ranges::count_if(page.findChildren<Chart*>(), [](const Chart* chart) { return chart->isVisible(); }); };
  ASSERT_EQ(charts(), 2);
  ASSERT_TRUE(records.store().database().run("DROP INDEX summaries_of_scenario"));  // no list of an exercise is read without it
  page.exercise()->setCurrentIndex(1);
  EXPECT_NE(unread_band(page), nullptr);
  EXPECT_EQ(page.attempts().rowCount(), 0);
  EXPECT_EQ(charts(), 0);
  QStringList texts;
  for (const QLabel* label : page.findChildren<QLabel*>()) texts << label->text();
  EXPECT_TRUE(texts.join(u'|').contains(QStringLiteral("Median score|–|"))) << texts.join(u'|').toStdString();
  page.exercise()->setCurrentIndex(0);
  EXPECT_EQ(page.attempts().rowCount(), 2);
  EXPECT_EQ(charts(), 2);
}

bool shows(const Performance& page, const char* part) {
  return std::ranges::any_of(page.findChildren<QLabel*>(), [&](const QLabel* label) {
    return label->isVisibleTo(&page) && label->text().contains(QLatin1String(part));
  });
}

TEST_F(AdminPages, the_learning_chart_differs_between_no_attempt_yet_and_attempts_that_could_not_be_read) {
  Performance page(records.store(), records.administrator().actor(), ports);
  page.show();
  EXPECT_TRUE(shows(page, "No attempt has points yet."));
  records.attempt(records.student("1", "Lena Brandt"), "channel-1", 60, 100);
  page.read();
  EXPECT_FALSE(shows(page, "No attempt has points yet."));
  EXPECT_FALSE(shows(page, "could not be read"));
  // Between the rows of the table and those of the chart.
  QObject::connect(page.table()->selectionModel(), &QItemSelectionModel::currentChanged, &page, [this](const QModelIndex& now) {
    if (!now.isValid()) return;
    EXPECT_TRUE(records.store().database().run("DROP INDEX IF EXISTS summaries_by_time"));
  });
  page.read();
  EXPECT_EQ(page.attempts().rowCount(), 1);
  EXPECT_TRUE(shows(page, "The attempts of this chart could not be read."));
  EXPECT_FALSE(shows(page, "No attempt has points yet."));
}

}  // namespace
}  // namespace cusp::test
