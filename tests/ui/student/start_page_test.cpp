// The start page's cards of interrupted attempts, what they keep from practice, and the last result against the best.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

#include "scenarios/format/content_hash.h"
#include "scenarios/grading/maxima.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/student/start_page_cards.h"
#include "ui/student/briefing.h"
#include "ui/student/interrupted_card.h"
#include "ui/student/start_page.h"
#include "ui/text/grade_text.h"
#include "ui/text/names.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

QString texts_of(const QWidget& page) {
  QString all;
  for (const QLabel* label : page.findChildren<QLabel*>()) all += label->text() + u'\n';
  for (const Chip* chip : page.findChildren<Chip*>()) all += chip->text() + u'\n';
  return all;
}

QString plain(QString text) { return text.remove(QChar(0x2066)).remove(QChar(0x2069)); }

QPushButton* button(const QWidget& page, const QString& text) {
  for (QPushButton* b : page.findChildren<QPushButton*>())
    if (b->text() == text) return b;
  return nullptr;
}

TEST_F(StartPageCards, an_attempt_that_broke_off_after_an_hour_has_its_hours) {
  records.broken_attempt(lena, "paper-block");
  HistoryRow row = load_course(records.store(), lena.actor())->interrupted.at(0);
  row.elapsed_us = 3'700'000'000;
  const InterruptedCard practice(records.store(), row, InterruptedWay::resume, "pointer", ButtonKind::primary);
  EXPECT_TRUE(plain(texts_of(practice)).contains(QStringLiteral("It broke off after 1:01:40 h"))) << texts_of(practice).toStdString();
  row.kind = SessionKind::assessment;
  const InterruptedCard assessment(records.store(), row, InterruptedWay::resume, "pointer", ButtonKind::primary);
  EXPECT_TRUE(plain(texts_of(assessment)).contains(QStringLiteral("It broke off after 1:01:40 h. All of it is kept."))) << texts_of(assessment).toStdString();
}

TEST_F(StartPageCards, an_exercise_whose_name_reads_like_a_placeholder_keeps_it) {
  records.broken_attempt(lena, "paper-block");
  HistoryRow row = load_course(records.store(), lena.actor())->interrupted.at(0);
  row.title = {{"en", "Channel of 50 %1"}};
  const InterruptedCard card(records.store(), row, InterruptedWay::resume, "pointer", ButtonKind::primary);
  EXPECT_TRUE(plain(texts_of(card)).contains(QStringLiteral("Channel of 50 %1, attempt ") + QString::number(row.attempt))) << texts_of(card).toStdString();
}

TEST_F(StartPageCards, the_list_scrolls_with_the_page_and_its_keys_take_the_page_along) {
  page();
  shown->resize(1080, 672);  // of a window of 1280 x 720
  shown->show();
  shown->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(shown.get()));
  Table* table = shown->table();
  const int rows = table->model()->rowCount();
  ASSERT_GT(rows, 8);
  EXPECT_EQ(table->verticalScrollBar()->maximum(), 0);
  const auto* area = shown->findChild<QScrollArea*>();
  ASSERT_GT(area->verticalScrollBar()->maximum(), 0);
  table->setFocus();
  const auto in_view = [&](int row) {
    const QRect cell = table->visualRect(table->model()->index(row, CourseModel::kExercise));
    const QRect there(table->viewport()->mapTo(area->viewport(), cell.topLeft()), cell.size());
    return area->viewport()->rect().contains(QRect(0, there.top(), 1, there.height()));
  };
  QTest::keyClick(table, Qt::Key_End, Qt::ControlModifier);
  EXPECT_EQ(table->currentIndex().row(), rows - 1);
  EXPECT_TRUE(in_view(rows - 1));
  QTest::keyClick(table, Qt::Key_Home, Qt::ControlModifier);
  EXPECT_TRUE(in_view(0));
}

