// The clock of the drilling screen beside a time limit.
#include "ui/drill/drill_bar.h"

#include <gtest/gtest.h>

#include <QLabel>

namespace cusp::test {
namespace {

using ui::DrillBar;

/// Without the marks that keep a time together in right-to-left text.
QString limit_of(const DrillBar& bar) {
  for (const QLabel* label : bar.findChildren<QLabel*>()) {
    if (label->accessibleDescription() != QStringLiteral("Time limit") || label->isHidden()) continue;
    return label->text().remove(QChar(0x2066)).remove(QChar(0x2069));
  }
  return {};
}

TEST(DrillBarTime, WithoutALimitShowsTheClockAlone) {
  DrillBar bar;
  bar.set_time_limit(0);
  bar.set_seconds(400);
  EXPECT_EQ(limit_of(bar), QString());
}

TEST(DrillBarTime, ShowsTheLimitThenWhatIsLeftOfTheLastFiveMinutes) {
  DrillBar bar;
  bar.set_time_limit(1200);
  bar.set_seconds(10);
  EXPECT_EQ(limit_of(bar), QStringLiteral("of 20:00"));
  bar.set_seconds(900);
  EXPECT_EQ(limit_of(bar), QStringLiteral("of 20:00"));
  bar.set_seconds(901);
  EXPECT_EQ(limit_of(bar), QStringLiteral("4:59 left"));
  bar.set_seconds(1300);
  EXPECT_EQ(limit_of(bar), QStringLiteral("0:00 left"));
}

TEST(DrillBarTime, AShortLimitWarnsInItsLastMinuteAlone) {
  DrillBar bar;
  bar.set_time_limit(240);
  bar.set_seconds(30);
  EXPECT_EQ(limit_of(bar), QStringLiteral("of 4:00"));
  bar.set_seconds(181);
  EXPECT_EQ(limit_of(bar), QStringLiteral("0:59 left"));
}

}  // namespace
}  // namespace cusp::test
