// Work of a page in the background: what its progress shows, and Cancel.
#include <gtest/gtest.h>

#include <QBoxLayout>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QWidget>
#include <algorithm>
#include <functional>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/admin/people_import.h"
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

/// Begins by a button that is off while the work runs, and lets somebody move the focus meanwhile.
class FocusOfWork : public WorkRunTest {
 protected:
  FocusOfWork() {
    for (QPushButton* button : {begin, other, third}) page.layout()->addWidget(button);
    page.show();
    begin->setFocus();
  }
  QWidget* after_work(const std::function<void()>& meanwhile) {
    start();
    begin->setEnabled(false);
    EXPECT_NE(page.focusWidget(), begin);
    QCoreApplication::processEvents();
    meanwhile();
    begin->setEnabled(true);
    run->finish();
    return page.focusWidget();
  }
  QPushButton *begin = new QPushButton, *other = new QPushButton, *third = new QPushButton;
};

TEST_F(FocusOfWork, IsGivenBackToTheButtonThatLostIt) {
  EXPECT_EQ(after_work([] {}), begin);
}

TEST_F(FocusOfWork, IsGivenBackAfterCancel) {
  EXPECT_EQ(after_work([&] {
              run->busy()->show();
              run->busy()->findChild<QPushButton*>()->setFocus();
            }),
            begin);
}

TEST_F(FocusOfWork, StandsOnCancelOnceThatIsShown) {
  const QPushButton* cancel = run->busy()->findChild<QPushButton*>();
  const auto wait = [&] {
    EXPECT_NE(page.focusWidget(), cancel);
    EXPECT_TRUE(QTest::qWaitFor([&] { return run->busy()->isVisible(); }, kShownWithinMs));
    EXPECT_EQ(page.focusWidget(), cancel);
  };
  EXPECT_EQ(after_work(wait), begin);
}

TEST_F(FocusOfWork, StaysWhereSomebodyPutItUntilCancelIsShown) {
  const auto move_and_wait = [&] {
    third->setFocus();
    EXPECT_TRUE(QTest::qWaitFor([&] { return run->busy()->isVisible(); }, kShownWithinMs));
    EXPECT_EQ(page.focusWidget(), third);
  };
  EXPECT_EQ(after_work(move_and_wait), third);
}

TEST_F(FocusOfWork, GoesToWhatThePageNamesWhereTheButtonStaysOff) {
  start();
  begin->setEnabled(false);
  QCoreApplication::processEvents();
  ASSERT_NE(page.focusWidget(), third);
  run->finish(third);
  EXPECT_EQ(page.focusWidget(), third);
}

TEST_F(FocusOfWork, IsGivenBackAfterWorkThatEndsAtOnce) {
  start();
  begin->setEnabled(false);
  ASSERT_NE(page.focusWidget(), begin);
  begin->setEnabled(true);
  run->finish();
  EXPECT_EQ(page.focusWidget(), begin);
}

TEST_F(FocusOfWork, StaysWhereSomebodyPutIt) {
  ASSERT_NE(page.focusWidget(), third);
  EXPECT_EQ(after_work([&] { third->setFocus(); }), third);
}

TEST(FocusOfPeopleImport, GoesToTheNextListWhereNothingIsLeftToMake) {
  DeskRecords records;
  const QTemporaryDir folder;
  QFile list(folder.filePath(QStringLiteral("list.csv")));
  ASSERT_TRUE(list.open(QIODevice::WriteOnly));
  list.write("number,name\n2,New Two\n");
  list.close();
  Ports ports = Ports::of_the_system();
  ports.pick_file = [&](QWidget*, const FileWish& wish, const std::function<void(const QString&)>& then) {
    then(wish.saving ? folder.filePath(QStringLiteral("slips.pdf")) : list.fileName());
  };
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  page.choose_file();
  page.show();
  QPushButton *make = nullptr, *choose = nullptr;
  for (QPushButton* one : page.findChildren<QPushButton*>()) {
    if (one->accessibleName() == QStringLiteral("Make the accounts")) make = one;
    if (one->accessibleName() == QStringLiteral("Choose a file")) choose = one;
  }
  ASSERT_NE(make, nullptr);
  make->setFocus();
  make->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !page.working(); }, kShownWithinMs));
  EXPECT_FALSE(make->isEnabled());
  EXPECT_EQ(page.focusWidget(), choose);
}

TEST_F(WorkRunTest, WithoutProgressNobodyIsAsked) { EXPECT_FALSE(static_cast<bool>(watch_of({}))); }

}  // namespace
}  // namespace cusp::test
