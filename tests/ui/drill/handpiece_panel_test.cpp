// What the panel of the handpiece shows of the step's values, and its keys.
#include "ui/drill/handpiece_panel.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QTest>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/drill/drill_screen.h"

namespace cusp::test {
namespace {

TEST(HandpiecePanel, names_coolant_that_the_pedal_runs_as_on) {
  HandpiecePanel panel;
  panel.set_exercise(load_builtin("class-1-36-wet").value());
  LiveView live;
  live.phase = LoopPhase::running;
  panel.show_values(live);
  EXPECT_TRUE(panel.spoken().contains(QStringLiteral("Coolant is off"))) << panel.spoken().toStdString();
  live.output.phenomena = static_cast<std::uint8_t>(PhenomenonSign::coolant);
  panel.show_values(live);
  EXPECT_TRUE(panel.spoken().contains(QStringLiteral("Coolant is on"))) << panel.spoken().toStdString();
  live.phase = LoopPhase::paused;
  panel.show_values(live);
  EXPECT_TRUE(panel.spoken().contains(QStringLiteral("Coolant is off"))) << "the last values of an attempt that stands";
}

TEST(HandpiecePanel, runs_the_coolant_by_its_key_while_it_is_hidden) {
  DrillScreen screen(Ports::of_the_system());
  SessionPlan plan;
  plan.scenario = load_builtin("channel-1").value();
  plan.scenario.phenomena = {"spindle-turbine", "heat"};
  plan.kind = SessionKind::try_it;
  screen.resize(1280, 800);
  screen.show();
  screen.begin(std::move(plan), {});
  screen.activateWindow();  // shortcuts are the active window's
  ASSERT_TRUE(QTest::qWaitForWindowActive(&screen));
  ASSERT_TRUE(QTest::qWaitFor([&] { return screen.running(); }, 60'000));
  auto* panel = screen.findChild<HandpiecePanel*>();
  panel->findChild<QPushButton*>()->setFocus();
  ASSERT_FALSE(screen.hasFocus());
  QTest::keyClick(&screen, Qt::Key_P, Qt::ControlModifier);
  ASSERT_FALSE(panel->isVisible());
  EXPECT_TRUE(screen.hasFocus()) << "Space drills, and presses no button";
  QTest::keyClick(&screen, Qt::Key_W);
  EXPECT_EQ(panel->accessibleDescription(), QStringLiteral("Coolant is on")) << "it is read out";
  EXPECT_TRUE(panel->spoken().contains(QStringLiteral("Coolant is on"))) << panel->spoken().toStdString();
}

}  // namespace
}  // namespace cusp::test
