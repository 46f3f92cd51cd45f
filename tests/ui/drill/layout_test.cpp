// What the drilling screen does with little room, and in languages that are read from the right.
#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QPushButton>

#include "ui/drill/drill_stage.h"
#include "ui/drill/score_panel.h"
#include "ui/widgets/gauge.h"
#include "ui/widgets/theme.h"

namespace cusp {
namespace {

/// Pixels of the half of `image` that differ from the same half of `empty`.
int drawn_in(const QImage& image, const QImage& empty, bool left_half) {
  int out = 0;
  const int middle = image.width() / 2;
  for (int y = 0; y < image.height(); ++y)
    for (int x = left_half ? 0 : middle; x < (left_half ? middle : image.width()); ++x) out += image.pixel(x, y) != empty.pixel(x, y);
  return out;
}

TEST(DrillLayout, the_sides_of_a_section_stay_where_they_are_on_the_tooth_in_every_language) {
  for (const Qt::LayoutDirection way : {Qt::LeftToRight, Qt::RightToLeft}) {
    SectionView section;
    section.setLayoutDirection(way);
    section.resize(271, 202);
    const QImage empty = section.grab().toImage();
    section.set_sides(QStringLiteral("B"), {});
    const QImage shown = section.grab().toImage();
    EXPECT_GT(drawn_in(shown, empty, true), 5);
    EXPECT_EQ(drawn_in(shown, empty, false), 0);
  }
}

TEST(DrillLayout, a_gauge_looks_the_same_in_every_language) {
  QImage before;
  for (const Qt::LayoutDirection way : {Qt::LeftToRight, Qt::RightToLeft}) {
    Gauge gauge(QStringLiteral("Push"), QStringLiteral("N"), Gauge::Grows::up);
    gauge.setLayoutDirection(way);
    gauge.set_range(0, 3, 0.5);
    gauge.set_scale_side(Gauge::ScaleSide::right);
    gauge.set_value(1.2);
    gauge.resize(gauge.sizeHint());
    const QImage image = gauge.grab().toImage();
    if (!before.isNull()) {
      EXPECT_EQ(image, before);
    }
    before = image;
  }
}

TEST(DrillLayout, in_half_a_full_hd_screen_the_tools_fit_and_nothing_covers_the_gauges) {
  // 960 x 540 is what full HD has at 200 %; bars and the panel at the side leave this to the stage.
  DrillStage stage;
  stage.resize(656, 400);
  stage.show();
  QApplication::processEvents();
  EXPECT_EQ(stage.size(), QSize(656, 400));
  QPushButton* turn = nullptr;
  for (QPushButton* button : stage.findChildren<QPushButton*>())
    if (turn == nullptr && button->toolTip().endsWith(QStringLiteral("(1)"))) turn = button;
  ASSERT_NE(turn, nullptr);
  const QRect tools = turn->parentWidget()->geometry();
  EXPECT_GE(tools.left(), 0);
  EXPECT_LE(tools.right(), 656);
  for (const Gauge* gauge : stage.findChildren<Gauge*>()) {
    EXPECT_GT(gauge->geometry().top(), tools.bottom());
    EXPECT_LE(gauge->geometry().bottom(), 400 - 50);  // the legend and the coach stand below
    EXPECT_GE(gauge->height(), gauge->minimumSizeHint().height());
  }
}

TEST(StopCard, a_device_that_answers_again_is_told_so_and_not_to_look_for_its_cable) {
  DrillStage stage;
  stage.resize(800, 600);
  stage.show();
  const auto shown = [&stage](const char* words) {
    for (const QLabel* label : stage.findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(QLatin1String(words))) return true;
    return false;
  };
  LiveView live;
  live.phase = LoopPhase::held;
  live.fault = Fault::gone;
  live.device = Sample::Status::gone;
  stage.show_values(live);
  EXPECT_TRUE(shown("does not answer"));
  live.device = Sample::Status::fresh;
  stage.show_values(live);
  EXPECT_TRUE(shown("answers again"));
  EXPECT_FALSE(shown("cable"));
  live.fault = Fault::jump;
  stage.show_values(live);
  EXPECT_TRUE(shown("jumped"));
}

}  // namespace
}  // namespace cusp
