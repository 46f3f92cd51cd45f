// The student's pages over real records.

#include <algorithm>
#include <gtest/gtest.h>

#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

#include "scenarios/library/library.h"
#include "tests/file_limit.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/render/gl_context_egl.h"
#include "ui/replay/reference_page.h"
#include "ui/student/briefing.h"
#include "ui/student/exercise_cards.h"
#include "ui/student/exercises_page.h"
#include "ui/student/interrupted_card.h"
#include "ui/student/start_page.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

using test::DeskRecords;

/// Every text that a page shows.
QString texts(QWidget& page) {
  QString all;
  for (const QLabel* label : page.findChildren<QLabel*>()) all += label->text() + u'\n';
  return all;
}

struct Pages : ::testing::Test {
  DeskRecords records;
  QTemporaryDir cache;
  ThumbnailCache pictures{cache.path().toStdString()};
  QDateTime now{QDate(2026, 11, 20), QTime(10, 0)};
};

TEST_F(Pages, closing_gives_up_the_picture_that_is_being_drawn) {
  const QTemporaryDir folder;
  {
    ThumbnailCache thumbnails(folder.path().toStdString());
    Exercise jaw;
    jaw.scenario = *load_builtin("class-1-36-jaw");
    EXPECT_TRUE(thumbnails.picture(jaw, {}, ThumbnailCache::Use::card).isNull());
  }
  EXPECT_TRUE(QDir(folder.path()).isEmpty()) << "it was drawn to its end";
}

TEST_F(Pages, the_start_page_of_a_new_student_shows_what_is_missing_and_offers_the_first_exercise) {
  const Account lena = records.student("1", "Lena Brandt");
  StartPage page(records.store(), lena, pictures, now);
  page.resize(1080, 752);
  page.show();
  EXPECT_TRUE(texts(page).contains(QStringLiteral("No result yet")));
  EXPECT_TRUE(texts(page).contains(QStringLiteral("Fri 20 Nov")));
  std::optional<Exercise> started;
  QObject::connect(&page, &StartPage::start_wanted, [&](const Exercise& e) { started = e; });
  page.start_button()->click();
  ASSERT_TRUE(started.has_value());
  EXPECT_EQ(started->scenario.key, builtin_scenarios()[0]);
}

TEST_F(Pages, the_start_page_shows_the_last_result_and_how_to_do_better) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 74, 500);
  records.attempt(lena, "channel-1", 78, 426);
  StartPage page(records.store(), lena, pictures, now);
  const QString all = texts(page);
  EXPECT_TRUE(all.contains(QStringLiteral("78")));
  EXPECT_TRUE(all.contains(QStringLiteral("4 more than\nyour best before")));
  EXPECT_TRUE(all.contains(QStringLiteral("Stop pushing at the required depth")));  // depth_most, too_deep
  EXPECT_TRUE(all.contains(QStringLiteral("Mouse and keys only, 2 attempts.")));
}

TEST_F(Pages, the_start_page_shows_an_interrupted_attempt_and_offers_one_way_on) {
  const Account lena = records.student("1", "Lena Brandt");
  EXPECT_EQ(StartPage(records.store(), lena, pictures, now).interrupted(), nullptr);
  const SessionId broken = records.broken_attempt(lena, "channel-1");
  StartPage page(records.store(), lena, pictures, now);
  page.show();
  ASSERT_NE(page.interrupted(), nullptr);
  const QString all = texts(*page.interrupted());
  EXPECT_TRUE(all.contains(QStringLiteral("Interrupted attempt"))) << all.toStdString();
  EXPECT_TRUE(all.contains(QStringLiteral("attempt 1"))) << all.toStdString();
  EXPECT_TRUE(all.contains(QStringLiteral("0:12"))) << all.toStdString();  // how far: broken_attempt() lasts 12 s
  int primary = 0;
  for (const QPushButton* b : page.findChildren<QPushButton*>()) primary += b->property("kind") == u"primary"_qs ? 1 : 0;
  EXPECT_EQ(primary, 1);
  std::optional<SessionId> on, graded;
  QObject::connect(&page, &StartPage::resume_wanted, [&](const SessionId& id) { on = id; });
  QObject::connect(&page, &StartPage::grade_wanted, [&](const SessionId& id) { graded = id; });
  page.interrupted()->primary()->click();
  EXPECT_EQ(on, broken);
  EXPECT_FALSE(graded);
}

