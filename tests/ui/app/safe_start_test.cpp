// In a process of its own: forbid_opengl() is for good.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/app/asking_desktop.h"
#include "tests/ui/editor/editor_pages.h"
#include "tests/ui/report/sample_report.h"
#include "ui/app/shell.h"
#include "ui/drill/drill_screen.h"
#include "ui/render/gl_context_egl.h"
#include "ui/render/opengl_allowed.h"
#include "ui/report/report_page.h"
#include "ui/signin/sign_in.h"
#include "ui/student/assessments.h"
#include "ui/student/interrupted_card.h"
#include "ui/student/start_page.h"
#include "ui/view/tooth_view.h"

namespace cusp::test {
namespace {

bool gives_reason(const QWidget& card) {
  for (const QLabel* label : card.findChildren<QLabel*>())
    if (label->text().contains(QStringLiteral("3D pictures are off"))) return true;
  return false;
}

struct SafeStart : AskingDesktop {
  SafeStart() { show(); }
  bool shows(const QString& text) const {
    for (const QLabel* label : desktop->findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(text)) return true;
    return false;
  }
};

TEST_F(SafeStart, asks_and_starts_as_usual_when_that_is_declined) {
  desktop->offer_safe_start();
  ASSERT_EQ(asked.size(), 1);
  EXPECT_TRUE(asked[0].contains(QStringLiteral("ended unexpectedly"))) << asked[0].toStdString();
  EXPECT_EQ(desktop->page(), nullptr) << "nothing is drawn before the answer";
  answer(false);
  EXPECT_NE(qobject_cast<SignIn*>(desktop->page()), nullptr);
  EXPECT_TRUE(opengl_allowed());
  EXPECT_FALSE(shows(QStringLiteral("3D pictures are off")));
}

TEST_F(SafeStart, without_pictures_results_are_open_and_start_gives_the_reason) {
  desktop->offer_safe_start();
  answer(true);
  EXPECT_FALSE(opengl_allowed());
  EXPECT_EQ(EglContext::create(64, 64), nullptr);
  EXPECT_TRUE(shows(QStringLiteral("3D pictures are off")));
  desktop->sign_in(records.student("1", "Lena Brandt"));
  EXPECT_TRUE(shows(QStringLiteral("3D pictures are off")));
  const auto* page = desktop->findChild<StartPage*>();
  ASSERT_NE(page, nullptr);
  ASSERT_NE(page->start_button(), nullptr);
  EXPECT_FALSE(page->start_button()->isEnabled());
  desktop->shell()->show_page(QStringLiteral("results"));
  EXPECT_EQ(desktop->shell()->page_key(), QStringLiteral("results"));
  desktop->drill({load_builtin("channel-1").value(), {}, {}, {}});
  EXPECT_EQ(desktop->findChild<DrillScreen*>(), nullptr);
  EXPECT_TRUE(shows(QStringLiteral("Nothing can be drilled now.")));
}

TEST_F(SafeStart, without_pictures_the_sign_in_page_gives_the_reason_at_its_try_it) {
  forbid_opengl();
  desktop->start();
  const auto* page = qobject_cast<SignIn*>(desktop->page());
  ASSERT_NE(page, nullptr);
  EXPECT_TRUE(gives_reason(*page));
  const auto* try_it = named<QPushButton>(*desktop, "Try it");
  ASSERT_NE(try_it, nullptr);
  EXPECT_FALSE(try_it->isEnabled());
  EXPECT_TRUE(try_it->toolTip().contains(QStringLiteral("3D pictures are off"))) << try_it->toolTip().toStdString();
}

TEST_F(SafeStart, without_pictures_an_interrupted_attempt_is_graded_and_not_continued) {
  const Account lena = records.student("1", "Lena Brandt");
  records.broken_attempt(lena, "channel-1");
  forbid_opengl();
  desktop->start();
  desktop->sign_in(lena);
  const auto* page = desktop->findChild<StartPage*>();
  ASSERT_NE(page, nullptr);
  const InterruptedCard* card = page->interrupted();
  ASSERT_NE(card, nullptr);
  EXPECT_EQ(card->primary()->accessibleName(), QStringLiteral("Continue"));
  EXPECT_FALSE(card->primary()->isEnabled());
  EXPECT_TRUE(gives_reason(*card));
  const QPushButton* grade = nullptr;
  for (const QPushButton* button : card->findChildren<QPushButton*>())
    if (button->accessibleName() == QStringLiteral("Grade as it stands")) grade = button;
  ASSERT_NE(grade, nullptr);
  EXPECT_TRUE(grade->isEnabled());
}

TEST_F(SafeStart, without_pictures_an_open_assessment_gives_the_reason_beside_its_start) {
  forbid_opengl();
  AssignedAssessment open;
  open.exercise.scenario = *load_builtin("channel-1");
  ASSERT_EQ(open.state, AssignedAssessment::State::open);
  const AssessmentCard card(open, records.student("1", "Lena Brandt").id, "pointer");
  ASSERT_NE(card.start_button(), nullptr);
  EXPECT_FALSE(card.start_button()->isEnabled());
  EXPECT_TRUE(gives_reason(card));
}

TEST_F(SafeStart, without_pictures_a_report_gives_the_reason_at_its_button_to_a_further_attempt) {
  forbid_opengl();
  const ReportPage page(sample(), ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
  const QPushButton* again = nullptr;
  for (const QPushButton* button : page.findChildren<QPushButton*>())
    if (button->accessibleName() == QStringLiteral("Try again")) again = button;
  ASSERT_NE(again, nullptr);
  EXPECT_FALSE(again->isEnabled());
  EXPECT_TRUE(again->toolTip().contains(QStringLiteral("3D pictures are off"))) << again->toolTip().toStdString();
  EXPECT_EQ(again->accessibleDescription(), again->toolTip());
}

TEST_F(EditorPages, without_pictures_gives_the_reason_at_its_try_out_and_the_reference_operator_still_cuts) {
  forbid_opengl();
  const auto page = open();
  const auto* by_author = named<QPushButton>(*page, "Try out");
  ASSERT_NE(by_author, nullptr);
  EXPECT_FALSE(by_author->isEnabled());
  EXPECT_TRUE(by_author->toolTip().contains(QStringLiteral("3D pictures are off"))) << by_author->toolTip().toStdString();
  EXPECT_EQ(by_author->accessibleDescription(), by_author->toolTip());
  EXPECT_TRUE(named<QPushButton>(*page, "Try out by the reference operator")->isEnabled());
  page->model().set_depth_mm(1.5);
  EXPECT_FALSE(by_author->isEnabled());
  ASSERT_TRUE(open_sheet(*page));
  ASSERT_NE(sheet_of(*page)->try_out(), nullptr);
  EXPECT_FALSE(sheet_of(*page)->try_out()->isEnabled());
  EXPECT_TRUE(gives_reason(*sheet_of(*page)));
}

}  // namespace
}  // namespace cusp::test
