// What a report says of an attempt that lacks something, a recording or a result to compare with, and of points that were changed.

#include <gtest/gtest.h>

#include <QLabel>
#include <algorithm>

#include "storage/retention/thinning.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/report/sample_report.h"
#include "ui/report/against_before.h"
#include "ui/report/report_page.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

QString texts_on(const ReportPage& page) {
  QString all;
  for (const QLabel* label : page.findChildren<QLabel*>()) all += label->text() + u'\n';
  return all;
}

TEST(ReportStates, a_thinned_recording_is_named_where_the_times_of_the_burs_stood) {
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  SessionResult result;
  result.scenario = *load_builtin("channel-1");
  result.grade = sample_grade(78);
  result.session = records.attempt(lena, "channel-1", 78, 100);
  const Actor reader = lena.actor();
  EXPECT_TRUE(burs_used_text(gather_report(result, &records.store(), &reader)).filter(QStringLiteral("thinned")).isEmpty());
  records.now_us += 91 * std::int64_t{86'400'000'000};
  const auto thinned = thin_traces(records.store().context(), records.administrator().actor(), {.mode = ThinningMode::carry_out});
  ASSERT_TRUE(thinned);
  ASSERT_EQ(thinned->attempts, 1u);
  const ReportData data = gather_report(result, &records.store(), &reader);
  const QStringList burs = burs_used_text(data);
  ASSERT_EQ(burs.size(), 1);
  EXPECT_TRUE(burs[0].startsWith(QStringLiteral("The recording was thinned on "))) << burs[0].toStdString();
  EXPECT_TRUE(burs[0].endsWith(QStringLiteral("When each bur was used is no longer known."))) << burs[0].toStdString();
  EXPECT_EQ(data.peak_push_n, 2.1) << "the measurements of each second stay";
  const Ports ports = Ports::of_the_system();
  EXPECT_TRUE(texts_on(ReportPage(data, ports, ReportPage::TryAgain::offered, QStringLiteral("Back"))).contains(burs[0]));
}

TEST(ReportStates, points_of_an_attempt_that_broke_off_and_was_not_graded_do_not_pass_for_marks) {
  ReportData data = sample();
  data.result.interrupted = true;
  const Ports ports = Ports::of_the_system();
  const QString not_yet = QStringLiteral("It is not graded yet; the points show how it stands now.");
  for (const bool opened_pulp : {false, true}) {
    if (opened_pulp) data.critical = {{"pulp_exposure", std::nullopt, std::nullopt}};
    data.result.state = SessionState::interrupted;
    const QString before = texts_on(ReportPage(data, ports, ReportPage::TryAgain::hidden, QStringLiteral("Back")));
    EXPECT_TRUE(before.contains(not_yet)) << before.toStdString();
    EXPECT_FALSE(before.contains(QStringLiteral("marked as it stands"))) << before.toStdString();
    data.result.state = SessionState::graded;
    const QString after = texts_on(ReportPage(data, ports, ReportPage::TryAgain::hidden, QStringLiteral("Back")));
    EXPECT_FALSE(after.contains(not_yet)) << after.toStdString();
    EXPECT_TRUE(after.contains(QStringLiteral("marked as it stands"))) << after.toStdString();
  }
}

TEST(ReportStates, of_a_second_attempt_after_one_that_broke_off_no_attempt_is_denied) {
  ReportData data = sample();
  ASSERT_GT(data.attempt, 1);
  const Ports ports = Ports::of_the_system();
  const QString texts = texts_on(ReportPage(data, ports, ReportPage::TryAgain::offered, QStringLiteral("Back")));
  EXPECT_TRUE(texts.contains(QStringLiteral("No result with this device came before."))) << texts.toStdString();
}

TEST(ReportStates, a_best_attempt_that_was_marked_by_other_criteria_compares_by_its_points) {
  ReportData data = sample();
  data.before = sample_grade(74);
  data.before_when = data.when;
  const Ports ports = Ports::of_the_system();
  const QString sentence = QStringLiteral("only the points of the two compare");
  {
    const ReportPage page(data, ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
    EXPECT_FALSE(texts_on(page).contains(sentence));
    EXPECT_NE(page.findChild<AgainstBefore*>(), nullptr);
  }
  for (CriterionGrade& c : data.before->criteria) c.id = "surface_within_" + c.id;  // of an older version of the exercise
  const ReportPage page(data, ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
  EXPECT_TRUE(texts_on(page).contains(sentence));
  EXPECT_TRUE(texts_on(page).contains(QStringLiteral(", 74"))) << "the points stay";
  EXPECT_EQ(page.findChild<AgainstBefore*>(), nullptr);
}

TEST(ReportStates, the_version_that_was_drilled_is_named) {
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  const ReportData data = report_of(records, records.attempt(lena, "channel-1", 78, 100), lena);
  EXPECT_TRUE(circumstances_text(data).endsWith(QStringLiteral("version %1 of the exercise").arg(load_builtin("channel-1")->version)))
      << circumstances_text(data).toStdString();
  EXPECT_FALSE(circumstances_text(sample()).contains(QStringLiteral("version"))) << "nothing of it is kept";
}

TEST(ReportStates, an_examiner_reads_nothing_of_results_of_his_own) {
  ReportData data = sample();
  data.before = sample_grade(74);
  data.before_when = data.when;
  const Ports ports = Ports::of_the_system();
  const ReportPage page(data, ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
  const QString texts = texts_on(page);
  EXPECT_TRUE(texts.contains(QStringLiteral("Against the best before"))) << texts.toStdString();
  EXPECT_FALSE(texts.contains(QStringLiteral("your"), Qt::CaseInsensitive)) << texts.toStdString();
  const CriteriaModel model(data.result.grade, data.result.scenario);
  EXPECT_EQ(model.headerData(CriteriaModel::kMeasured, Qt::Horizontal, Qt::DisplayRole).toString().toStdString(), "Measured");
}

TEST(ReportStates, records_that_cannot_be_read_are_named_and_nothing_is_denied) {
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 74, 100);
  SessionResult result;
  result.scenario = *load_builtin("channel-1");
  result.grade = sample_grade(78);
  result.session = records.attempt(lena, "channel-1", 78, 100);
  const Actor reader = lena.actor();
  const Ports ports = Ports::of_the_system();
  const auto report = [&] { return gather_report(result, &records.store(), &reader); };
  const QString not_whole = QStringLiteral("This report is not whole");
  const auto warns = [&](const ReportPage& page) {
    return std::ranges::any_of(page.findChildren<Band*>(), [&](const Band* band) { return band->text().contains(not_whole); });
  };
  EXPECT_FALSE(report().unread);
  EXPECT_FALSE(warns(ReportPage(report(), ports, ReportPage::TryAgain::offered, QStringLiteral("Back"))));

  ASSERT_TRUE(records.store().database().run("DROP INDEX graded_of_student"));  // no best attempt is found without it
  {
    const ReportData data = report();
    ASSERT_TRUE(data.unread);
    const ReportPage page(data, ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
    EXPECT_TRUE(warns(page));
    const QString texts = texts_on(page);
    EXPECT_FALSE(texts.contains(QStringLiteral("No result with this device came before."))) << texts.toStdString();
  }
  ASSERT_TRUE(records.store().database().run("DROP INDEX statements_of_session"));  // no remarks are read without it
  const ReportData data = report();
  ASSERT_TRUE(data.unread);
  const ReportPage page(data, ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
  EXPECT_TRUE(warns(page));
  const QString texts = texts_on(page);
  EXPECT_FALSE(texts.contains(QStringLiteral("Nothing of this attempt is kept"))) << texts.toStdString();
  EXPECT_TRUE(circumstances_text(data).contains(QStringLiteral("could not be read"))) << "paper has no band";
}

TEST(ReportStates, one_point_that_was_changed_is_read_in_the_singular) {
  DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  const auto examiner = records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
  ASSERT_TRUE(examiner);
  SessionResult result;
  result.scenario = *load_builtin("channel-1");
  result.grade = sample_grade(40);
  result.grade.criteria[0].points = result.grade.criteria[0].points_max = 90;
  result.grade.criteria[1].points = 1;
  result.session = records.graded_attempt(lena, "channel-1", result.grade, 90);
  ASSERT_TRUE(records.store().statements.override_points(examiner->actor(), result.session, "depth_most", 3, "The block was worn."));
  const Actor reader = lena.actor();
  const ReportData data = gather_report(result, &records.store(), &reader);
  ASSERT_EQ(data.remarks.size(), 1u);
  EXPECT_TRUE(data.remarks[0].what.endsWith(QStringLiteral("3 instead of 1 point"))) << data.remarks[0].what.toStdString();
  ASSERT_EQ(data.changes.size(), 1u);
  EXPECT_TRUE(data.changes[0].text.startsWith(QStringLiteral("3 instead of 1 point, changed by"))) << data.changes[0].text.toStdString();
}

}  // namespace
}  // namespace cusp::test
