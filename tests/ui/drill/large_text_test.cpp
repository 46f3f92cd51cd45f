// The drilling screen with large text, where each length is up to twice as long: what folds, and that nothing is cut off.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QScrollArea>
#include <QTest>
#include <sstream>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/looks.h"
#include "ui/drill/bur_tray.h"
#include "ui/drill/drill_screen.h"
#include "ui/drill/drill_stage.h"
#include "ui/drill/homing_card.h"
#include "ui/drill/score_panel.h"
#include "ui/drill/section_view.h"
#include "ui/widgets/gauge.h"

namespace cusp::test {
namespace {

constexpr int kOpensWithinMs = 60'000;  // waits for progress; a slow machine may take its time

std::string named(const QWidget& one) {
  std::stringstream out;
  const auto* label = qobject_cast<const QLabel*>(&one);
  const QRect at(one.mapTo(one.window(), QPoint(0, 0)), one.size());
  out << one.metaObject()->className() << " '" << (label ? label->text() : one.accessibleName()).toStdString() << "' at " << at.x() << ',' << at.y() << ' ' << at.width() << 'x' << at.height();
  return out.str();
}

/// Each widget lies within its parent, or beside a scroll area's edge where it scrolls to, and each text is whole.
void expect_whole(const QWidget& screen) {
  for (const QWidget* one : screen.findChildren<QWidget*>()) {
    if (!one->isVisibleTo(&screen) || one->inherits("QFocusFrame")) continue;
    const QWidget* parent = one->parentWidget();
    const bool scrolls = parent->parentWidget() != nullptr && qobject_cast<const QScrollArea*>(parent->parentWidget()) != nullptr;
    const QRect room = parent->rect(), place = one->geometry();
    EXPECT_TRUE(scrolls ? place.left() >= room.left() && place.right() <= room.right() : room.contains(place)) << named(*one) << " leaves " << named(*parent);
    if (const auto* label = qobject_cast<const QLabel*>(one); label != nullptr && !label->text().isEmpty()) {
      const int needed = label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
      EXPECT_GE(label->height(), needed) << named(*one);
      if (!label->wordWrap()) {
        EXPECT_GE(label->width(), label->sizeHint().width()) << named(*one) << " needs " << label->sizeHint().width();
      }
    }
    if (const auto* gauge = qobject_cast<const Gauge*>(one)) {
      EXPECT_GE(gauge->height(), gauge->minimumSizeHint().height()) << named(*one);
    }
  }
  expect_buttons_fit(screen);
}

/// Nothing that stands on the view covers anything else there.
void expect_apart(const DrillStage& stage) {
  std::vector<const QWidget*> shown;
  for (const QWidget* one : stage.findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
    if (one->isVisible() && one->size() != stage.size() && !one->inherits("QFocusFrame") && one->property("kind") != QStringLiteral("pin")) shown.push_back(one);
  EXPECT_GE(shown.size(), 4U);  // tools, push, depth hold, compass; in practice more
  for (std::size_t i = 0; i < shown.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(shown[i]->geometry().intersects(shown[j]->geometry())) << named(*shown[i]) << " covers " << named(*shown[j]);
}

struct LargeText : testing::Test {
  void TearDown() override {
    install_language(*qApp, QStringLiteral("en"));
    apply_theme(*qApp, ColourScheme::light, 100);
  }
  /// nullptr while it says nothing. Its name is translated.
  static const QLabel* coach_of(const DrillScreen& screen) {
    const QLabel* sign = screen.findChild<QLabel*>(QStringLiteral("coach_sign"));
    return sign->isVisible() ? sign : nullptr;
  }
  static std::unique_ptr<DrillScreen> begin(QSize size, Guidance guidance = Guidance::full) {
    auto screen = std::make_unique<DrillScreen>(Ports::of_the_system());
    screen->resize(size);
    screen->show();
    SessionPlan plan;
    plan.scenario = load_builtin("class-1-36").value();
    plan.scenario.specimen.voxel_mm = 0.4;
    plan.scenario.phenomena = {"spindle-turbine", "vibration", "sound", "heat"};
    plan.scenario.time_limit_s = 1200;
    plan.kind = SessionKind::try_it;
    plan.guidance = guidance;
    screen->begin(std::move(plan), {QStringLiteral("Klasse I, Zahn 36, im ganzen Unterkiefer"), QStringLiteral("Prüfung, Kandidat/in 47, fortgesetzt")});
    EXPECT_TRUE(QTest::qWaitFor([&] { return screen->running(); }, kOpensWithinMs));
    if (guidance == Guidance::full) {
      EXPECT_TRUE(QTest::qWaitFor([&] { return coach_of(*screen) != nullptr; }, kOpensWithinMs));
    }
    QCoreApplication::processEvents();  // the layouts follow the first values
    return screen;
  }
};

TEST_F(LargeText, cuts_nothing_off_on_the_drilling_screen) {
  for (const char* language : {"de", "en"})
    for (const auto& [percent, size] : {std::pair(200, QSize(1280, 800)), std::pair(200, QSize(1920, 1080)), std::pair(150, QSize(1280, 800)), std::pair(175, QSize(1280, 800))}) {
      SCOPED_TRACE(std::string(language) + ' ' + std::to_string(percent) + " % " + std::to_string(size.width()) + 'x' + std::to_string(size.height()));
      install_language(*qApp, QLatin1String(language));
      apply_theme(*qApp, ColourScheme::light, percent);
      const auto screen = begin(size);
      EXPECT_EQ(screen->size(), size);
      leave_picture(*screen, QStringLiteral("drill-%1-%2-%3").arg(QLatin1String(language)).arg(percent).arg(size.width()));
      expect_whole(*screen);
      expect_apart(*screen->findChild<DrillStage*>());
    }
}

TEST_F(LargeText, asks_for_no_more_height_than_half_of_full_hd_has) {
  const QSize half_of_full_hd(960, 540);
  install_language(*qApp, QStringLiteral("de"));
  apply_theme(*qApp, ColourScheme::light, 150);  // an adjustment to large text
  for (const Guidance guidance : {Guidance::silent, Guidance::full}) {
    SCOPED_TRACE(guidance == Guidance::silent ? "assessment" : "practice");
    const auto screen = begin(half_of_full_hd, guidance);
    EXPECT_EQ(screen->size(), half_of_full_hd) << "a taller stage lies under the tray of burs, with its depth hold";
    leave_picture(*screen, QStringLiteral("drill-de-150-960-%1").arg(guidance == Guidance::silent));
    expect_whole(*screen);
    expect_apart(*screen->findChild<DrillStage*>());
  }
}

TEST_F(LargeText, leaves_cards_over_the_view_whole) {
  apply_theme(*qApp, ColourScheme::light, 200);
  for (const char* language : {"de", "en"}) {
    install_language(*qApp, QLatin1String(language));
    DrillStage stage;
    HomingCard homing(&stage);
    stage.resize(px(408), px(312));  // of 1280 x 800 beside the folded panel
    stage.show();
    const auto expect_whole_with = [&](const char* what) {
      QCoreApplication::processEvents();
      SCOPED_TRACE(std::string(language) + ' ' + what);
      leave_picture(stage, QStringLiteral("drill-card-%1-%2").arg(QLatin1String(language), QLatin1String(what)));
      for (const QWidget* card : std::initializer_list<const QWidget*>{stage.findChild<StopCard*>(), &homing})
        if (card->isVisible()) {
          EXPECT_TRUE(stage.rect().contains(card->geometry())) << named(*card);
          expect_whole(*card);
        }
    };
    LiveView live;
    live.phase = LoopPhase::paused;
    stage.show_values(live);
    expect_whole_with("paused");
    live.phase = LoopPhase::held;
    live.fault = Fault::gone;
    live.device = Sample::Status::gone;
    stage.show_values(live);
    expect_whole_with("gone");
    const FalconView falcon;
    stage.show_values(live, &falcon);
    expect_whole_with("falcon");
    live.recording = RecordingState::failed;
    live.recording_failure = StorageFailure{StorageError::disk_full, "/home/student/records/cusp.db", {}};
    stage.show_values(live);
    expect_whole_with("record");
    stage.show_stopped(StopCard::Stop::record_at_end, describe(*live.recording_failure));
    expect_whole_with("record-at-end");
    stage.show_stopped(StopCard::Stop::none);
    homing.show_falcon(falcon);
    expect_whole_with("homing");
  }
}

TEST_F(LargeText, folds_panel_and_tray_where_a_length_is_twice_as_long_and_unfolds_them_again) {
  apply_theme(*qApp, ColourScheme::light, 200);
  const auto screen = begin(QSize(1280, 800));
  const auto* section = screen->findChild<SectionView*>();
  const auto* panel = screen->findChild<ScorePanel*>();
  EXPECT_FALSE(section->isVisible());
  EXPECT_EQ(panel->width(), px(228));
  EXPECT_EQ(screen->findChild<BurTray*>()->height(), px(40));
  screen->resize(1920, 1080);
  EXPECT_TRUE(section->isVisible());
  EXPECT_EQ(panel->width(), px(304));
  EXPECT_EQ(screen->findChild<BurTray*>()->height(), px(72));
}

}  // namespace
}  // namespace cusp::test
