// The report's button to a further attempt.

#include <gtest/gtest.h>

#include <QPushButton>
#include <QShortcut>
#include <QSignalSpy>

#include "tests/modules.h"
#include "tests/ui/report/sample_report.h"
#include "ui/report/report_page.h"

namespace cusp::test {
namespace {

QPushButton* named_button(const ReportPage& page, const QString& name) {
  for (QPushButton* b : page.findChildren<QPushButton*>())
    if (b->accessibleName() == name) return b;
  return nullptr;
}

TEST(ReportPage, begins_practice_after_an_assessment_by_a_button_that_says_so) {
  const Ports ports = Ports::of_the_system();
  ReportData data = sample();
  data.kind = SessionKind::assessment;
  const ReportPage page(data, ports, ReportPage::TryAgain::offered, QStringLiteral("Back"));
  EXPECT_EQ(named_button(page, QStringLiteral("Try again")), nullptr);
  QPushButton* practise = named_button(page, QStringLiteral("Practise it"));
  ASSERT_NE(practise, nullptr);
  EXPECT_TRUE(practise->toolTip().contains(QStringLiteral("does not count for the assessment"))) << practise->toolTip().toStdString();
  EXPECT_EQ(practise->accessibleDescription(), practise->toolTip());
  QSignalSpy again(&page, &ReportPage::try_again_wanted);
  practise->click();
  EXPECT_EQ(again.count(), 1);
}

TEST(ReportPage, without_a_further_attempt_is_still_the_students_own) {
  const Ports ports = Ports::of_the_system();
  const auto escapes = [](const ReportPage& page) {
    for (const QShortcut* shortcut : page.findChildren<QShortcut*>())
      if (shortcut->key() == QKeySequence(Qt::Key_Escape)) return true;
    return false;
  };
  const ReportPage own(sample(), ports, ReportPage::TryAgain::refused, QStringLiteral("Back"));
  EXPECT_EQ(named_button(own, QStringLiteral("Try again")), nullptr);
  EXPECT_TRUE(escapes(own));
  EXPECT_FALSE(escapes(ReportPage(sample(), ports, ReportPage::TryAgain::hidden, QStringLiteral("Back"))));
}

}  // namespace
}  // namespace cusp::test
