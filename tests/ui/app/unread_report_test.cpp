// The report of an attempt whose records do not open a second time, or cannot be read.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QTest>
#include <filesystem>
#include <memory>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/report/report_page.h"
#include "ui/student/assessments.h"
#include "ui/widgets/empty_state.h"

namespace cusp::test {
namespace {

constexpr int kReportMs = 60'000;  // waits for progress, never decides

/// A student who has signed in, and an attempt of hers.
struct UnreadReport : testing::Test {
  UnreadReport() {
    result->session = records.attempt(lena, "channel-1", 66, 90);
    result->scenario = *load_builtin("channel-1");
    result->grade = (*records.store().grades.newest(result->session))->grade;
    desktop.start();
    desktop.show();
    desktop.sign_in(lena);
  }
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  std::shared_ptr<SessionResult> result = std::make_shared<SessionResult>();
  const QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  Desktop desktop{settings, Ports::of_the_system(), records.file()};
};

TEST_F(UnreadReport, NamesWhyTheRecordsDoNotOpenAndDeniesNoAttempt) {
  const std::filesystem::path file = records.file();
  const std::filesystem::path aside = file.string() + ".aside";
  std::filesystem::rename(file, aside);
  std::filesystem::create_directory(file);
  desktop.end_attempt(result, std::nullopt);
  const auto report = [this] { return desktop.findChild<ReportPage*>(); };
  EXPECT_TRUE(QTest::qWaitFor([&] { return report() != nullptr; }, kReportMs));
  std::filesystem::remove(file);
  std::filesystem::rename(aside, file);
  ASSERT_NE(report(), nullptr);
  EXPECT_TRUE(report()->data().unread);
  EXPECT_FALSE(occasion_text(report()->data(), Medium::screen).contains(QStringLiteral("Nothing of this attempt is kept")));
}

TEST_F(UnreadReport, IsNotTakenForOneThatIsHandedInAndWithheld) {
  ASSERT_TRUE(records.store().database().run("ALTER TABLE session_summaries RENAME TO lost_summaries"));
  const auto shows_why = [this] {
    const QWidget* page = desktop.page();
    return page != desktop.shell() && qobject_cast<const HandedIn*>(page) == nullptr && page->findChild<EmptyState*>() != nullptr;
  };
  desktop.open_report(result->session);
  EXPECT_TRUE(shows_why());
  desktop.back();
  desktop.end_attempt(result, std::nullopt);
  EXPECT_TRUE(shows_why());
}

}  // namespace
}  // namespace cusp::test
