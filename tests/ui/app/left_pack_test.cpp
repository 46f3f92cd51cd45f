// An appeal pack whose report is left while it is written: how that ended reaches whoever began it.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>
#include <algorithm>
#include <atomic>
#include <memory>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/session/gate.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/report/report_page.h"
#include "ui/session/background_task.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

constexpr int kPackMs = 60'000;  // waits for progress, never decides

/// An instructor on a report, whose pack waits at a gate; behind it the records do not open.
struct LeftPack : testing::Test {
  LeftPack() {
    ports.pick_file = [this](QWidget*, const FileWish&, const std::function<void(const QString&)>& then) { then(file); };
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked += question.what;
      then(false);
    };
    const auto opener = [this](const std::filesystem::path& database, const StoreOptions& options) -> Stored<std::unique_ptr<Store>> {
      if (!holds) return Store::open(database, options);
      gate.pass();
      return fail(StorageError::busy, database.string());
    };
    desktop = std::make_unique<Desktop>(settings, ports, records.file(), opener);
    desktop->start();
    desktop->show();
    desktop->sign_in(instructor);
  }
  ~LeftPack() override {
    gate.open();
    desktop.reset();
    wait_for_dropped_tasks();  // before the records go
  }
  ReportPage* report() const { return qobject_cast<ReportPage*>(desktop->page()); }
  void begin_pack() {
    const auto result = std::make_shared<SessionResult>();
    result->session = session;
    result->scenario = *load_builtin("channel-1");
    result->grade = (*records.store().grades.newest(session))->grade;
    desktop->end_attempt(result, std::nullopt);
    ASSERT_TRUE(QTest::qWaitFor([this] { return report() != nullptr; }, kPackMs));
    holds = true;
    Q_EMIT report()->pack_wanted();
  }
  /// The band that names the file; nullptr if none is shown.
  Band* outcome() const {
    for (Band* band : desktop->page()->findChildren<Band*>())
      if (band->isVisibleTo(desktop->page()) && band->text().contains(file)) return band;
    return nullptr;
  }
  bool outcome_comes() const {
    return QTest::qWaitFor([this] { return outcome() != nullptr; }, kPackMs);
  }

  DeskRecords records;
  const Account instructor =
      *records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
  const SessionId session = records.attempt(records.student("1", "Lena Brandt"), "channel-1", 66, 90);
  QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("Lena.cusppack"));
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  Ports ports = Ports::of_the_system();
  QStringList asked;
  std::atomic<bool> holds{false};
  Gate gate;
  std::unique_ptr<Desktop> desktop;
};

TEST_F(LeftPack, is_reported_over_the_pages_until_that_is_closed) {
  begin_pack();
  desktop->back();
  ASSERT_EQ(desktop->page(), desktop->shell());
  EXPECT_EQ(outcome(), nullptr);
  gate.open();
  ASSERT_TRUE(outcome_comes());
  EXPECT_TRUE(outcome()->text().contains(QStringLiteral("No appeal pack was saved"))) << outcome()->text().toStdString();
  desktop->shell()->show_page(QStringLiteral("help"));
  ASSERT_NE(outcome(), nullptr) << "on each page";
  desktop->sign_in(records.administrator());
  EXPECT_EQ(outcome(), nullptr) << "somebody else began it";
  desktop->sign_in(instructor);
  ASSERT_NE(outcome(), nullptr);
  outcome()->findChild<QPushButton*>()->click();
  EXPECT_EQ(outcome(), nullptr);
  desktop->sign_in(instructor);
  EXPECT_EQ(outcome(), nullptr);
}

TEST_F(LeftPack, is_reported_after_the_next_sign_in_where_its_author_signed_out) {
  begin_pack();
  desktop->sign_out();
  gate.open();
  EXPECT_TRUE(QTest::qWaitFor(
      [this] {
        desktop->sign_in(instructor);
        return outcome() != nullptr;
      },
      kPackMs));
}

TEST_F(LeftPack, is_asked_about_before_the_window_closes) {
  begin_pack();
  desktop->back();
  EXPECT_FALSE(desktop->close());
  EXPECT_EQ(asked, QStringList{QStringLiteral("Close before the work has ended?")});
  gate.open();
  EXPECT_TRUE(outcome_comes());
}

using LeftReport = LeftPack;

TEST_F(LeftReport, that_opens_slowly_is_left_by_cancel_and_does_not_come_after_all) {
  holds = true;
  desktop->open_report(session);
  ASSERT_NE(desktop->page(), desktop->shell());
  const auto buttons = desktop->page()->findChildren<QPushButton*>();
  const auto cancel = std::ranges::find(buttons, QStringLiteral("Cancel"), &QPushButton::accessibleName);
  ASSERT_TRUE(cancel != buttons.end());
  ASSERT_TRUE(QTest::qWaitFor([&] { return (*cancel)->isVisible(); }, kPackMs));
  (*cancel)->click();
  EXPECT_EQ(desktop->page(), desktop->shell());
  gate.open();
  QThreadPool::globalInstance()->waitForDone();
  QCoreApplication::processEvents();
  EXPECT_EQ(desktop->page(), desktop->shell());
  EXPECT_FALSE(gate.gave_up());
}

}  // namespace
}  // namespace cusp::test
