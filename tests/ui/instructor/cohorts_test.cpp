#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/looks.h"
#include "ui/instructor/cohorts_page.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDateTimeEdit>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTest>

#include "ui/instructor/number_list.h"
#include "ui/student/course.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

class Cohorts : public testing::Test {
 protected:
  Cohorts() {
    lena = records.student("4711", "Lena Brandt");
    omar = records.student("K-12", "Omar Said");
    instructor = *records.store().accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""});
    ports.now = [] { return QDateTime(QDate(2026, 11, 20), QTime(9, 0)); };
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked = question.what;
      then(true);
    };
  }
  std::vector<Account> students() { return {lena, omar}; }
  /// channel-1 as it comes, and a deeper one as its next version.
  std::pair<ScenarioVersion, ScenarioVersion> two_versions() {
    Scenarios& scenarios = records.store().scenarios;
    Scenario scenario = *load_builtin("channel-1");
    const auto before = scenarios.ensure(scenario, canonical_json(scenario), content_hash(scenario).bytes);
    EXPECT_TRUE(before);
    scenario.version = before->number + 1;
    scenario.target.outline.depth_mm = 2.2;
    const auto newer = scenarios.publish(instructor.actor(), scenario, canonical_json(scenario), content_hash(scenario).bytes);
    EXPECT_TRUE(newer);
    return {*before, *newer};
  }

  DeskRecords records;
  Account lena, omar, instructor;
  Ports ports;
  QString asked;
};

TEST_F(Cohorts, NumbersAreReadFromLinesAndListsWithNamesBesideThem) {
  const NumberList list = read_numbers(QStringLiteral("Brandt, Lena; 4711\n k-12 , 4711\n"), students(), {});
  ASSERT_EQ(list.found.size(), 2u);
  EXPECT_EQ(list.found[0].name, "Lena Brandt");
  EXPECT_EQ(list.found[1].name, "Omar Said");
  EXPECT_TRUE(list.unknown.isEmpty());
}

TEST_F(Cohorts, ANumberWithABlankIsReadWhole) {
  const Account mia = records.student("S 4711", "Mia Falk");
  const NumberList list = read_numbers(QStringLiteral("s 4711 Falk, Mia\n"), {lena, omar, mia}, {});
  ASSERT_EQ(list.found.size(), 1u);
  EXPECT_EQ(list.found[0].name, "Mia Falk") << "4711 is Lena Brandt";
  EXPECT_TRUE(list.unknown.isEmpty());
}

TEST_F(Cohorts, WhatIsNoNumberIsNamedAndWhoIsInsideIsCounted) {
  const NumberList list = read_numbers(QStringLiteral("4711\n9999 Nobody\njust words\n\n"), students(), {lena.id});
  EXPECT_TRUE(list.found.empty());
  EXPECT_EQ(list.already, 1);
  EXPECT_EQ(list.unknown, (QStringList{QStringLiteral("9999"), QStringLiteral("just words")}));
}

TEST_F(Cohorts, StandInTheOrderOfTheirNumbers) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  for (const char* name : {"Group 10", "group 2", "Group 1", "Äsculap"}) page.make_cohort(QString::fromUtf8(name));
  QStringList names;
  for (int row = 0; row < page.cohorts().rowCount(); ++row) names += QString::fromStdString(page.cohorts().cohort(row).name);
  EXPECT_EQ(names.join(u'|').toStdString(), "Äsculap|Group 1|group 2|Group 10");
}

TEST_F(Cohorts, AreMadeWithANameThatNoOtherHas) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("  "));
  EXPECT_TRUE(page.message().contains(QStringLiteral("needs a name")));
  page.make_cohort(QStringLiteral("Year 3"));
  ASSERT_EQ(page.cohorts().rowCount(), 1);
  page.make_cohort(QStringLiteral("year 3"));
  EXPECT_TRUE(page.message().contains(QStringLiteral("already"))) << page.message().toStdString();
  EXPECT_EQ(page.cohorts().rowCount(), 1);
}

TEST_F(Cohorts, TakeStudentsInByTheirNumbersAndOutAfterAQuestion) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.add_numbers(QStringLiteral("4711\nK-12\n8888"));
  ASSERT_EQ(page.students().rowCount(), 2);
  EXPECT_TRUE(page.message().contains(QStringLiteral("8888")));
  EXPECT_EQ(page.cohorts().cohort(0).students, 2);
  page.add_numbers(QStringLiteral(" \n"));
  EXPECT_TRUE(page.message().startsWith(QStringLiteral("No student number is there"))) << page.message().toStdString();
  for (Table* table : page.findChildren<Table*>())
    if (table->model() == &page.students()) table->choose_row(0);
  page.remove_chosen_student();
  EXPECT_TRUE(asked.contains(QStringLiteral("Lena Brandt"))) << asked.toStdString();
  ASSERT_EQ(page.students().rowCount(), 1);
  EXPECT_EQ(page.students().student(0).name, "Omar Said");
}

