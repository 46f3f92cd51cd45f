// The card over the drilling screen while a Falcon is homed.
#include "ui/drill/homing_card.h"

#include <gtest/gtest.h>

#include "tests/modules.h"

namespace cusp::test {
namespace {

TEST(HomingCard, goes_once_the_falcon_is_homed_though_the_attempt_is_not_open_yet) {
  QWidget over;
  over.resize(800, 600);
  over.show();
  HomingCard card(&over);
  FalconView view;
  view.session.phase = falcon::Phase::homing;
  EXPECT_TRUE(card.show_falcon(view));
  EXPECT_TRUE(card.isVisible());
  view.session.phase = falcon::Phase::ready;
  EXPECT_FALSE(card.show_falcon(view)) << "the progress of the opening stands there again";
  EXPECT_FALSE(card.isVisible());
}

}  // namespace
}  // namespace cusp::test
