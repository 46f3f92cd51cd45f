// Work of a page in the background: what its progress shows, and Cancel.
#include <gtest/gtest.h>

#include <QBoxLayout>
#include <QLabel>
#include <QTest>
#include <QWidget>
#include <algorithm>

#include "tests/modules.h"
#include "ui/admin/work_run.h"
#include "ui/widgets/busy.h"

namespace cusp::test {
namespace {

constexpr int kShownWithinMs = 60'000;

class WorkRunTest : public testing::Test {
 protected:
  WorkRunTest() { (new QVBoxLayout(&page))->addWidget(run->busy()); }
  WorkWatch start() {
    return watch_of(run->start(QStringLiteral("Verifying every record"), [](std::size_t done, std::size_t all) {
      return QStringLiteral("Verified %1 of %2 attempts").arg(count_text(done), count_text(all));
    }));
  }
  bool shows(const QString& text) {
    const auto labels = run->busy()->findChildren<QLabel*>();
    return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text() == text; });
  }

  QWidget page;
  WorkRun* run = new WorkRun(&page);
};

TEST_F(WorkRunTest, ShowsHowFarItsTaskIs) {
  const WorkWatch watch = start();
  EXPECT_TRUE(run->running());
  EXPECT_EQ(run->busy()->accessibleName(), QStringLiteral("Verifying every record"));
  EXPECT_TRUE(watch(0, 0)) << "nothing is counted yet";
  EXPECT_TRUE(watch(3, 12));
  ASSERT_TRUE(QTest::qWaitFor([&] { return shows(QStringLiteral("Verified 3 of 12 attempts")); }, kShownWithinMs));
  EXPECT_NEAR(run->busy()->findChild<Bar*>()->share(), 0.25, 0.01);
  run->finish();
  EXPECT_FALSE(run->running());
}

TEST_F(WorkRunTest, CancelStopsItBeforeItsNextStepAndNotTheNextWork) {
  const WorkWatch first = start();
  Q_EMIT run->busy()->cancelled();
  EXPECT_FALSE(first(1, 3));
  EXPECT_TRUE(run->running()) << "until its outcome is there";
  run->finish();
  EXPECT_TRUE(start()(0, 3));
}

TEST_F(WorkRunTest, WithoutProgressNobodyIsAsked) { EXPECT_FALSE(static_cast<bool>(watch_of({}))); }

}  // namespace
}  // namespace cusp::test