TEST_F(Cohorts, HaveOutWhomAnotherDeskTookOutMeanwhile) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.add_numbers(QStringLiteral("4711"));
  for (Table* table : page.findChildren<Table*>())
    if (table->model() == &page.students()) table->choose_row(0);
  ports.ask = [&](QWidget*, const Question&, const std::function<void(bool)>& then) {
    EXPECT_TRUE(records.store().cohorts.remove(instructor.actor(), page.cohorts().cohort(0).id, lena.id));
    then(true);
  };
  page.remove_chosen_student();
  EXPECT_EQ(page.students().rowCount(), 0);
  EXPECT_EQ(page.message().toStdString(), "Lena Brandt is taken out.");
}

TEST_F(Cohorts, AnAssignedExerciseStandsWithItsDayInTheCourseOfTheirStudentsAlone) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.add_numbers(QStringLiteral("4711"));
  const auto exercises = load_exercises(records.store());
  ASSERT_TRUE(exercises);
  const ScenarioId wanted = exercises->exercises[3].scenario.id;
  page.form()->choose_exercise(wanted);
  const QDateTime due(QDate(2026, 12, 4), QTime(18, 0));
  page.form()->choose_due(due);
  page.assign();
  ASSERT_EQ(page.assignments().rowCount(), 1) << page.message().toStdString();
  const auto due_of = [&](const Account& student) {
    const auto course = load_course(records.store(), student.actor());
    for (const CourseRow& row : course->rows)
      if (row.exercise.scenario.id == wanted) return row.due_utc_us;
    return std::optional<std::int64_t>();
  };
  EXPECT_EQ(due_of(lena), due.toMSecsSinceEpoch() * 1000);
  EXPECT_EQ(due_of(omar), std::nullopt);
}

TEST_F(Cohorts, AnAssignmentAdmitsTheDevicesThatTheFormChecks) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.assign();
  page.form()->choose_devices({"falcon", "inverse3"});
  page.assign();
  ASSERT_EQ(page.assignments().rowCount(), 2) << page.message().toStdString();
  EXPECT_TRUE(page.assignments().row(0).assignment.device_classes.empty()) << "a device of a later version is admitted too";
  EXPECT_EQ(page.assignments().row(1).assignment.device_classes, (std::vector<std::string>{"falcon", "inverse3"}));
  const auto aside = [&](int row) {
    for (Table* table : page.findChildren<Table*>())
      if (table->model() == &page.assignments()) table->choose_row(row);
    for (const QLabel* label : page.findChildren<QLabel*>())
      if (label->text().startsWith(QStringLiteral("only with"))) return label->text().toStdString();
    return std::string();
  };
  EXPECT_EQ(aside(1), "only with Falcon, Inverse3");
  EXPECT_EQ(aside(0), "");
  page.form()->choose_devices({"none of them"});
  page.assign();
  EXPECT_EQ(page.assignments().rowCount(), 2);
  EXPECT_TRUE(page.message().contains(QStringLiteral("No device is admitted")));
}

TEST_F(Cohorts, AreAssignedTheSameOnlyOnceWhileItIsOpen) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.form()->choose_kind(SessionKind::assessment);
  page.assign();
  EXPECT_FALSE(page.form()->act()->isEnabled());
  page.assign();
  EXPECT_EQ(page.assignments().rowCount(), 1);
  EXPECT_TRUE(page.message().contains(QStringLiteral("already"))) << page.message().toStdString();
  page.form()->choose_due(QDateTime(QDate(2026, 12, 5), QTime(18, 0)));
  EXPECT_TRUE(page.form()->act()->isEnabled());
  page.assign();
  EXPECT_EQ(page.assignments().rowCount(), 2);
  ports.now = [] { return QDateTime(QDate(2026, 12, 4), QTime(20, 0)); };  // the first is over
  page.form()->choose_due(QDateTime(QDate(2026, 12, 5), QTime(18, 0)));
  page.assign();
  EXPECT_EQ(page.assignments().rowCount(), 2) << "the second is open";
  page.form()->choose_due(QDateTime(QDate(2026, 12, 6), QTime(18, 0)));
  page.assign();
  EXPECT_EQ(page.assignments().rowCount(), 3);
}

