// The report: its table and its page.

#include <gtest/gtest.h>

#include <QFile>
#include <QLabel>
#include <QLineF>
#include <QPushButton>
#include <QSignalSpy>
#include <algorithm>
#include <filesystem>

#include "scenarios/burs/bur_catalogue.h"
#include "tests/modules.h"
#include "tests/ui/report/sample_report.h"
#include "ui/text/grade_text.h"
#include "ui/report/against_before.h"
#include "ui/report/criteria_model.h"
#include "ui/report/report_page.h"
#include "ui/report/report_pdf.h"
#include "ui/report/report_text.h"

namespace cusp::test {
namespace {

std::string plain(QString text) {
  for (const char16_t c : {u'\x2066', u'\x2069'}) text.remove(QChar(c));
  return text.replace(QChar(0x00A0), u' ').toStdString();
}

TEST(CriteriaModel, shows_value_uncertainty_and_points_of_each_criterion) {
  const CriteriaModel model(test::sample_grade(81), {});
  ASSERT_EQ(model.rowCount(), 2);
  const auto at = [&](int column, int role = Qt::DisplayRole) { return model.index(1, column).data(role); };
  EXPECT_EQ(plain(at(CriteriaModel::kMeasured).toString()), "2.41 mm");
  EXPECT_EQ(plain(at(CriteriaModel::kMeasured, SecondRole).toString()), "± 0.03");
  EXPECT_EQ(plain(at(CriteriaModel::kPoints).toString()), "13.3");  // 4 of 10, where the weights sum to 30
  EXPECT_EQ(plain(at(CriteriaModel::kPoints, SecondRole).toString()), "/ 33.3");
  EXPECT_DOUBLE_EQ(at(CriteriaModel::kPoints, ShareRole).toDouble(), 0.4);
  EXPECT_EQ(at(CriteriaModel::kSign, IconRole).toString().toStdString(), "cross");  // less than half
  EXPECT_EQ(at(CriteriaModel::kPlace, IconRole).toString().toStdString(), "target");
  EXPECT_EQ(model.index(0, CriteriaModel::kSign).data(IconRole).toString().toStdString(), "check");
}

TEST(CriteriaModel, shows_the_own_rating_beside_the_points_and_how_it_differs) {
  CriteriaModel model(test::sample_grade(81), {});  // the target is full, of the depth less than half
  const auto own = [&](int row, int role = Qt::DisplayRole) { return model.index(row, CriteriaModel::kOwn).data(role).toString().toStdString(); };
  EXPECT_EQ(own(0), "–");
  model.set_own(SelfAssessment{{{model.criterion(0).id, OwnRating::met}, {model.criterion(1).id, OwnRating::partly}}});
  EXPECT_EQ(own(0), "met");
  EXPECT_EQ(own(0, IconRole), "");
  EXPECT_EQ(own(0, Qt::ToolTipRole), "rated as it was measured");
  EXPECT_EQ(own(1), "partly met");
  EXPECT_EQ(own(1, IconRole), "chevron_up");
  EXPECT_EQ(own(1, Qt::AccessibleTextRole), "partly met, rated higher than it was measured");
  model.set_own(SelfAssessment{{{model.criterion(0).id, OwnRating::not_met}}});
  EXPECT_EQ(own(0, IconRole), "chevron_down");
  EXPECT_EQ(own(1), "–");
}

TEST(CriteriaModel, shows_yes_or_no_without_a_number_or_an_uncertainty) {
  Grade grade = test::sample_grade(81);
  grade.criteria[1].id = "contact_broken";
  grade.criteria[1].measure = {"contact_broken", true, 1, 1, "", {}};
  const CriteriaModel model(grade, {});
  const auto measured = [&](int role) { return plain(model.index(1, CriteriaModel::kMeasured).data(role).toString()); };
  EXPECT_EQ(measured(Qt::DisplayRole), "yes");
  EXPECT_EQ(measured(SecondRole), "");
  EXPECT_EQ(measured(Qt::AccessibleTextRole), "yes");
}

TEST(CriteriaModel, what_was_not_measured_is_not_zero) {
  Grade grade = test::sample_grade(81);
  grade.criteria[1].measure.measured = false;
  grade.criteria[1].points = grade.criteria[1].points_max = 0;
  grade.criteria[1].reason_code = "not_measured";
  const CriteriaModel model(grade, {});
  EXPECT_EQ(model.index(1, CriteriaModel::kMeasured).data().toString().toStdString(), "not measured");
  EXPECT_EQ(model.index(1, CriteriaModel::kPoints).data().toString().toStdString(), "no points");
  EXPECT_FALSE(model.index(1, CriteriaModel::kPoints).data(ShareRole).isValid());
}

TEST(CriteriaModel, what_was_not_measured_of_a_target_that_was_left_out_shows_the_points_that_it_costs) {
  Grade grade = test::sample_grade(81);
  grade.criteria[1].measure.measured = false;
  grade.criteria[1].points = 0;
  grade.criteria[1].reason_code = "little_drilled";
  const CriteriaModel model(grade, {});
  EXPECT_EQ(model.index(1, CriteriaModel::kMeasured).data().toString().toStdString(), "not measured");
  EXPECT_EQ(plain(model.index(1, CriteriaModel::kPoints).data().toString()), "0.0");  // 66.7 stands in the same column
  EXPECT_EQ(plain(model.index(1, CriteriaModel::kPoints).data(SecondRole).toString()), "/ 33.3");
  EXPECT_EQ(model.index(1, CriteriaModel::kSign).data(IconRole).toString().toStdString(), "minus");
}

TEST(CriteriaModel, points_sum_to_a_hundred_whatever_the_weights_sum_to) {
  Grade grade = test::sample_grade(81);
  const double weights[] = {20, 15, 15, 10, 10, 10, 10, 10, 10};  // 110, as class I had
  grade.criteria.assign(std::size(weights), grade.criteria[0]);
  for (std::size_t i = 0; i < std::size(weights); ++i) grade.criteria[i].points = grade.criteria[i].points_max = weights[i];
  const CriteriaModel model(grade, {});
  double most = 0;
  for (int row = 0; row < model.rowCount(); ++row) {
    QString shown = model.index(row, CriteriaModel::kPoints).data(SecondRole).toString();
    most += shown.remove(QStringLiteral("/ ")).toDouble();
  }
  EXPECT_NEAR(most, 100, 1e-9);
}

TEST(CriteriaModel, a_dash_stands_where_nothing_went_wrong_but_little_was_cut) {
  Grade grade = test::sample_grade(20);
  grade.criteria[1].id = "overcut_beyond_floor";
  grade.criteria[1].points = 1;
  grade.criteria[1].reason_code = "little_drilled";
  CriterionGrade weightless = grade.criteria[0];
  weightless.points = weightless.points_max = 0;
  grade.criteria.push_back(weightless);
  const CriteriaModel model(grade, {});
  for (const int row : {1, 2}) {
    EXPECT_EQ(model.index(row, CriteriaModel::kSign).data(IconRole).toString().toStdString(), "minus") << row;
    EXPECT_EQ(model.bar_role(row), Bar::Role::plain) << row;
  }
}

Advice first_advice(const ReportData& data) { return next_time(data).at(0); }

TEST(ReportData, losses_come_dearest_first) {
  ReportData data = sample(70);
  data.result.grade.criteria[0].points = 12;  // 8 lost against 6
  data.result.grade.criteria[0].reason_code = "too_little";
  const auto shown = next_time(data);
  ASSERT_EQ(shown.size(), 2u);
  EXPECT_EQ(shown[0].head.toStdString(), "Target removed: 26.7 points lost");  // 8 of 30
}

TEST(ReportData, an_opened_pulp_comes_first_with_when_and_where) {
  ReportData data = sample(70);
  data.result.scenario = *load_builtin("class-1-36");
  data.result.grade.critical = {"dry_cutting", "pulp_exposure"};
  data.critical = critical_events(data.result.grade, nullptr, {});
  data.critical[0].at_s = 72;
  data.critical[0].place_mm = Vec3(2.0, 1.5, -3.0);  // of a lower left molar: mesial and buccal
  const Advice first = first_advice(data);
  EXPECT_EQ(plain(first.head), "The pulp was exposed after 1:12 min, mesiobuccal");
  EXPECT_EQ(plain(first.why), "This fails the attempt, whatever its points. 7.2 mm deep.");  // from 4.2 mm down to -3
  EXPECT_FALSE(first.what_to_do.isEmpty());
  EXPECT_TRUE(first.grave);
  ASSERT_TRUE(first.place_mm);
}

TEST(ReportData, writes_times_of_an_hour_and_more_in_hours) {
  ReportData data = sample();
  data.result.seconds = 3700;
  EXPECT_TRUE(plain(circumstances_text(data)).starts_with("1:01:40 h")) << plain(circumstances_text(data));
  EXPECT_EQ(plain(critical_text({"pulp_exposure", 3600.0, std::nullopt}, data.result.scenario.specimen)), "The pulp was exposed after 1:00:00 h");
  data.result.seconds = 3599.9;
  EXPECT_TRUE(plain(circumstances_text(data)).starts_with("59:59 min")) << plain(circumstances_text(data));
}

TEST(ReportData, an_opened_pulp_has_its_bur_and_depth) {
  ReportData data = sample();
  data.result.scenario = *load_builtin("class-1-36");
  data.burs = {{0, 0, 30'000'000, 10'000'000}, {2, 30'000'000, 90'000'000, 20'000'000}};
  CriticalEvent event{"pulp_exposure", 72.0, Vec3(0, 0, 0.3)};
  EXPECT_EQ(plain(critical_circumstances(data, event)), "Bur 4, round, 1.4 mm, 3.9 mm deep");  // below 4.2 mm
  event.at_s.reset();
  event.place_mm.reset();
  EXPECT_TRUE(critical_circumstances(data, event).isEmpty());
}

TEST(ReportData, a_stored_attempt_knows_where_the_pulp_was_opened_from_its_criteria) {
  Grade grade = test::sample_grade(40);
  grade.critical = {"pulp_exposure"};
  CriterionGrade over = grade.criteria[1];
  over.id = "remaining_over_pulp";
  over.measure = {"remaining_over_pulp", true, 0.0, 0.04, "mm", Vec3(0.1, 0.2, -3.0)};
  grade.criteria.push_back(over);
  const auto events = critical_events(grade, nullptr, {});
  ASSERT_EQ(events.size(), 1u);
  ASSERT_TRUE(events[0].place_mm);
  EXPECT_EQ(*events[0].place_mm, Vec3(0.1, 0.2, -3.0));
  EXPECT_FALSE(events[0].at_s);
}

TEST(ReportData, the_side_of_a_tooth_follows_its_quadrant) {
  SpecimenSource tooth;
  tooth.generator = "tooth";
  const auto side = [&](int fdi, Vec3 at) {
    tooth.fdi = fdi;
    return side_text(tooth, at).toStdString();
  };
  EXPECT_EQ(side(36, {3, 0, 0}), "mesial");
  EXPECT_EQ(side(46, {3, 0, 0}), "distal");
  EXPECT_EQ(side(46, {-2, 2, 0}), "mesiobuccal");
  EXPECT_EQ(side(16, {0, -3, 0}), "palatal");
  EXPECT_EQ(side(36, {-2, -2, 0}), "distolingual");
  EXPECT_EQ(side(36, {0.3, 0.2, 0}), "");
  tooth.generator = "block";
  EXPECT_EQ(side(36, {3, 0, 0}), "");
}

TEST(ReportData, names_the_burs_and_their_times) {
  ReportData data = sample();
  data.result.scenario.instruments = {catalogue_bur("2")->bur, catalogue_bur("8")->bur, catalogue_bur("57")->bur};
  EXPECT_TRUE(burs_used_text(data).isEmpty()) << "an attempt that was not kept has no text";
  BurUse use;
  const auto put = [&use](std::uint16_t bur, int seconds) {
    StepInput input;
    input.bur = bur;
    input.elapsed_us = 1'000'000;
    input.buttons = bur == 1 ? 0 : StepInput::kCut;
    use.add(std::vector<StepInput>(static_cast<std::size_t>(seconds), input));
  };
  put(0, 72);
  put(1, 1);
  put(2, 113);
  put(1, 1);
  put(0, 5);
  data.burs = use.spans();
  const QStringList lines = burs_used_text(data);
  ASSERT_EQ(lines.size(), 2) << "the one that was merely passed is not named";
  EXPECT_EQ(plain(lines[0]), "Bur 2, round, 1.0 mm: 0:00 to 1:12, 3:07 to 3:12");
  EXPECT_EQ(plain(lines[1]), "Bur 57, straight fissure, 1.0 mm: 1:13 to 3:06");
}

TEST(ReportData, what_counts_only_with_the_target_is_one_sentence_and_nothings_are_left_out) {
  ReportData data = sample(70);
  Grade& grade = data.result.grade;
  grade.criteria[0].measure.value = 43.5;  // of the target
  grade.criteria[0].points = 5;
  grade.criteria[0].reason_code = "too_little";
  for (const char* id : {"overcut_beyond_floor", "overcut_beyond_side"}) {
    CriterionGrade follows = grade.criteria[1];
    follows.id = id;
    follows.reason_code = "little_drilled";
    follows.counts_with_target = true;
    grade.criteria.push_back(follows);
  }
  CriterionGrade nothing = grade.criteria[1];
  nothing.id = "depth_mean";
  nothing.points = 9.99;  // prints as full
  grade.criteria.push_back(nothing);
  const auto shown = next_time(data);
  ASSERT_EQ(shown.size(), 2u);
  EXPECT_TRUE(shown[0].head.startsWith(QStringLiteral("Target removed")));
  EXPECT_TRUE(shown[1].head.startsWith(QStringLiteral("Floor depth, deepest")));
  data.result.scenario.rubric.criteria = {{"target_removed", 20, {50, 80, 87, 100, 100, 100}}};
  EXPECT_EQ(plain(counted_text(grade, data.result.scenario.rubric)),
            "The rest counts for 43.5 %, because target is left.");
  grade.criteria[0].measure.value = 88;
  EXPECT_TRUE(counted_text(grade, data.result.scenario.rubric).isEmpty());
}

TEST(Paper, numbers_of_places_that_lie_together_never_cover_each_other) {
  const QPointF middle(300, 200);
  for (const QPointF at : {QPointF(310, 210), QPointF(40, 50)}) {
    std::vector<QPointF> taken;
    for (int i = 0; i < 4; ++i) taken.push_back(number_spot(at + QPointF(i, 0), middle, 2.0, taken));
    for (std::size_t i = 0; i < taken.size(); ++i) {
      EXPECT_GT(QLineF(at, taken[i]).length(), 2 * 8.0) << "the number covers its place";
      for (std::size_t j = 0; j < i; ++j) EXPECT_GE(QLineF(taken[i], taken[j]).length(), 2 * 16.0) << i << ' ' << j;
    }
  }
}

TEST(ReportData, gathers_student_attempt_and_the_best_before_from_the_records) {
  test::DeskRecords records;
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 60, 100);
  records.attempt(lena, "channel-1", 74, 100);
  records.attempt(lena, "channel-1", 90, 100, "falcon");  // another device class is never compared
  SessionResult result;
  result.scenario = *load_builtin("channel-1");
  result.grade = test::sample_grade(78);
  result.session = records.attempt(lena, "channel-1", 78, 100);
  const Actor reader = lena.actor();
  const ReportData data = gather_report(result, &records.store(), &reader);
  EXPECT_EQ(data.student.toStdString(), "Lena Brandt");
  EXPECT_EQ(data.attempt, 4);
  ASSERT_TRUE(data.before.has_value());
  EXPECT_DOUBLE_EQ(data.before->score, 74);
}

TEST(ReportPage, shows_the_score_the_reasons_and_what_to_do) {
  const Ports ports = Ports::of_the_system();
  ReportPage page(sample(), ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
  page.resize(1280, 800);
  page.show();
  EXPECT_EQ(page.findChild<QLabel*>(QStringLiteral("score"))->text().toStdString(), "81");
  QString all;
  for (const QLabel* label : page.findChildren<QLabel*>()) all += label->text() + u'\n';
  EXPECT_TRUE(all.contains(QStringLiteral("Floor depth, deepest: 20 points lost")));
  EXPECT_TRUE(plain(all).find("2.41 mm, 0.41 mm deeper than 2 mm.") != std::string::npos) << plain(all);
  EXPECT_TRUE(all.contains(QStringLiteral("Stop pushing at the required depth and move sideways.")));
  EXPECT_EQ(page.table()->chosen_row(), 1);  // the dearest loss
  QSignalSpy again(&page, &ReportPage::try_again_wanted);
  for (QPushButton* b : page.findChildren<QPushButton*>()) {
    if (b->accessibleName() == u"Try again") b->click();
  }
  EXPECT_EQ(again.count(), 1);
}

TEST(ReportPage, an_opened_pulp_is_shown_above_everything_else) {
  ReportData data = sample();
  data.result.grade.critical = {"pulp_exposure"};
  data.result.grade.passed = false;
  data.critical = critical_events(data.result.grade, nullptr, {});
  const Ports ports = Ports::of_the_system();
  ReportPage page(data, ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
  page.show();
  QString all;
  for (const QLabel* label : page.findChildren<QLabel*>()) all += label->text() + u'\n';
  EXPECT_TRUE(all.contains(QStringLiteral("The pulp was exposed.")));
}

TEST(ReportPage, saves_its_paper_where_the_picker_points_and_reports_a_failure) {
  QTemporaryDir folder;
  Ports ports = Ports::of_the_system();
  QString answer = folder.filePath(QStringLiteral("report.pdf"));
  ports.pick_file = [&](QWidget*, const FileWish& wish, std::function<void(const QString&)> then) {
    EXPECT_TRUE(wish.name.endsWith(QStringLiteral(".pdf")));
    then(answer);
  };
  ReportPage page(sample(), ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
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

TEST(ReportPage, an_attempt_that_broke_off_is_named_so_after_it_was_graded_too) {
  ReportData data = sample();
  const Ports ports = Ports::of_the_system();
  const auto all_text = [&] {
    const ReportPage page(data, ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"));
    QString all;
    for (const QLabel* label : page.findChildren<QLabel*>()) all += label->text();
    return all;
  };
  EXPECT_FALSE(all_text().contains(QStringLiteral("This attempt broke off.")));
  data.result.state = SessionState::graded;
  data.result.interrupted = true;
  EXPECT_TRUE(all_text().contains(QStringLiteral("This attempt broke off.")));
  data.result.grade.critical = {"pulp_exposure"};
  data.critical = critical_events(data.result.grade, nullptr, {});
  EXPECT_TRUE(all_text().contains(QStringLiteral("The pulp was exposed.")));
  EXPECT_TRUE(all_text().contains(QStringLiteral("This attempt broke off."))) << all_text().toStdString();
}

TEST(ReportPage, promises_no_comparison_with_an_attempt_that_is_not_kept) {
  ReportData data = sample();
  const Ports ports = Ports::of_the_system();
  const auto promises = [&] {
    const ReportPage page(data, ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
    return std::ranges::any_of(page.findChildren<QLabel*>(), [](const QLabel* l) { return l->text().contains(QStringLiteral("From the next one on")); });
  };
  EXPECT_TRUE(promises());
  data.attempt = 0;
  EXPECT_FALSE(promises());
  data = sample();
  data.alone = true;  // in an appeal pack
  EXPECT_FALSE(promises());
}

TEST(ReportPage, suggests_a_file_name_that_is_no_path) {
  Ports ports = Ports::of_the_system();
  QString name;
  ports.pick_file = [&](QWidget*, const FileWish& wish, const std::function<void(const QString&)>&) { name = wish.name; };
  ReportData data = sample();
  data.title = QStringLiteral("Class II, MO/DO");
  ReportPage page(data, ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
  for (QPushButton* b : page.findChildren<QPushButton*>())
    if (b->accessibleName() == u"Save as PDF") b->click();
  EXPECT_EQ(name.toStdString(), "Class II, MO-DO 2026-11-20 10-14.pdf");
}

TEST(AgainstBefore, compares_shares_and_gives_the_points_gained) {
  Grade before = test::sample_grade(70);
  before.criteria[1].points = 1;
  const AgainstBefore view(test::sample_grade(81), before);
  ASSERT_EQ(view.rows().size(), 2);
  EXPECT_DOUBLE_EQ(view.rows()[1].before, 0.1);
  EXPECT_DOUBLE_EQ(view.rows()[1].now, 0.4);
  EXPECT_NEAR(view.rows()[1].points, 10, 1e-9);  // 3 of 30
  EXPECT_TRUE(view.accessibleDescription().contains(QStringLiteral("+10")));
}

}  // namespace
}  // namespace cusp::test