TEST_F(StartPageCards, a_page_says_when_an_assessment_opens_and_one_made_then_offers_its_start) {
  const std::int64_t opens_ms = now.toMSecsSinceEpoch();
  const auto later = records.store().assignments.create(
      examiner, {.version = exam.version, .cohort = exam.cohort, .kind = SessionKind::assessment, .opens_utc_us = opens_ms * 1000}, "4712");
  ASSERT_TRUE(later);
  now = QDateTime::fromMSecsSinceEpoch(opens_ms - 20);
  page();
  const auto starts = [&] {
    int buttons = 0;
    for (const AssessmentCard* card : shown->findChildren<AssessmentCard*>()) buttons += card->start_button() != nullptr ? 1 : 0;
    return buttons;
  };
  EXPECT_EQ(starts(), 1) << "the other one is open";
  QSignalSpy opened(shown.get(), &StartPage::assessment_opened);
  ASSERT_TRUE(opened.wait());
  now = QDateTime::fromMSecsSinceEpoch(opens_ms);
  page();
  EXPECT_EQ(starts(), 2);
  QSignalSpy again(shown.get(), &StartPage::assessment_opened);
  EXPECT_FALSE(again.wait(50)) << "once";
}

TEST_F(StartPageCards, an_interrupted_assessment_stands_above_a_newer_interrupted_practice) {
  const SessionId assessment = broken_off();
  records.broken_attempt(lena, "paper-block");
  const SessionId practice = records.broken_attempt(lena, "paper-block");
  const Course course = *load_course(records.store(), lena.actor());
  ASSERT_EQ(course.interrupted.size(), 2u);
  EXPECT_EQ(course.interrupted[0].session, assessment);
  EXPECT_EQ(course.interrupted[1].session, practice);
  EXPECT_TRUE(texts_of(*page()).contains(QStringLiteral("Interrupted: continue it below")));
  const auto cards = shown->findChildren<InterruptedCard*>();
  ASSERT_EQ(cards.size(), 2);
  std::vector<SessionId> resumed;
  QObject::connect(shown.get(), &StartPage::resume_wanted, [&](const SessionId& id) { resumed.push_back(id); });
  for (const InterruptedCard* card : cards) card->primary()->click();
  EXPECT_EQ(resumed, (std::vector{assessment, practice}));
  int primary = 0;
  for (const QPushButton* b : shown->findChildren<QPushButton*>()) primary += b->property("kind") == QStringLiteral("primary") ? 1 : 0;
  EXPECT_EQ(primary, 1);
}

TEST_F(StartPageCards, an_interrupted_assessment_that_this_device_cannot_continue_promises_nothing_else) {
  broken_off();
  const StartPage other(records.store(), lena, pictures, now, "falcon");
  EXPECT_TRUE(texts_of(other).contains(QStringLiteral("Interrupted: see below"))) << texts_of(other).toStdString();
  EXPECT_FALSE(texts_of(other).contains(QStringLiteral("continue it below")));
  EXPECT_EQ(other.findChildren<InterruptedCard*>().size(), 1) << "it can be handed in";
}

TEST_F(StartPageCards, an_open_assessment_has_the_one_primary_button_beside_an_interrupted_practice) {
  records.broken_attempt(lena, "paper-block");
  page();
  ASSERT_EQ(shown->findChildren<InterruptedCard*>().size(), 1);
  QStringList primary;
  for (const QPushButton* b : shown->findChildren<QPushButton*>())
    if (b->property("kind") == QStringLiteral("primary")) primary += b->accessibleName();
  EXPECT_EQ(primary.join(u'|').toStdString(), "Start assessment");
}

