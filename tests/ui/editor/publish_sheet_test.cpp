// The sheet before publishing: what changed, who uses an older version, whether the exercise was tried out.

#include <gtest/gtest.h>

#include <QDeadlineTimer>
#include <QLabel>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QThread>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/ranges.h"
#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "tests/modules.h"
#include "tests/ui/editor/editor_pages.h"
#include "ui/editor/change_messages.h"
#include "ui/editor/publish_sheet.h"
#include "ui/session/background_task.h"
#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

QString text_of(const QWidget& sheet) {
  QString all;
  for (const QLabel* label : sheet.findChildren<QLabel*>()) all += label->text() + u'\n';
  return all.remove(QRegularExpression(QStringLiteral("[\u2066-\u2069]"))).replace(QChar(0x00A0), u' ');
}

struct PublishSheets : EditorPages {
  std::vector<Question> asked;
  bool answer = false;
  void SetUp() override {
    EditorPages::SetUp();
    ports.now = [] { return QDateTime(QDate(2026, 11, 20), QTime(12, 0)); };
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked.push_back(question);
      then(answer);
    };
  }
  std::size_t versions(const EditorPage& page) {
    return records.store().scenarios.versions(const_cast<EditorPage&>(page).model().scenario().id)->size();
  }
  void publish_tried(EditorPage& page) {
    page.model().now_tried(page.model().scenario());
    ASSERT_TRUE(open_sheet(page));
    ASSERT_TRUE(publish_by_sheet(page));
  }
};

TEST_F(PublishSheets, ListWhatChangedWithValuesOfNowAndBefore) {
  const auto page = open();
  page->model().set_depth_mm(1.5);
  page->model().end_gesture();
  page->model().set_pass(60);
  ASSERT_TRUE(open_sheet(*page));
  const QString text = text_of(*sheet_of(*page));
  EXPECT_TRUE(text.contains(QStringLiteral("Changed since version 3"))) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("Depth: 1.50 mm, was 2.00 mm"))) << text.toStdString();
  EXPECT_FALSE(text.contains(QStringLiteral("Points of the outline"))) << "they moved with the floor alone: " << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("Pass mark, of 100: 60, was 70"))) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("Full points for Floor depth, mean: 1.35 to 1.65"))) << "the bands move with the depth: " << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("None."))) << "no cohort uses it";
  EXPECT_EQ(versions(*page), 0u);
}

TEST_F(PublishSheets, AreNoHigherThanTheScreenAtALargeTextSize) {
  apply_theme(*qApp, ColourScheme::light, 200);
  const auto page = open();
  page->model().set_depth_mm(1.5);
  page->model().end_gesture();
  page->model().set_pass(60);
  page->model().set_title("en", QStringLiteral("A channel of another depth"));
  page->model().set_own_assessment(EditorModel::OwnAssessment::asked);
  ASSERT_TRUE(open_sheet(*page));
  PublishSheet* sheet = sheet_of(*page);
  QTest::qWait(0);
  EXPECT_LE(sheet->height(), sheet->screen()->availableGeometry().height());
  EXPECT_TRUE(sheet->rect().contains(QRect(sheet->publish()->mapTo(sheet, QPoint()), sheet->publish()->size())));
  const auto* area = sheet->findChild<QScrollArea*>(QString(), Qt::FindDirectChildrenOnly);
  ASSERT_NE(area, nullptr);
  EXPECT_GT(area->verticalScrollBar()->maximum(), 0) << "the rest scrolls";
  EXPECT_EQ(area->focusPolicy(), Qt::StrongFocus) << "by the keyboard too";
  apply_theme(*qApp, ColourScheme::light, 100);
}

TEST_F(PublishSheets, AskOnceMoreBeforeWhatNobodyTriedOutAndOnlyThen) {
  const auto page = open();
  page->model().set_depth_mm(1.5);
  ASSERT_TRUE(open_sheet(*page));
  EXPECT_NE(sheet_of(*page)->try_out(), nullptr);
  sheet_of(*page)->publish()->click();
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_EQ(versions(*page), 0u);
  EXPECT_NE(sheet_of(*page), nullptr) << "the sheet stays when the question is answered with no";
  answer = true;
  ASSERT_TRUE(publish_by_sheet(*page));
  EXPECT_EQ(asked.size(), 2u);
  EXPECT_EQ(versions(*page), 2u) << "the program's own and the new one";
  page->model().set_depth_mm(1.6);
  publish_tried(*page);
  EXPECT_EQ(asked.size(), 2u);
  EXPECT_EQ(versions(*page), 3u);
}

