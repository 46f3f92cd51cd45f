// The report: its table, its page, its paper.

#include <gtest/gtest.h>

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <filesystem>

#include "scenarios/burrs/burr_catalogue.h"
#include "scenarios/library/library.h"
#include "tests/ui/desk_records.h"
#include "ui/report/against_before.h"
#include "ui/report/criteria_model.h"
#include "ui/report/report_page.h"
#include "ui/report/report_pdf.h"

namespace cusp {
namespace {

ReportData sample(double score = 81) {
  ReportData data;
  data.result.scenario = *load_builtin("channel-1");
  data.result.grade = test::sample_grade(score);
  data.result.seconds = 458;
  data.result.device.device_class = "pointer";
  data.title = QStringLiteral("Straight channel");
  data.student = QStringLiteral("Lena Brandt");
  data.when = QDateTime(QDate(2026, 11, 20), QTime(10, 14));
  data.kind = SessionKind::practice;
  data.go = 7;
  data.peak_push_n = 2.1;
  return data;
}

std::string plain(QString text) {
  for (const char16_t c : {u'\x2066', u'\x2069'}) text.remove(QChar(c));
  return text.replace(QChar(0x00A0), u' ').toStdString();
}

TEST(CriteriaModel, shows_value_uncertainty_and_points_of_each_criterion) {
  const CriteriaModel model(test::sample_grade(81), {});
  ASSERT_EQ(model.rowCount(), 2);
  const auto at = [&](int column, int role = Qt::DisplayRole) { return model.index(1, column).data(role); };
  EXPECT_EQ(plain(at(CriteriaModel::kYours).toString()), "2.41 mm");
  EXPECT_EQ(plain(at(CriteriaModel::kYours, SecondRole).toString()), "± 0.03");
  EXPECT_EQ(plain(at(CriteriaModel::kPoints).toString()), "4");
  EXPECT_EQ(plain(at(CriteriaModel::kPoints, SecondRole).toString()), "/ 10");
  EXPECT_DOUBLE_EQ(at(CriteriaModel::kPoints, ShareRole).toDouble(), 0.4);
  EXPECT_EQ(at(CriteriaModel::kSign, IconRole).toString().toStdString(), "cross");  // less than half
  EXPECT_EQ(at(CriteriaModel::kPlace, IconRole).toString().toStdString(), "target");
  EXPECT_EQ(model.index(0, CriteriaModel::kSign).data(IconRole).toString().toStdString(), "check");
}

TEST(CriteriaModel, what_was_not_measured_is_not_zero) {
  Grade grade = test::sample_grade(81);
  grade.criteria[1].measure.measured = false;
  grade.criteria[1].points = grade.criteria[1].points_max = 0;
  grade.criteria[1].reason_code = "not_measured";
  const CriteriaModel model(grade, {});
  EXPECT_EQ(model.index(1, CriteriaModel::kYours).data().toString().toStdString(), "not measured");
  EXPECT_EQ(model.index(1, CriteriaModel::kPoints).data().toString().toStdString(), "no points");
  EXPECT_FALSE(model.index(1, CriteriaModel::kPoints).data(ShareRole).isValid());
}

TEST(ReportData, losses_come_dearest_first) {
  Grade grade = test::sample_grade(70);
  grade.criteria[0].points = 12;  // 8 lost against 6
  const auto lost = lost_points(grade);
  ASSERT_EQ(lost.size(), 2u);
  EXPECT_EQ(lost[0]->id, "target_removed");
}

TEST(ReportData, says_which_burr_was_used_when) {
  ReportData data = sample();
  data.result.scenario.instruments = {catalogue_burr("2")->burr, catalogue_burr("8")->burr, catalogue_burr("57")->burr};
  EXPECT_TRUE(burrs_used_text(data).isEmpty()) << "of a go that was not kept nothing is said";
  BurrUse use;
  const auto put = [&use](std::uint16_t burr, int seconds) {
    StepInput input;
    input.burr = burr;
    input.elapsed_us = 1'000'000;
    use.add(std::vector<StepInput>(static_cast<std::size_t>(seconds), input));
  };
  put(0, 72);
  put(2, 113);
  put(0, 5);
  data.burrs = use.spans();
  const QStringList lines = burrs_used_text(data);
  ASSERT_EQ(lines.size(), 2) << "the one that was never taken is not named";
  EXPECT_EQ(plain(lines[0]), "Burr 2, round, 1.0 mm: 0:00 to 1:12, 3:05 to 3:10");
  EXPECT_EQ(plain(lines[1]), "Burr 57, straight fissure, 1.0 mm: 1:12 to 3:05");
}

TEST(ReportData, what_was_lost_because_little_was_drilled_comes_after_what_was_done_and_nothings_are_left_out) {
  Grade grade = test::sample_grade(70);
  grade.criteria[0].points = 5;  // 15 lost against 6
  grade.criteria[0].reason_code = "little_drilled";
  CriterionGrade nothing = grade.criteria[1];
  nothing.id = "depth_mean";
  nothing.points = 9.97;  // prints as 10 of 10
  grade.criteria.push_back(nothing);
  const auto lost = lost_points(grade);
  ASSERT_EQ(lost.size(), 2u);
  EXPECT_EQ(lost[0]->id, "depth_most");
  EXPECT_EQ(lost[1]->id, "target_removed");
  EXPECT_EQ(CriteriaModel(grade, {}).bar_role(2), Bar::Role::good);
}

TEST(ReportData, gathers_student_go_and_the_best_before_from_the_records) {
  test::DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  records.go(lena, "channel-1", 60, 100);
  records.go(lena, "channel-1", 74, 100);
  records.go(lena, "channel-1", 90, 100, "falcon");  // another device class is never compared
  RunResult result;
  result.scenario = *load_builtin("channel-1");
  result.grade = test::sample_grade(78);
  result.session = records.go(lena, "channel-1", 78, 100);
  const Actor reader = lena.actor();
  const ReportData data = gather_report(result, &records.store(), &reader);
  EXPECT_EQ(data.student.toStdString(), "Lena Brandt");
  EXPECT_EQ(data.go, 4);
  ASSERT_TRUE(data.before.has_value());
  EXPECT_DOUBLE_EQ(data.before->score, 74);
}

TEST(ReportPage, shows_the_score_the_reasons_and_what_to_do) {
  const Ports ports = Ports::of_the_system();
  ReportPage page(sample(), ports, true, QStringLiteral("Back"));
  page.resize(1280, 800);
  page.show();
  EXPECT_EQ(page.findChild<QLabel*>(QStringLiteral("score"))->text().toStdString(), "81");
  QString all;
  for (const QLabel* label : page.findChildren<QLabel*>()) all += label->text() + u'\n';
  EXPECT_TRUE(all.contains(QStringLiteral("Floor depth, deepest: 6 points lost")));
  EXPECT_TRUE(plain(all).find("2.41 mm, 0.41 mm deeper than 2 mm.") != std::string::npos) << plain(all);
  EXPECT_TRUE(all.contains(QStringLiteral("Stop pushing before the wanted depth and move sideways.")));
  EXPECT_EQ(page.table()->chosen_row(), 1);  // the dearest loss
  QSignalSpy again(&page, &ReportPage::go_again_wanted);
  for (QPushButton* b : page.findChildren<QPushButton*>()) {
    if (b->accessibleName() == u"Go again") b->click();
  }
  EXPECT_EQ(again.count(), 1);
}

TEST(ReportPage, an_opened_pulp_is_told_above_everything_else) {
  ReportData data = sample();
  data.result.grade.critical = {"pulp_exposure"};
  data.result.grade.passed = false;
  const Ports ports = Ports::of_the_system();
  ReportPage page(data, ports, false, QStringLiteral("Back"));
  page.show();
  QString all;
  for (const QLabel* label : page.findChildren<QLabel*>()) all += label->text() + u'\n';
  EXPECT_TRUE(all.contains(QStringLiteral("The pulp was opened.")));
}

TEST(ReportPage, saves_its_paper_where_the_picker_says_and_tells_when_it_cannot) {
  QTemporaryDir folder;
  Ports ports = Ports::of_the_system();
  QString answer = folder.filePath(QStringLiteral("report.pdf"));
  ports.pick_file = [&](QWidget*, const FileWish& wish, std::function<void(const QString&)> then) {
    EXPECT_TRUE(wish.name.endsWith(QStringLiteral(".pdf")));
    then(answer);
  };
  ReportPage page(sample(), ports, true, QStringLiteral("Back"));
  page.show();
  const auto save = [&] {
    for (QPushButton* b : page.findChildren<QPushButton*>()) {
      if (b->accessibleName() == u"Save as PDF") b->click();
    }
  };
  save();
  EXPECT_TRUE(QFile::exists(answer));
  answer = folder.filePath(QStringLiteral("missing/report.pdf"));
  save();
  QString all;
  for (const QLabel* label : page.findChildren<QLabel*>()) all += label->text() + u'\n';
  EXPECT_TRUE(all.contains(QStringLiteral("The report was not saved.")));
  EXPECT_FALSE(QFile::exists(answer));
}

TEST(ReportPdf, is_one_whole_page_and_leaves_no_half_file) {
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("r.pdf")).toStdString();
  ASSERT_TRUE(write_report_pdf(file, sample(), QImage()).has_value());
  QFile written(QString::fromStdString(file.string()));
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  const QByteArray bytes = written.readAll();
  EXPECT_TRUE(bytes.startsWith("%PDF-"));
  EXPECT_TRUE(bytes.contains("/Count 1"));  // pages
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}), 1);
  const auto failed = write_report_pdf(file.parent_path() / "no" / "r.pdf", sample(), QImage());
  ASSERT_FALSE(failed.has_value());
  EXPECT_EQ(failed.error().code, PdfError::cannot_write);
}

TEST(AgainstBefore, compares_shares_and_says_what_was_gained) {
  Grade before = test::sample_grade(70);
  before.criteria[1].points = 1;
  const AgainstBefore view(test::sample_grade(81), before);
  ASSERT_EQ(view.rows().size(), 2);
  EXPECT_DOUBLE_EQ(view.rows()[1].before, 0.1);
  EXPECT_DOUBLE_EQ(view.rows()[1].now, 0.4);
  EXPECT_DOUBLE_EQ(view.rows()[1].points, 3);
  EXPECT_TRUE(view.accessibleDescription().contains(QStringLiteral("+3")));
}

}  // namespace
}  // namespace cusp