TEST_F(Pages, an_attempt_with_another_device_can_only_be_graded_as_it_stands) {
  const Account lena = records.student("1", "Lena Brandt");
  const SessionId broken = records.broken_attempt(lena, "channel-1");
  StartPage page(records.store(), lena, pictures, now, "falcon");
  ASSERT_NE(page.interrupted(), nullptr);
  EXPECT_TRUE(texts(*page.interrupted()).contains(QStringLiteral("To continue it here, ask the staff")));
  std::optional<SessionId> graded;
  QObject::connect(&page, &StartPage::grade_wanted, [&](const SessionId& id) { graded = id; });
  page.interrupted()->primary()->click();
  EXPECT_EQ(graded, broken);
}

TEST_F(Pages, the_card_is_gone_once_the_attempt_is_graded) {
  const Account lena = records.student("1", "Lena Brandt");
  const SessionId broken = records.broken_attempt(lena, "channel-1");
  ASSERT_TRUE(records.store().grades.save(broken, test::sample_grade(30), Hash256{}));
  EXPECT_EQ(StartPage(records.store(), lena, pictures, now).interrupted(), nullptr);
}

TEST_F(Pages, an_opened_pulp_comes_first_in_what_to_do_next_time) {
  const Account lena = records.student("1", "Lena Brandt");
  const SessionId attempt = records.attempt(lena, "class-1-36", 81, 300);
  Grade grade = test::sample_grade(81);
  grade.critical = {"pulp_exposure"};
  grade.passed = false;
  ASSERT_TRUE(records.store().grades.save(attempt, grade, Hash256{}));
  StartPage page(records.store(), lena, pictures, now);
  const QString all = texts(page);
  const auto pulp = all.indexOf(QStringLiteral("The pulp was exposed"));
  ASSERT_GE(pulp, 0) << all.toStdString();
  EXPECT_LT(pulp, all.indexOf(QStringLiteral("Stop pushing at the required depth")));
}

TEST_F(Pages, the_points_of_every_briefing_sum_to_a_hundred) {
  const auto list = load_exercises(records.store());
  for (const Exercise& exercise : list->exercises) {
    Briefing page(exercise, pictures, {}, nullptr);
    const auto* model = page.findChild<Table*>()->model();
    double sum = 0;
    for (int row = 0; row < model->rowCount(); ++row) sum += model->index(row, 2).data().toString().toDouble();
    EXPECT_NEAR(sum, 100, 1e-6) << exercise.scenario.key;
  }
}

TEST_F(Pages, a_briefing_offers_the_reference_and_comes_back_from_it) {
  Exercise exercise;
  exercise.scenario = *load_builtin("channel-1");
  exercise.scenario.specimen.voxel_mm = 0.4;  // so that it grows at once
  Briefing page(exercise, pictures, {}, std::make_shared<ToothCache>(std::filesystem::path()));
  page.show();
  ASSERT_NE(page.watch_button(), nullptr);
  page.watch_button()->click();
  auto* reference = page.findChild<ReferencePage*>();
  ASSERT_NE(reference, nullptr);
  EXPECT_TRUE(reference->isVisible());
  EXPECT_FALSE(page.start_button()->isVisible());
  Q_EMIT reference->back_wanted();
  EXPECT_TRUE(page.start_button()->isVisible());
}

TEST_F(Pages, a_briefing_offers_no_reference_where_nothing_can_be_shown_or_cut) {
  Exercise exercise;
  exercise.scenario = *load_builtin("channel-1");
  EXPECT_EQ(Briefing(exercise, pictures, {}, nullptr).watch_button(), nullptr);
  exercise.scenario.target = {};
  EXPECT_EQ(Briefing(exercise, pictures, {}, std::make_shared<ToothCache>(std::filesystem::path())).watch_button(), nullptr);
}