TEST_F(Cohorts, LoseAWithdrawnAssignmentAndMayHaveItAgain) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.add_numbers(QStringLiteral("4711"));
  page.assign();
  const auto assigned_to = [&](const Account& student) {
    const auto course = load_course(records.store(), student.actor());
    return std::ranges::count_if(course->rows, [](const CourseRow& row) { return row.assignment.has_value(); });
  };
  ASSERT_EQ(assigned_to(lena), 1);
  for (Table* table : page.findChildren<Table*>())
    if (table->model() == &page.assignments()) table->choose_row(0);
  page.withdraw_chosen_assignment();
  EXPECT_TRUE(asked.startsWith(QStringLiteral("Withdraw "))) << asked.toStdString();
  EXPECT_EQ(assigned_to(lena), 0);
  EXPECT_EQ(page.assignments().index(0, AssignmentsModel::kDue).data().toString(), QStringLiteral("withdrawn"));
  page.assign();
  EXPECT_EQ(page.assignments().rowCount(), 2) << page.message().toStdString();
  EXPECT_EQ(assigned_to(lena), 1);
}

TEST_F(Cohorts, AreAssignedNoVersionThatAnotherDeskWithdrewMeanwhile) {
  const auto [before, newer] = two_versions();
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.form()->choose_exercise(newer.scenario);
  ASSERT_EQ(page.form()->wish().exercise.version, newer.id);
  ASSERT_TRUE(records.store().scenarios.withdraw(instructor.actor(), newer.id));
  page.assign();
  EXPECT_EQ(page.assignments().rowCount(), 0);
  EXPECT_TRUE(page.message().contains(QStringLiteral("Version %1 of ").arg(newer.number))) << page.message().toStdString();
  EXPECT_TRUE(page.message().contains(QStringLiteral("The form has version %1 now.").arg(before.number))) << page.message().toStdString();
  EXPECT_EQ(page.form()->wish().exercise.scenario.id, newer.scenario) << "it stays chosen";
  page.assign();
  ASSERT_EQ(page.assignments().rowCount(), 1) << page.message().toStdString();
  EXPECT_EQ(page.assignments().row(0).assignment.version, before.id);
}

TEST_F(Cohorts, AreNotSaidToHaveAVersionAlreadyThatWasWithdrawnSinceItWasAssigned) {
  const auto [before, newer] = two_versions();
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.form()->choose_exercise(newer.scenario);
  page.assign();
  ASSERT_EQ(page.assignments().rowCount(), 1) << page.message().toStdString();
  ASSERT_TRUE(records.store().scenarios.withdraw(instructor.actor(), newer.id));
  page.assign();
  EXPECT_FALSE(page.message().contains(QStringLiteral("already"))) << page.message().toStdString();
  EXPECT_TRUE(page.message().contains(QStringLiteral("The form has version %1 now.").arg(before.number))) << page.message().toStdString();
  EXPECT_TRUE(page.form()->act()->isEnabled()) << "it assigns another version";
  page.assign();
  EXPECT_EQ(page.assignments().rowCount(), 2) << page.message().toStdString();
}

TEST_F(Cohorts, HaveInTheirFormWhatAnotherDeskPublishedMeanwhile) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.assign();
  page.read_again();
  EXPECT_FALSE(page.form()->act()->isEnabled()) << "the same version is assigned";
  Scenario scenario = page.form()->wish().exercise.scenario;
  scenario.version += 1;
  scenario.title["en"] += " again";
  ASSERT_TRUE(records.store().scenarios.publish(instructor.actor(), scenario, canonical_json(scenario), content_hash(scenario).bytes));
  page.read_again();
  EXPECT_EQ(page.form()->wish().exercise.scenario.title.at("en"), scenario.title["en"]);
  EXPECT_TRUE(page.form()->act()->isEnabled());
}

TEST_F(Cohorts, AreAssignedNothingThatIsOverAlready) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.form()->choose_due(QDateTime(QDate(2026, 11, 20), QTime(8, 59)));  // a minute ago
  page.assign();
  EXPECT_EQ(page.assignments().rowCount(), 0);
  EXPECT_TRUE(page.message().contains(QStringLiteral("over already"))) << page.message().toStdString();
  page.form()->choose_due(QDateTime(QDate(2026, 11, 20), QTime(9, 30)));
  page.assign();
  EXPECT_EQ(page.assignments().rowCount(), 1) << page.message().toStdString();
}

TEST_F(Cohorts, WidenThePageByNoLongName) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.resize(1080, 740);
  page.show();
  QApplication::processEvents();
  const int usual = page.minimumSizeHint().width();
  const QString name(63, u'W');
  page.make_cohort(name);
  page.add_numbers(QStringLiteral("4711"));  // another message, without the name
  QApplication::processEvents();
  EXPECT_LE(page.minimumSizeHint().width(), usual);
  const auto labels = page.findChildren<QLabel*>();
  const auto aside = std::ranges::find_if(labels, [&](const QLabel* label) { return label->accessibleName() == name; });
  ASSERT_TRUE(aside != labels.end());
  EXPECT_TRUE((*aside)->text().endsWith(u'…')) << (*aside)->text().toStdString();
  EXPECT_TRUE((*aside)->toolTip().contains(name));
}