TEST_F(StartPageCards, the_picture_of_the_next_exercise_is_as_high_as_the_text_beside_it) {
  page();
  shown->resize(1080, 752);
  shown->show();
  const auto picture = [&] {
    QLabel* out = nullptr;
    for (QLabel* label : shown->findChildren<QLabel*>())
      if (label->accessibleName() == QStringLiteral("The tooth with its target")) out = label;
    return out;
  };
  ASSERT_NE(picture(), nullptr);
  QLabel* briefing = nullptr;
  for (QLabel* label : picture()->parentWidget()->findChildren<QLabel*>())
    if (label->wordWrap() && briefing == nullptr) briefing = label;
  ASSERT_NE(briefing, nullptr);
  briefing->setText(QStringLiteral("A line of a long briefing. ").repeated(30));
  QTest::qWait(0);
  const QWidget* card = picture()->parentWidget();
  EXPECT_GT(card->height(), 300);
  EXPECT_EQ(picture()->height(), card->height() - 4);  // within the card's line and 1 px beside it
  EXPECT_EQ(picture()->pixmap().deviceIndependentSize().toSize(), picture()->size());
  briefing->setText(QStringLiteral("A short one."));
  QTest::qWait(0);
  EXPECT_EQ(picture()->height(), card->height() - 4);
  EXPECT_GE(picture()->height(), 226);
  EXPECT_LT(card->height(), 300);
}

TEST_F(StartPageCards, no_line_of_a_briefing_ends_between_a_figure_and_its_unit) {
  Scenario s;
  s.briefing = {{"en", "A channel 2.0 mm deep, 0.5 mm wide at 20 % of the length, in 5 min; 3 minor steps."}};
  EXPECT_EQ(briefing_text(s).replace(QChar::Nbsp, u'_').toStdString(), "A channel 2.0_mm deep, 0.5_mm wide at 20_% of the length, in 5_min; 3 minor steps.");
}

TEST_F(StartPageCards, the_picture_of_an_imported_specimen_is_drawn_from_its_unpacked_file) {
  Store& store = records.store();
  Scenario imported = *load_builtin("channel-1");
  imported.expected_time_s += 60;
  const auto hash = store.blobs.put(std::vector<std::byte>(8));
  const auto version = store.scenarios.publish(examiner, imported, canonical_json(imported), content_hash(imported).bytes, {{"tooth.nrrd", *hash}});
  ASSERT_TRUE(version);
  const StartPage start(store, lena, pictures, now, "pointer", cache.path().toStdString());
  EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(cache.path().toStdString()) / version->id.text() / "tooth.nrrd"));
}

TEST_F(StartPageCards, an_interrupted_assessment_is_handed_in_and_shows_no_removed_volume) {
  broken_off();
  const auto* card = page()->interrupted();
  ASSERT_NE(card, nullptr);
  EXPECT_TRUE(texts_of(*card).contains(QStringLiteral("Interrupted assessment")));
  EXPECT_FALSE(texts_of(*card).contains(QStringLiteral("mm"))) << texts_of(*card).toStdString();
  EXPECT_NE(button(*card, QStringLiteral("Hand in")), nullptr);
  EXPECT_EQ(button(*card, QStringLiteral("Grade as it stands")), nullptr);
}

TEST_F(StartPageCards, an_interrupted_attempt_that_an_older_program_has_ended_is_graded_and_not_continued) {
  const SessionId session = records.broken_attempt(lena, "paper-block");
  ASSERT_TRUE(records.store().database().run("INSERT INTO final_volumes VALUES (?1, 0, 1, 1, x'00')", session));
  const auto* card = page()->interrupted();
  ASSERT_NE(card, nullptr);
  EXPECT_EQ(button(*card, QStringLiteral("Continue")), nullptr);
  EXPECT_EQ(card->primary()->text(), QStringLiteral("Grade as it stands"));
  EXPECT_TRUE(texts_of(*card).contains(QStringLiteral("An older version of Cusp ended it"))) << texts_of(*card).toStdString();
}

TEST_F(StartPageCards, the_keyboard_begins_on_the_list_where_nothing_can_be_started) {
  page();
  EXPECT_NE(shown->focusProxy(), shown->table()) << "an assessment is open";
  sit();  // it runs in another window
  ASSERT_FALSE(page()->start_button()->isEnabled());
  ASSERT_EQ(shown->interrupted(), nullptr);
  ASSERT_NE(shown->table(), nullptr);
  EXPECT_EQ(shown->focusProxy(), shown->table());
}