TEST_F(Pages, the_exercises_stand_in_groups_teeth_before_blocks) {
  const Account lena = records.student("1", "Lena Brandt");
  ExercisesPage page(records.store(), lena.actor(), pictures, {});
  page.resize(1080, 752);
  page.show();
  int all = 0;
  for (const ExerciseGroup group : kExerciseGroups) {
    if (const ExerciseCards* cards = page.cards(group)) all += cards->model()->rowCount();
  }
  EXPECT_EQ(all, static_cast<int>(builtin_scenarios().size()));
  ASSERT_NE(page.cards(ExerciseGroup::class_1), nullptr);
  ASSERT_NE(page.cards(ExerciseGroup::class_2), nullptr);
  EXPECT_EQ(page.cards(ExerciseGroup::other), nullptr);
  EXPECT_LT(page.cards(ExerciseGroup::class_2)->mapTo(&page, QPoint()).y(), page.cards(ExerciseGroup::block)->mapTo(&page, QPoint()).y());
  EXPECT_EQ(page.focusProxy(), page.cards(ExerciseGroup::class_1));
}

TEST_F(Pages, the_exercises_not_passed_yet_are_found_and_a_group_counts_those_passed) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "class-1-36", 90, 100);
  ExercisesPage page(records.store(), lena.actor(), pictures, {});
  page.resize(1080, 752);
  page.show();
  const QAbstractItemModel& shown = *page.cards(ExerciseGroup::class_1)->model();
  const int all = shown.rowCount();
  QStringList texts;
  for (const QLabel* label : page.findChildren<QLabel*>()) texts << label->text();
  EXPECT_TRUE(texts.contains(QStringLiteral("1 of %1 passed").arg(all))) << texts.join(u'|').toStdString();
  page.standing()->setCurrentIndex(1);  // not passed yet
  EXPECT_EQ(shown.rowCount(), all - 1);
  page.standing()->setCurrentIndex(2);  // passed
  EXPECT_EQ(shown.rowCount(), 1);
  EXPECT_FALSE(page.cards(ExerciseGroup::class_2)->isVisible()) << "a group with nothing to show goes";
}

TEST_F(Pages, the_cards_of_a_group_stand_by_level_and_state_it_with_the_expected_time) {
  const Account lena = records.student("1", "Lena Brandt");
  ExercisesPage page(records.store(), lena.actor(), pictures, {});
  for (const ExerciseGroup group : {ExerciseGroup::class_1, ExerciseGroup::class_2, ExerciseGroup::block}) {
    const QAbstractItemModel& shown = *page.cards(group)->model();
    for (int row = 0; row < shown.rowCount(); ++row) {
      const QModelIndex index = shown.index(row, 0);
      EXPECT_FALSE(index.data(CourseModel::LevelTextRole).toString().isEmpty()) << index.data().toString().toStdString();
      const QModelIndex before = shown.index(std::max(row - 1, 0), 0);
      EXPECT_LE(before.data(CourseModel::LevelRole).toInt(), index.data(CourseModel::LevelRole).toInt());
    }
  }
  const QModelIndex first = page.cards(ExerciseGroup::class_1)->model()->index(0, 0);
  EXPECT_EQ(first.data(CourseModel::LevelTextRole).toString(), QStringLiteral("Beginner, \u206615\u00A0min\u2069"));
  EXPECT_TRUE(first.data(Qt::AccessibleDescriptionRole).toString().startsWith(first.data(CourseModel::LevelTextRole).toString()));
}

