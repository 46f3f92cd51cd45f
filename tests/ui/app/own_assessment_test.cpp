// After an attempt that asks for it the own assessment comes before the report.

#include <gtest/gtest.h>

#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/app/desktop.h"
#include "ui/app/shell.h"
#include "ui/report/report_page.h"
#include "ui/student/self_assessment_page.h"
#include "ui/widgets/parts.h"

namespace cusp::test {
namespace {

struct OwnAssessment : ::testing::Test {
  DeskRecords records;
  QTemporaryDir folder;
  Settings settings{folder.filePath(QStringLiteral("Cusp.ini"))};
  Ports ports = Ports::of_the_system();
  std::unique_ptr<Desktop> desktop;
  Account lena = records.student("1", "Lena Brandt");
  SessionId session = records.attempt(lena, "channel-1", 66, 90);
  enum class Asked : std::uint8_t { no, yes };
  void end(const Account& who, Asked asked) {
    desktop = std::make_unique<Desktop>(settings, ports, records.file());
    desktop->start();
    desktop->show();
    desktop->sign_in(who);
    auto result = std::make_shared<SessionResult>();
    result->session = session;
    result->scenario = *load_builtin("channel-1");
    result->scenario.self_assessment = asked == Asked::yes;
    result->grade = (*records.store().grades.newest(session))->grade;
    desktop->end_attempt(result, std::nullopt);
  }
  SelfAssessmentPage* asking() { return qobject_cast<SelfAssessmentPage*>(desktop->page()); }
  void press(const char* text) {
    for (QPushButton* b : desktop->page()->findChildren<QPushButton*>())
      if (b->text() == QString::fromUtf8(text)) return b->click();
    FAIL() << "no button " << text;
  }
  bool report_shows() {
    return QTest::qWaitFor([&] { return qobject_cast<ReportPage*>(desktop->page()) != nullptr; }, 60'000);
  }
  std::optional<SelfAssessment> kept() { return *records.store().statements.self_assessment(lena.actor(), session); }
};

TEST_F(OwnAssessment, is_asked_for_before_the_report_and_kept) {
  end(lena, Asked::yes);
  ASSERT_NE(asking(), nullptr);
  asking()->row(0)->choose(1);
  press("Show the result");
  EXPECT_EQ(kept(), (SelfAssessment{{{"target_removed", OwnRating::partly}}}));
  ASSERT_TRUE(report_shows());
  EXPECT_EQ(qobject_cast<ReportPage*>(desktop->page())->data().own, kept());
  desktop->back();
  EXPECT_EQ(desktop->page(), desktop->shell()) << "the questions do not come again";
}

TEST_F(OwnAssessment, may_be_skipped_and_is_kept_as_skipped) {
  end(lena, Asked::yes);
  ASSERT_NE(asking(), nullptr);
  press("Skip");
  EXPECT_TRUE(report_shows());
  ASSERT_TRUE(kept());
  EXPECT_TRUE(kept()->skipped());
}

TEST_F(OwnAssessment, that_was_begun_is_skipped_after_a_question_alone) {
  QStringList asked;
  std::function<void(bool)> answer;
  ports.ask = [&](QWidget*, const Question& question, std::function<void(bool)> then) {
    asked << question.act;
    answer = std::move(then);
  };
  end(lena, Asked::yes);
  ASSERT_NE(asking(), nullptr);
  asking()->row(0)->choose(1);
  press("Skip");
  ASSERT_EQ(asked, QStringList{QStringLiteral("Skip")});
  answer(false);
  ASSERT_NE(asking(), nullptr);
  EXPECT_EQ(asking()->row(0)->chosen(), 1);
  EXPECT_FALSE(kept());
  press("Skip");
  answer(true);
  EXPECT_TRUE(report_shows());
  ASSERT_TRUE(kept());
  EXPECT_TRUE(kept()->skipped());
}

TEST_F(OwnAssessment, is_not_asked_for_where_the_exercise_does_not_nor_of_others_nor_twice) {
  end(lena, Asked::no);
  EXPECT_EQ(asking(), nullptr);
  end(records.administrator(), Asked::yes);
  EXPECT_EQ(asking(), nullptr);
  ASSERT_TRUE(records.store().statements.assess_own(lena.actor(), session, {}));
  end(lena, Asked::yes);
  EXPECT_EQ(asking(), nullptr);
}

TEST_F(OwnAssessment, that_cannot_be_kept_is_named_and_passed_over) {
  end(lena, Asked::yes);
  ASSERT_NE(asking(), nullptr);
  ASSERT_TRUE(records.store().statements.assess_own(lena.actor(), session, {}));  // at another window
  asking()->row(0)->choose(0);
  press("Show the result");
  ASSERT_NE(asking(), nullptr);
  EXPECT_FALSE(asking()->findChild<Band*>()->text().isEmpty());
  press("Go on without it");
  EXPECT_TRUE(report_shows());
}

}  // namespace
}  // namespace cusp::test