TEST_F(StartPageCards, an_assessment_that_is_not_handed_in_keeps_its_exercise_from_practice) {
  EXPECT_FALSE(refusal("channel-1"));
  EXPECT_TRUE(page()->start_button()->isEnabled()) << "the next exercise is channel-1";
  const SessionId session = sit();
  ASSERT_TRUE(refusal("channel-1"));
  EXPECT_TRUE(refusal("channel-1")->more.contains(QStringLiteral("another window"))) << refusal("channel-1")->more.toStdString();
  EXPECT_FALSE(refusal("channel-1")->more.contains(QStringLiteral("start page"))) << "it cannot be continued there";
  ASSERT_TRUE(records.store().sessions.interrupt(session, "left"));
  const auto why = refusal("channel-1");
  ASSERT_TRUE(why);
  EXPECT_FALSE(refusal("paper-block"));
  EXPECT_FALSE(page()->start_button()->isEnabled());
  EXPECT_TRUE(texts_of(*shown).contains(why->line()));
  Exercise exercise;
  exercise.scenario = *load_builtin("channel-1");
  const Briefing briefing(exercise, pictures, {}, std::make_shared<ToothCache>(std::filesystem::path()), why->line());
  EXPECT_FALSE(briefing.start_button()->isEnabled());
  EXPECT_EQ(briefing.watch_button(), nullptr);
  EXPECT_TRUE(texts_of(briefing).contains(why->line()));
  ASSERT_TRUE(records.store().grades.save(session, sample_grade(80), Hash256{}));
  EXPECT_FALSE(refusal("channel-1"));
}

TEST_F(StartPageCards, a_briefing_gives_the_time_limit_as_a_duration) {
  Exercise exercise;
  exercise.scenario = *load_builtin("channel-1");
  exercise.scenario.time_limit_s = 1200;
  const Briefing briefing(exercise, pictures, {}, std::make_shared<ToothCache>(std::filesystem::path()));
  EXPECT_TRUE(plain(texts_of(briefing)).contains(QStringLiteral("20:00 min at most"))) << "20:00 alone is an hour of the day";
}

TEST_F(StartPageCards, time_is_said_to_earn_no_points_only_where_no_criterion_asks_for_it) {
  const QString none = QStringLiteral("ime earns no points");
  Exercise exercise;
  exercise.scenario = *load_builtin("channel-1");
  ASSERT_EQ(exercise.scenario.time_limit_s, 0);
  const auto said = [&] {
    const Briefing briefing(exercise, pictures, {}, std::make_shared<ToothCache>(std::filesystem::path()));
    return texts_of(briefing);
  };
  EXPECT_TRUE(said().contains(none));
  records.attempt(lena, "channel-1", 80, 300);
  EXPECT_TRUE(texts_of(*page()).contains(none));
  exercise.scenario.rubric.criteria.push_back({"time", 10, {0, 0, 0, 300, 600, 900}});
  EXPECT_FALSE(said().contains(none)) << said().toStdString();
  const Scenario& timed = exercise.scenario;
  ASSERT_TRUE(records.store().scenarios.ensure(timed, canonical_json(timed), content_hash(timed).bytes));
  EXPECT_FALSE(texts_of(*page()).contains(none)) << texts_of(*shown).toStdString();
  EXPECT_TRUE(texts_of(*shown).contains(QStringLiteral("only, 1 attempt")));
}

TEST_F(StartPageCards, an_assessment_that_cannot_be_continued_here_is_the_invigilators_and_keeps_no_exercise) {
  const SessionId session = sit(kEngineVersion - 1);
  ASSERT_TRUE(records.store().sessions.interrupt(session, "left"));
  EXPECT_TRUE(texts_of(*page()).contains(QStringLiteral("Interrupted: ask the invigilator")));
  EXPECT_EQ(shown->interrupted(), nullptr);
  EXPECT_FALSE(refusal("channel-1"));
}

