// The bar of the drilling screen: its clock beside a time limit, and what it leaves out where it is narrow.
#include "ui/drill/drill_bar.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QLayout>
#include <QPushButton>

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

TEST(DrillBarTime, IsNeverRed) {
  DrillBar bar;
  bar.set_time_limit(1200);
  for (const double seconds : {901.0, 1141.0, 1200.0}) {
    bar.set_seconds(seconds);
    for (const QLabel* label : bar.findChildren<QLabel*>())
      EXPECT_NE(label->property("ink").toString(), QStringLiteral("bad")) << label->text().toStdString();
  }
}

TEST(DrillBarTime, AShortLimitWarnsInItsLastMinuteAlone) {
  DrillBar bar;
  bar.set_time_limit(240);
  bar.set_seconds(30);
  EXPECT_EQ(limit_of(bar), QStringLiteral("of 4:00"));
  bar.set_seconds(181);
  EXPECT_EQ(limit_of(bar), QStringLiteral("0:59 left"));
}

/// An assessment on the longest title of the built-in exercises.
struct DrillBarWidth : testing::Test {
  DrillBar bar;
  void show(int width) {
    bar.resize(width, 48);
    bar.set_exercise(QStringLiteral("Klasse I, Zahn 36, im ganzen Unterkiefer"), QStringLiteral("Prüfung, Kandidat/in 47, fortgesetzt"));
    bar.set_time_limit(1200);
    DeviceLimits mouse;
    mouse.device_class = "pointer";
    bar.set_device(mouse);
    bar.show();
    QCoreApplication::processEvents();
  }
  const QLabel* label(const QString& of) const {
    for (const QLabel* one : bar.findChildren<QLabel*>())
      if (one->accessibleName() == of || one->text() == of) return one;
    return nullptr;
  }
  QPushButton* button(const char* name) const {
    for (QPushButton* one : bar.findChildren<QPushButton*>())
      if (one->accessibleName() == QLatin1String(name)) return one;
    return nullptr;
  }
};

TEST_F(DrillBarWidth, ShowsAllOfItInAWholeWindow) {
  show(1600);
  EXPECT_TRUE(label(QStringLiteral("Mouse and keys"))->isVisible());
  EXPECT_EQ(button("Pause")->text(), QStringLiteral(" Pause"));
  EXPECT_EQ(label(QStringLiteral("Klasse I, Zahn 36, im ganzen Unterkiefer"))->toolTip(), QString());
}

TEST_F(DrillBarWidth, ShowsResumeAloneWherePauseIsNotOffered) {
  bar.offer_pause(false);
  show(1600);
  EXPECT_FALSE(button("Pause")->isVisible());
  bar.set_stopped(true);
  EXPECT_TRUE(button("Resume")->isVisible());
  bar.set_stopped(false);
  EXPECT_FALSE(button("Pause")->isVisible());
}

TEST_F(DrillBarWidth, HoldsClockTagAndEveryButtonInHalfOfFullHd) {
  show(960);
  EXPECT_LE(bar.layout()->sizeHint().width(), 960);
  EXPECT_FALSE(label(QStringLiteral("Mouse and keys"))->isVisible());
  EXPECT_TRUE(label(QStringLiteral("Prüfung, Kandidat/in 47, fortgesetzt"))->isVisible());
  EXPECT_EQ(button("Finish")->text(), QStringLiteral(" Finish"));
  EXPECT_LE(button("Finish")->geometry().right(), 960);
}

TEST_F(DrillBarWidth, ReadsNoHtmlInTheTitleThatItShowsWholeInItsTooltip) {
  show(720);
  const QString whole = QStringLiteral("<b>Klasse I</b>, Zahn 36, im ganzen Unterkiefer");
  bar.set_exercise(whole, QStringLiteral("Prüfung, Kandidat/in 47, fortgesetzt"));
  ASSERT_NE(label(whole), nullptr);
  EXPECT_FALSE(label(whole)->toolTip().isEmpty());
  EXPECT_FALSE(label(whole)->toolTip().contains(u"<b>"));
}

TEST_F(DrillBarWidth, ShortensTheTitleAtLastAndKeepsItWholeInItsNameAndTooltip) {
  show(720);
  const QString whole = QStringLiteral("Klasse I, Zahn 36, im ganzen Unterkiefer");
  EXPECT_LE(bar.layout()->sizeHint().width(), 720);
  EXPECT_NE(label(whole)->text(), whole);
  EXPECT_EQ(label(whole)->toolTip(), whole);
  EXPECT_EQ(button("Pause")->text(), QString());
  EXPECT_EQ(button("Pause")->shortcut(), QKeySequence(Qt::Key_P));
  bar.set_stopped(true);
  EXPECT_EQ(button("Resume")->shortcut(), QKeySequence(Qt::Key_P));
}

}  // namespace
}  // namespace cusp::test