TEST_F(PublishSheets, ComeAfterAQuestionWhileTheExerciseCannotHoldTheBriefingThatIsTyped) {
  const auto page = open();
  page->model().set_depth_mm(1.5);
  page->model().end_gesture();
  auto* edit = named<QPlainTextEdit>(*page, "Briefing, English");
  ASSERT_NE(edit, nullptr);
  const QString before = edit->toPlainText();
  edit->clear();
  page->publish_version();
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_EQ(asked[0].what, QStringLiteral("Publish without the briefing?"));
  answer = true;
  ASSERT_TRUE(open_sheet(*page));
  EXPECT_EQ(asked.size(), 2u) << "the one that was answered with no published nothing";
  sheet_of(*page)->reject();
  edit->setPlainText(before);
  ASSERT_TRUE(open_sheet(*page));
  EXPECT_EQ(asked.size(), 2u) << "the exercise holds it";
}

TEST_F(PublishSheets, LeaveTheKeysToThePageWhenTheyCloseWithTheirQuestion) {
  ports.ask = Ports::of_the_system().ask;
  const auto page = open();
  page->model().set_depth_mm(1.5);
  ASSERT_TRUE(open_sheet(*page));
  sheet_of(*page)->publish()->click();
  auto* box = sheet_of(*page)->findChild<QMessageBox*>();
  ASSERT_NE(box, nullptr);
  ASSERT_TRUE(QTest::qWaitForWindowActive(box));
  box->defaultButton()->click();
  EXPECT_EQ(sheet_of(*page), nullptr);
  EXPECT_TRUE(QTest::qWaitForWindowActive(page.get()));
}

TEST_F(PublishSheets, ATrialCountsUntilTheNextChangeThatADrillShows) {
  const auto page = open();
  EditorModel& model = page->model();
  model.set_depth_mm(1.5);
  EXPECT_FALSE(model.tried());
  model.now_tried(model.scenario());
  EXPECT_TRUE(model.tried());
  model.set_title("en", QStringLiteral("Another title"));
  EXPECT_TRUE(model.tried()) << "a title changes nothing that is drilled";
  model.end_gesture();
  model.set_width_mm(1.9);
  EXPECT_FALSE(model.tried());
  model.stack().undo();
  EXPECT_TRUE(model.tried());
}

TEST_F(PublishSheets, LeadToTheTryOut) {
  const auto page = open();
  page->model().set_depth_mm(1.5);
  QSignalSpy wanted(page.get(), &EditorPage::try_out_wanted);
  ASSERT_TRUE(open_sheet(*page));
  sheet_of(*page)->try_out()->click();
  EXPECT_EQ(wanted.count(), 1);
  EXPECT_EQ(sheet_of(*page), nullptr);
}

TEST_F(PublishSheets, NameTheCohortsWhoseOpenAssignmentsKeepAnOlderVersion) {
  const auto page = open();
  page->model().set_depth_mm(1.5);
  publish_tried(*page);
  const ScenarioVersion version = records.store().scenarios.versions(page->model().scenario().id)->back();
  const auto assign = [&](const char* cohort, std::optional<std::int64_t> due) {
    const auto made = records.store().cohorts.create(instructor.actor(), cohort);
    ASSERT_TRUE(made.has_value());
    ASSERT_TRUE(records.store().assignments.create(instructor.actor(), {.version = version.id, .cohort = made->id, .due_utc_us = due}).has_value());
  };
  const std::int64_t day_us = 86'400'000'000;
  const std::int64_t now_us = ports.now().toMSecsSinceEpoch() * 1000;
  assign("Year 3", now_us + 14 * day_us);
  assign("Year 4", std::nullopt);
  assign("Year 2", now_us - day_us);
  page->model().set_depth_mm(1.6);
  ASSERT_TRUE(open_sheet(*page));
  const QString text = text_of(*sheet_of(*page));
  EXPECT_TRUE(text.contains(QStringLiteral("Year 3: Practice, version 4"))) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("due ") + format_day_time(local_time(now_us + 14 * day_us)).replace(QChar(0x00A0), u' '))) << "a day alone is also that of midnight: " << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("Year 4: Practice, version 4"))) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("no due date"))) << text.toStdString();
  EXPECT_FALSE(text.contains(QStringLiteral("Year 2"))) << "that one is over";
  EXPECT_TRUE(text.contains(QStringLiteral("Assign version 5"))) << text.toStdString();
}

TEST_F(PublishSheets, ShowWhatWasEditedWhileTheExerciseWasChecked) {
  const auto page = open();
  page->model().set_depth_mm(1.5);
  page->publish_version();
  EXPECT_EQ(sheet_of(*page), nullptr) << "the checks have a thread of their own";
  page->model().set_depth_mm(1.7);
  ASSERT_TRUE(QTest::qWaitFor([&] { return sheet_of(*page) != nullptr; }, kGrowsWithinMs));
  EXPECT_TRUE(text_of(*sheet_of(*page)).contains(QStringLiteral("Depth: 1.70 mm, was 2.00 mm"))) << text_of(*sheet_of(*page)).toStdString();
}