TEST_F(StartPageCards, the_way_into_an_attempt_that_runs_is_not_offered_nor_called_a_report_before_it_is_handed_in) {
  const SessionId session = sit();
  AttemptsModel model;
  const auto opening = [&](int role) {
    model.set_rows(*records.store().history.list(lena.actor()));
    return model.index(0, AttemptsModel::kOpen).data(role).toString();
  };
  EXPECT_EQ(opening(IconRole), QString());
  EXPECT_EQ(opening(Qt::AccessibleTextRole), QString());
  ASSERT_TRUE(records.store().sessions.interrupt(session, "left"));
  EXPECT_NE(opening(IconRole), QString());
  EXPECT_EQ(opening(Qt::AccessibleTextRole), QStringLiteral("Open"));
  ASSERT_TRUE(records.store().grades.save(session, sample_grade(80), Hash256{}));
  EXPECT_EQ(opening(Qt::AccessibleTextRole), QStringLiteral("Report"));
}

TEST_F(StartPageCards, what_an_examiner_changed_is_not_advised_about) {
  Grade grade = sample_grade(80);
  ASSERT_EQ(loss_reasons(grade).size(), 1u);
  const CriterionGrade& lost = grade.criteria[loss_reasons(grade)[0].criterion];
  const SessionId session = records.graded_attempt(lena, "channel-1", grade, 300);
  ASSERT_TRUE(texts_of(*page()).contains(advice_text(lost))) << texts_of(*shown).toStdString();
  ASSERT_TRUE(records.store().statements.override_points(examiner, session, lost.id, 0.5 * lost.points_max, "The block was worn."));
  EXPECT_FALSE(texts_of(*page()).contains(advice_text(lost)));
  EXPECT_TRUE(texts_of(*shown).contains(QStringLiteral("An examiner changed the points"))) << texts_of(*shown).toStdString();
}

TEST_F(StartPageCards, full_points_are_claimed_only_where_every_criterion_has_them) {
  const QString full = QStringLiteral("Nothing: every criterion has its full points"), not_all = QStringLiteral("Not every criterion has its full points");
  Grade grade = sample_grade(80);
  CriterionGrade& second = grade.criteria[1];
  const auto shows = [&](const QString& text) {
    records.graded_attempt(lena, "channel-1", grade, 300);
    return texts_of(*page()).contains(text);
  };
  second.id = second.measure.metric = "force_mean";  // pushed too little: no advice is given
  second.reason_code = "too_little";
  ASSERT_TRUE(advice_text(second).isEmpty());
  EXPECT_TRUE(shows(not_all)) << texts_of(*shown).toStdString();
  EXPECT_FALSE(texts_of(*shown).contains(full));
  second.points = second.points_max = 0;
  second.measure.measured = false;
  second.reason_code = "not_measured";
  EXPECT_TRUE(shows(not_all)) << texts_of(*shown).toStdString();
  second = grade.criteria[0];
  second.id = second.measure.metric = "depth_most";
  EXPECT_TRUE(shows(full)) << texts_of(*shown).toStdString();
}

TEST_F(StartPageCards, the_best_before_is_compared_as_both_are_shown) {
  records.attempt(lena, "channel-1", 5.04, 300);  // shown as 5
  records.attempt(lena, "channel-1", 2.86, 300);  // shown as 2.9; 2.18 less
  EXPECT_TRUE(texts_of(*page()).contains(QStringLiteral("2.1 less than\nyour best before"))) << texts_of(*shown).toStdString();
  records.attempt(lena, "channel-1", 5.01, 300);
  EXPECT_TRUE(texts_of(*page()).contains(QStringLiteral("the same as\nyour best before")));
}

TEST_F(StartPageCards, a_comment_keeps_its_lines) {
  const SessionId session = records.attempt(lena, "channel-1", 60, 300);
  ASSERT_TRUE(records.store().statements.comment(examiner, session, "First the floor.\nThen <the> wall."));
  EXPECT_TRUE(texts_of(*page()).contains(QStringLiteral("First the floor.<br>Then &lt;the&gt; wall."))) << texts_of(*shown).toStdString();
}

}  // namespace
}  // namespace cusp::test
