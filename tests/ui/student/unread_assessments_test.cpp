// The start page of a student with assessments that cannot be read.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/student/start_page_cards.h"
#include "ui/student/exercises_page.h"
#include "ui/student/interrupted_card.h"
#include "ui/student/start_page.h"
#include "ui/widgets/empty_state.h"

namespace cusp::test {
namespace {

struct UnreadAssessments : StartPageCards {
  /// Of the band of a page made now; empty without one.
  QString message() {
    for (const Band* band : page()->findChildren<Band*>())
      if (band->isVisibleTo(shown.get())) return band->text();
    return {};
  }
  qsizetype cards() const { return shown->findChildren<AssessmentCard*>().size(); }
};

TEST_F(UnreadAssessments, are_not_taken_for_none) {
  EXPECT_EQ(message(), QString());
  ASSERT_EQ(cards(), 1);
  ASSERT_TRUE(records.store().database().run("DROP INDEX summaries_of_assignment"));  // no attempt at an assessment is found without it
  const QString band = message();
  EXPECT_TRUE(band.startsWith(QStringLiteral("Your assessments could not be read."))) << band.toStdString();
  EXPECT_EQ(cards(), 0);
  EXPECT_NE(shown->table(), nullptr) << "the exercises are there";
}

TEST_F(UnreadAssessments, are_those_whose_extra_time_is_not_known) {
  EXPECT_EQ(message(), QString());
  ASSERT_TRUE(records.store().database().run("DROP INDEX adjustments_of_assignment"));  // no extra time is found without it
  const QString band = message();
  EXPECT_TRUE(band.startsWith(QStringLiteral("Your assessments could not be read."))) << band.toStdString();
  EXPECT_EQ(cards(), 0) << "a card without the extra time promises too little";
}

TEST_F(UnreadAssessments, of_a_newer_program_are_reported_until_their_time_is_over) {
  Store& store = records.store();
  const Scenario scenario = *load_builtin("paper-block");
  const auto newer = store.scenarios.publish(examiner, scenario, R"({"format": 99})", content_hash(scenario).bytes);
  ASSERT_TRUE(newer);
  const std::int64_t due_us = (now.toMSecsSinceEpoch() + 3'600'000) * 1000;
  ASSERT_TRUE(store.assignments.create(
      examiner, {.version = newer->id, .cohort = cohort, .kind = SessionKind::assessment, .due_utc_us = due_us}, "4713"));
  const QString band = message();
  EXPECT_TRUE(band.contains(QStringLiteral("cannot be shown."))) << band.toStdString();
  EXPECT_EQ(cards(), 1) << "of the one that can be read";
  now = now.addSecs(3'600);
  EXPECT_EQ(message(), QString());
}

TEST_F(UnreadAssessments, are_joined_by_an_interrupted_attempt_that_cannot_be_read) {
  records.broken_attempt(lena, "paper-block");
  EXPECT_EQ(message(), QString());
  ASSERT_EQ(shown->findChildren<InterruptedCard*>().size(), 1);
  ASSERT_TRUE(records.store().database().run("ALTER TABLE final_volumes RENAME TO lost_volumes"));
  const QString band = message();
  EXPECT_TRUE(band.startsWith(QStringLiteral("An interrupted attempt could not be read."))) << band.toStdString();
  EXPECT_TRUE(shown->findChildren<InterruptedCard*>().empty());
}

TEST_F(UnreadAssessments, are_joined_by_a_comment_that_cannot_be_read) {
  EXPECT_EQ(message(), QString());
  ASSERT_TRUE(records.store().database().run("ALTER TABLE comments RENAME TO lost_comments"));
  const QString band = message();
  EXPECT_TRUE(band.startsWith(QStringLiteral("The newest comment could not be read."))) << band.toStdString();
}

TEST_F(UnreadAssessments, leave_an_interrupted_attempt_whose_cuts_cannot_be_read_without_a_word_about_them) {
  records.broken_attempt(lena, "paper-block");
  EXPECT_EQ(message(), QString());
  const auto cards_say = [&](const QString& part) {
    const InterruptedCard* card = shown->findChild<InterruptedCard*>();
    return card != nullptr && std::ranges::any_of(card->findChildren<QLabel*>(), [&](const QLabel* label) { return label->text().contains(part); });
  };
  EXPECT_TRUE(cards_say(QStringLiteral("before anything was cut")));
  ASSERT_TRUE(records.store().database().run("ALTER TABLE removed_tissues RENAME TO lost_tissues"));
  EXPECT_EQ(message(), QString());
  EXPECT_TRUE(cards_say(QStringLiteral("It broke off after")));
  EXPECT_FALSE(cards_say(QStringLiteral("before anything was cut")));
}

TEST_F(UnreadAssessments, and_unread_exercises_leave_a_page_that_offers_to_try_again) {
  ASSERT_TRUE(records.store().database().run("DROP INDEX summaries_of_student"));  // no exercise's attempts are counted without it
  message();
  QSignalSpy again(shown.get(), &StartPage::assessment_opened);
  ASSERT_EQ(shown->table(), nullptr);
  auto* unread = shown->findChild<EmptyState*>();
  ASSERT_NE(unread, nullptr);
  ASSERT_NE(unread->button(), nullptr);
  EXPECT_EQ(shown->focusProxy(), unread->button());
  unread->button()->click();
  EXPECT_EQ(again.count(), 1);
}

TEST_F(UnreadAssessments, and_unread_exercises_can_be_tried_again_from_their_own_page) {
  ASSERT_TRUE(records.store().database().run("DROP INDEX summaries_of_student"));
  ExercisesPage page(records.store(), lena.actor(), pictures, {});
  QSignalSpy again(&page, &ExercisesPage::again_wanted);
  auto* unread = page.findChild<EmptyState*>();
  ASSERT_NE(unread, nullptr);
  ASSERT_NE(unread->button(), nullptr);
  EXPECT_EQ(page.focusProxy(), unread->button());
  unread->button()->click();
  EXPECT_EQ(again.count(), 1);
}

}  // namespace
}  // namespace cusp::test
