// A held button that cuts nothing is asked to be released.
#include <gtest/gtest.h>

#include "tests/ui/drill/drill_end.h"

namespace cusp::test {
namespace {

class HeldCutHint : public DrillEnd {
 protected:
  bool hinted() const {
    for (const QLabel* label : screen->findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(QStringLiteral("press again"))) return true;
    return false;
  }
  bool wait_for_hint(bool wanted) const {
    return QTest::qWaitFor([&] { return hinted() == wanted; }, kComesWithinMs);
  }
};

TEST_F(HeldCutHint, stands_there_after_a_pause_until_the_button_is_released) {
  begin(plan());
  EXPECT_FALSE(hinted());
  screen->toggle_pause();
  ASSERT_TRUE(wait_for_card("Paused"));
  EXPECT_FALSE(hinted()) << "first comes Resume";
  screen->toggle_pause();
  EXPECT_TRUE(wait_for_hint(true));
  let_it_run();
  EXPECT_TRUE(hinted()) << "as long as it is held";
  hand->pressed = false;
  EXPECT_TRUE(wait_for_hint(false));
  hand->pressed = true;
  let_it_run();
  EXPECT_FALSE(hinted());
}

TEST_F(HeldCutHint, stands_there_in_an_assessment_too_after_a_question) {
  begin(plan(Guidance::silent));
  screen->ask_finish();
  let_it_run();
  EXPECT_FALSE(hinted()) << "first comes the answer";
  answer(false);
  EXPECT_TRUE(wait_for_hint(true));
  hand->pressed = false;
  EXPECT_TRUE(wait_for_hint(false));
}

}  // namespace
}  // namespace cusp::test