TEST_F(Cohorts, ShowTheMonthsOfTheLanguage) {
  install_language(*qApp, QStringLiteral("de"));
  CohortsPage page(records.store(), instructor.actor(), ports);
  for (const QDateTimeEdit* when : page.form()->findChildren<QDateTimeEdit*>()) {
    EXPECT_EQ(when->locale().language(), QLocale::German);
    EXPECT_TRUE(when->displayFormat().startsWith(QStringLiteral("d. MMM"))) << when->displayFormat().toStdString();
  }
  install_language(*qApp, QStringLiteral("en"));
}

TEST_F(Cohorts, TheDatesOfAnAssignmentStandApartFromTheFieldAbove) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.resize(1280, 720);
  page.show();
  QTest::qWait(0);
  const QWidget* form = page.form();
  for (const QCheckBox* on : form->findChildren<QCheckBox*>()) {
    if (on->text() != QStringLiteral("Open from") && on->text() != QStringLiteral("Due")) continue;
    int above = 0;  // lower edge of the field before
    for (const QWidget* field : form->findChildren<QWidget*>())
      if (const int edge = field->mapTo(form, QPoint(0, field->height())).y(); field->isVisible() && edge <= on->mapTo(form, QPoint()).y()) above = std::max(above, edge);
    EXPECT_GE(on->mapTo(form, QPoint()).y() - above, 8) << on->text().toStdString();
  }
}

TEST_F(Cohorts, AnAssessmentMayAskForASelfTestAndAPracticeMayNot) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.form()->choose_self_test(30);
  page.assign();
  page.form()->choose_kind(SessionKind::assessment);
  page.assign();
  ASSERT_EQ(page.assignments().rowCount(), 2) << page.message().toStdString();
  EXPECT_FALSE(page.assignments().row(0).assignment.self_test_days);
  EXPECT_EQ(page.assignments().row(1).assignment.self_test_days, 30);
}

TEST_F(Cohorts, FitHalfOfFullHdInGermanWithTheDevicesOfAnAssignment) {
  install_language(*qApp, QStringLiteral("de"));
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  page.form()->choose_devices({"falcon", "mouse"});
  page.assign();
  page.show();
  const auto cut = [&page] {
    int out = 0;
    for (Table* table : page.findChildren<Table*>()) out += table->model() == &page.cohorts() ? table->horizontalScrollBar()->maximum() : 0;
    return out;
  };
  page.resize(1080, 740);
  QApplication::processEvents();
  EXPECT_EQ(cut(), 0);
  for (int i = 0; i < 2; ++i) {  // the form goes below once the page is narrow, and then it needs less
    page.resize(kPageAtHalfOfFullHd);
    QApplication::processEvents();
  }
  for (Table* table : page.findChildren<Table*>())
    if (table->model() == &page.assignments()) table->choose_row(0);
  QApplication::processEvents();
  EXPECT_LE(page.minimumSizeHint().width(), kPageAtHalfOfFullHd.width());
  EXPECT_EQ(cut(), 0);
  install_language(*qApp, QStringLiteral("en"));
}

TEST_F(Cohorts, AnAssessmentOfATemplatesExerciseMayDrawATooth) {
  CohortsPage page(records.store(), instructor.actor(), ports);
  page.make_cohort(QStringLiteral("Year 3"));
  AssignmentForm& form = *page.form();
  const auto assigned = [&](const char* key, SessionKind kind) {
    form.choose_exercise(load_builtin(key)->id);
    form.choose_kind(kind);
    form.choose_drawn_tooth();
    page.assign();
    return page.assignments().row(page.assignments().rowCount() - 1).assignment.drawn_tooth;
  };
  const auto says = [&](const QString& words) {
    return std::ranges::any_of(form.findChildren<QLabel*>(), [&](const QLabel* l) { return !l->isHidden() && l->text().contains(words); });
  };
  EXPECT_TRUE(assigned("class-1-46", SessionKind::assessment));
  EXPECT_FALSE(says(QStringLiteral("own tooth")));
  EXPECT_FALSE(assigned("class-1-46", SessionKind::practice));
  EXPECT_FALSE(assigned("class-1-36", SessionKind::assessment));
  EXPECT_TRUE(says(QStringLiteral("no template made this exercise")));
}

TEST_F(Cohorts, AnAdministratorMakesCohortsAndAssignsNothing) {
  CohortsPage page(records.store(), records.administrator().actor(), ports);
  EXPECT_EQ(page.form(), nullptr);
  page.make_cohort(QStringLiteral("Year 3"));
  EXPECT_EQ(page.cohorts().rowCount(), 1);
}

}  // namespace
}  // namespace cusp::test