TEST_F(Pages, a_card_shows_the_best_result_and_opens_the_briefing_by_enter_and_by_click) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "class-1-36", 87, 300);
  ExercisesPage page(records.store(), lena.actor(), pictures, {});
  page.resize(1080, 752);
  page.show();
  std::vector<std::string> wanted;
  QObject::connect(&page, &ExercisesPage::briefing_wanted, [&](const Exercise& e) { wanted.push_back(e.scenario.key); });
  ExerciseCards* cards = page.cards(ExerciseGroup::class_1);
  const QModelIndex first = cards->model()->index(0, 0), second = cards->model()->index(1, 0);
  EXPECT_EQ(first.data(CourseModel::StandingRole).toString(), QStringLiteral("87 of 100"));
  EXPECT_EQ(second.data(CourseModel::StandingRole).toString(), QStringLiteral("not tried yet"));
  cards->setCurrentIndex(second);
  QTest::keyClick(cards, Qt::Key_Left);
  QTest::keyClick(cards, Qt::Key_Return);
  QTest::mouseClick(cards->viewport(), Qt::LeftButton, {}, cards->visualRect(second).center());
  ASSERT_EQ(wanted.size(), 2u);
  EXPECT_EQ(wanted[0], "class-1-36");
  EXPECT_NE(wanted[1], "class-1-36");
}

TEST_F(Pages, all_cards_stand_within_their_group_at_any_width) {
  const Account lena = records.student("1", "Lena Brandt");
  ExercisesPage page(records.store(), lena.actor(), pictures, {});
  page.show();
  for (const QSize size : {QSize(1720, 900), QSize(1080, 752), QSize(653, 485), QSize(320, 400)}) {
    page.resize(size);
    for (const ExerciseGroup group : kExerciseGroups) {
      const ExerciseCards* cards = page.cards(group);
      if (cards == nullptr) continue;
      const QModelIndex last = cards->model()->index(cards->model()->rowCount() - 1, 0);
      EXPECT_TRUE(QTest::qWaitFor([&] { return cards->viewport()->rect().contains(cards->visualRect(last)); })) << size.width();
    }
  }
}

TEST_F(Pages, a_text_finds_its_exercises_and_enter_opens_the_first) {
  const Account lena = records.student("1", "Lena Brandt");
  ExercisesPage page(records.store(), lena.actor(), pictures, {});
  page.show();
  std::optional<Exercise> wanted;
  QObject::connect(&page, &ExercisesPage::briefing_wanted, [&](const Exercise& e) { wanted = e; });
  const int all = page.cards(ExerciseGroup::class_1)->model()->rowCount();
  page.search()->setText(QStringLiteral("class i, tooth"));
  EXPECT_EQ(page.cards(ExerciseGroup::class_1)->model()->rowCount(), 3);  // dry, with turbine and water, and in a jaw
  EXPECT_FALSE(page.cards(ExerciseGroup::block)->isVisible());
  QTest::keyClick(page.search(), Qt::Key_Return);
  ASSERT_TRUE(wanted.has_value());
  EXPECT_EQ(wanted->scenario.key, "class-1-36");
  page.search()->setText(QStringLiteral("no such thing"));
  EXPECT_EQ(page.cards(ExerciseGroup::class_1)->model()->rowCount(), 0);
  wanted.reset();
  QTest::keyClick(page.search(), Qt::Key_Return);
  EXPECT_FALSE(wanted.has_value());
  for (QPushButton* button : page.findChildren<QPushButton*>()) {
    if (button->text() == QStringLiteral("Show all exercises")) button->click();
  }
  EXPECT_EQ(page.cards(ExerciseGroup::class_1)->model()->rowCount(), all);
}