TEST_F(PublishSheets, DoNotOpenForAToothThatHasNotGrown) {
  const auto page = open();
  SpecimenSource lost;
  lost.volume = "lost.nrrd";  // never grows: there is no such file
  lost.voxel_mm = 0.4;
  ASSERT_TRUE(page->model().set_specimen(lost, page->model().scenario().tissues));
  ASSERT_EQ(page->model().standing(), EditorModel::Standing::unproved);
  page->publish_version();  // as after a check during which the tooth was changed
  EXPECT_EQ(sheet_of(*page), nullptr);
}

TEST_F(PublishSheets, DoNotOpenOnceTheCheckIsStopped) {
  const auto page = open();
  page->model().set_depth_mm(1.5);
  page->publish_version();
  QPushButton* stop = nullptr;
  for (QPushButton* one : page->findChildren<QPushButton*>())
    if (one->text().trimmed() == QStringLiteral("Stop checking")) stop = one;
  ASSERT_NE(stop, nullptr);
  stop->click();
  std::thread(wait_for_dropped_tasks).join();  // the check has ended, and its answer waits for the window
  QCoreApplication::processEvents();
  EXPECT_EQ(sheet_of(*page), nullptr);
  EXPECT_FALSE(stop->isVisible());
  page->model().now_tried(page->model().scenario());
  EXPECT_TRUE(open_sheet(*page)) << "and it can be published all the same";
}

TEST_F(PublishSheets, PublishWithoutATurnOfTheWindowsEventLoop) {
  const auto page = open();
  page->model().set_depth_mm(1.5);
  page->model().now_tried(page->model().scenario());
  ASSERT_TRUE(open_sheet(*page));
  sheet_of(*page)->publish()->click();
  const QDeadlineTimer limit(kGrowsWithinMs);
  while (versions(*page) < 2 && !limit.hasExpired()) QThread::msleep(1);
  EXPECT_EQ(versions(*page), 2u);
}

TEST_F(PublishSheets, OpenAnewIfAnotherDeskPublishedWhileTheyWereOpen) {
  const auto page = open();
  page->model().set_depth_mm(1.5);
  page->model().now_tried(page->model().scenario());
  ASSERT_TRUE(open_sheet(*page));
  EXPECT_TRUE(text_of(*sheet_of(*page)).contains(QStringLiteral("Changed since version 3")));
  Scenarios& scenarios = records.store().scenarios;
  Scenario theirs = *load_builtin("channel-1");
  ASSERT_TRUE(scenarios.ensure(theirs, canonical_json(theirs), content_hash(theirs).bytes));
  theirs.version += 1;
  theirs.rubric.pass = 60;
  ASSERT_TRUE(scenarios.publish(instructor.actor(), theirs, canonical_json(theirs), content_hash(theirs).bytes));
  sheet_of(*page)->publish()->click();
  ASSERT_NE(sheet_of(*page), nullptr);
  const QString text = text_of(*sheet_of(*page));
  EXPECT_TRUE(text.contains(QStringLiteral("Another window has published version 4"))) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("Pass mark, of 100: 70, was 60"))) << "which would be undone unseen: " << text.toStdString();
  EXPECT_EQ(versions(*page), 2u);
  ASSERT_TRUE(publish_by_sheet(*page));
  EXPECT_EQ(versions(*page), 3u);
}

TEST_F(PublishSheets, LetThePageLeaveOnceTheVersionStandsAndKeepWhatWasEditedMeanwhile) {
  const auto page = open();
  QSignalSpy back(page.get(), &EditorPage::back_wanted);
  page->model().set_depth_mm(1.5);
  page->model().now_tried(page->model().scenario());
  ASSERT_TRUE(open_sheet(*page));
  sheet_of(*page)->publish()->click();
  page->model().set_depth_mm(1.7);
  page->leave();
  EXPECT_EQ(back.count(), 0);
  ASSERT_TRUE(back.wait(kGrowsWithinMs));
  EXPECT_EQ(versions(*page), 2u);
  const auto draft = records.store().scenarios.draft(instructor.actor(), page->model().scenario().id);
  ASSERT_TRUE(draft.has_value() && draft->has_value());
  EXPECT_DOUBLE_EQ(read_scenario((*draft)->json)->target.outline.depth_mm, 1.7);
  EXPECT_DOUBLE_EQ(page->model().published()->target.outline.depth_mm, 1.5);
}

TEST(ChangeMessages, NameEveryNumberOfTheTableOfRanges) {
  for (const NumberRange& range : number_ranges()) {
    if (range.path == "/format" || range.path == "/version") continue;  // compare() leaves them out
    const QString text = change_message({ChangeKind::changed, std::string(range.path), "depth_mean", range.least, range.most});
    EXPECT_FALSE(text.contains(u'/') && !text.contains(QStringLiteral("mm/s")) && !text.contains(QStringLiteral("N/mm"))) << text.toStdString();
    EXPECT_FALSE(text.contains(u'%')) << text.toStdString();
  }
}

}  // namespace
}  // namespace cusp::test
