// A graphics driver that fails in the middle of an attempt.
#include <gtest/gtest.h>

#include "tests/ui/drill/drill_end.h"
#include "ui/view/tooth_view.h"

namespace cusp::test {
namespace {

using Undrawn = DrillEnd;

TEST_F(Undrawn, an_attempt_whose_tooth_is_drawn_no_more_stands_still_and_can_only_be_left) {
  for (const Guidance guidance : {Guidance::full, Guidance::silent}) {
    begin(plan(guidance));
    Q_EMIT screen->view()->drawing_failed();
    ASSERT_TRUE(wait_for_card("cannot be drawn"));
    EXPECT_EQ(button(card(), "Resume"), nullptr);
    let_it_run();
    EXPECT_EQ(hand->force_n, 0.0);
    const QString stands = clock();
    const double cut = removed();
    screen->toggle_pause();
    let_it_run();
    EXPECT_EQ(clock().toStdString(), stands.toStdString());
    EXPECT_EQ(removed(), cut);
    ASSERT_NE(button(card(), "Leave"), nullptr);
    button(card(), "Leave")->click();
    answer(false);
    let_it_run();
    EXPECT_EQ(removed(), cut) << "staying does not begin it again";
    button(card(), "Leave")->click();
    answer(true);
    EXPECT_FALSE(screen->running());
    screen = std::make_unique<DrillScreen>(ports);
    screen->resize(1280, 800);
    screen->show();
    screen->activateWindow();
  }
}

}  // namespace
}  // namespace cusp::test