TEST_F(Pages, pictures_that_are_stopped_begin_again_when_they_are_asked_for) {
  const auto list = load_exercises(records.store());
  QSignalSpy ready(&pictures, &ThumbnailCache::ready);
  EXPECT_TRUE(pictures.picture(list->exercises[0], {}, ThumbnailCache::Use::card).isNull());
  pictures.stop();
  EXPECT_TRUE(pictures.picture(list->exercises[0], {}, ThumbnailCache::Use::card).isNull());
  if (!EglContext::create(8, 8)) GTEST_SKIP() << "no OpenGL";
  ASSERT_TRUE(QTest::qWaitFor([&] { return ready.count() > 0; }, 60'000));
  EXPECT_FALSE(pictures.picture(list->exercises[0], {}, ThumbnailCache::Use::card).isNull());
}

TEST_F(Pages, a_briefing_asks_anew_for_the_picture_that_an_attempt_over_it_has_stopped) {
  if (!EglContext::create(8, 8)) GTEST_SKIP() << "no OpenGL";
  Exercise exercise;
  exercise.scenario = *load_builtin("class-1-36");
  Briefing page(exercise, pictures, {}, nullptr);
  page.show();
  QSignalSpy ready(&pictures, &ThumbnailCache::ready);
  pictures.stop();
  page.hide();
  page.show();
  EXPECT_TRUE(QTest::qWaitFor([&] { return ready.count() > 0; }, 60'000));
}

TEST_F(Pages, a_picture_that_the_disk_does_not_take_is_shown_and_leaves_no_half_file) {
  if (!EglContext::create(8, 8)) GTEST_SKIP() << "no OpenGL";
  const Exercise block{*load_builtin("paper-block"), {}, 1, {}};
  QImage whole;
  for (const bool full : {false, true}) {
    const QTemporaryDir folder;
    ThumbnailCache thumbnails(folder.path().toStdString());
    QSignalSpy ready(&thumbnails, &ThumbnailCache::ready);
    // The end of a PNG stays in a buffer of 16 kB until its file is closed.
    with_files_up_to(full ? 20'000 : RLIM_INFINITY, [&] {
      EXPECT_TRUE(thumbnails.picture(block, {}, ThumbnailCache::Use::cover).isNull());
      return QTest::qWaitFor([&] { return ready.count() > 0; }, 60'000);
    });
    ASSERT_EQ(ready.count(), 1) << full;
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), full ? 0 : 1);
    const QImage picture = thumbnails.picture(block, {}, ThumbnailCache::Use::cover);
    ASSERT_FALSE(picture.isNull()) << full;
    EXPECT_TRUE(whole.isNull() || picture == whole);
    whole = picture;
  }
}

TEST_F(Pages, the_start_page_fits_a_window_of_1280) {
  const Account lena = records.student("1", "Lena Brandt");
  StartPage page(records.store(), lena, pictures, now);
  page.show();
  const auto* scroll = page.findChild<QScrollArea*>();
  ASSERT_NE(scroll, nullptr);
  for (const QSize size : {QSize(1080, 752), QSize(653, 485)}) {  // less the bar at the side; at 100 % and 150 %
    page.resize(size);
    QTest::qWait(0);
    EXPECT_EQ(scroll->horizontalScrollBar()->maximum(), 0) << size.width();
  }
}

TEST_F(Pages, the_briefing_shows_what_earns_points_and_starts) {
  const auto list = load_exercises(records.store());
  Briefing page(list->exercises.front(), pictures, {}, nullptr);
  page.show();
  const Scenario& s = list->exercises.front().scenario;
  const QString all = texts(page);
  EXPECT_TRUE(all.contains(QString::fromStdString(s.title.at("en"))));
  EXPECT_TRUE(QString(all).replace(QChar::Nbsp, u' ').contains(QString::fromStdString(s.briefing.at("en"))));
  const auto* table = page.findChild<Table*>();
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->model()->rowCount(), static_cast<int>(s.rubric.criteria.size()));
  QSignalSpy started(&page, &Briefing::start_wanted);
  page.start_button()->click();
  EXPECT_EQ(started.count(), 1);
}

TEST_F(Pages, the_briefing_scrolls_as_a_whole_and_names_what_fails_the_attempt_once) {
  Exercise box;
  box.scenario = *load_builtin("class-2-46-mo");
  ASSERT_GT(box.scenario.rubric.criteria.size(), 12u);
  ASSERT_GT(box.scenario.rubric.critical.size(), 1u);
  Briefing page(box, pictures, {}, nullptr);
  page.resize(1280, 720);
  page.show();
  QTest::qWait(0);
  EXPECT_EQ(page.findChild<Table*>()->verticalScrollBar()->maximum(), 0);
  EXPECT_EQ(texts(page).count(QStringLiteral("Fails the attempt")), 1);
  for (const QLabel* label : page.findChildren<QLabel*>())
    EXPECT_TRUE(label->text() != QStringLiteral("Fails the attempt") || label->alignment() & Qt::AlignTop);
}

}  // namespace
}  // namespace cusp::test
