#include "ui/view/picture_scale.h"

#include <gtest/gtest.h>

#include "tests/modules.h"

namespace cusp::test {
namespace {

constexpr double kBudgetMs = 24.0;

/// A machine that spends `fixed_ms` on vertices and `pixels_ms` on the pixels of a whole picture.
struct Machine {
  double fixed_ms, pixels_ms;
  double frame_ms(double share) const { return fixed_ms + pixels_ms * share * share; }
};

void draw(PictureScale& scale, const Machine& machine, int frames) {
  for (int i = 0; i < frames; ++i) scale.drawn(machine.frame_ms(scale.share()));
}

TEST(PictureScale, IsWholeAtFirstAndWhereFramesKeepToTheBudget) {
  PictureScale scale(kBudgetMs);
  EXPECT_EQ(scale.share(), 1.0);
  draw(scale, {4.0, 19.0}, 100);
  EXPECT_EQ(scale.share(), 1.0);
}

TEST(PictureScale, TakesTheLargestPictureThatKeepsToTheBudget) {
  PictureScale scale(kBudgetMs);
  const Machine machine{8.0, 30.0};  // 38 ms whole; 29.7 ms at 0.85, 22.7 ms at 0.7
  draw(scale, machine, 100);
  EXPECT_EQ(scale.share(), 0.7);
  EXPECT_LE(machine.frame_ms(scale.share()), kBudgetMs);
  EXPECT_GT(machine.frame_ms(0.85), kBudgetMs);
}

TEST(PictureScale, IsSmallEnoughAfterTwelveFrames) {
  PictureScale scale(kBudgetMs);
  const Machine machine{10.0, 40.0};  // four steps of three frames
  draw(scale, machine, 12);
  EXPECT_LE(machine.frame_ms(scale.share()), kBudgetMs);
}

TEST(PictureScale, NeverGoesBelowAHalf) {
  PictureScale scale(kBudgetMs);
  draw(scale, {500.0, 500.0}, 100);
  EXPECT_EQ(scale.share(), 0.5);
}

TEST(PictureScale, StaysWhereItIsOnceItHasFoundItsStep) {
  for (double pixels_ms = 1.0; pixels_ms < 120.0; pixels_ms += 0.5) {
    for (const double fixed_ms : {0.0, 5.0, 15.0, 25.0}) {
      PictureScale scale(kBudgetMs);
      const Machine machine{fixed_ms, pixels_ms};
      draw(scale, machine, 60);
      const double found = scale.share();
      for (int i = 0; i < 200; ++i) {
        draw(scale, machine, 1);
        ASSERT_EQ(scale.share(), found) << fixed_ms << " + " << pixels_ms << " ms, frame " << i;
      }
    }
  }
}

TEST(PictureScale, DoesNotFollowSingleSlowFrames) {
  PictureScale scale(kBudgetMs);
  for (int i = 0; i < 99; ++i) scale.drawn(i % 3 == 0 ? 200.0 : 20.0);
  EXPECT_EQ(scale.share(), 1.0);
}

TEST(PictureScale, GrowsStepByStepWhenFramesTakeLess) {
  PictureScale scale(kBudgetMs);
  draw(scale, {10.0, 60.0}, 20);
  EXPECT_EQ(scale.share(), 0.5);  // 25 ms: not within the budget, and none is smaller
  draw(scale, {1.0, 10.0}, 12);
  EXPECT_EQ(scale.share(), 0.6);
  draw(scale, {1.0, 10.0}, 36);
  EXPECT_EQ(scale.share(), 1.0);
}

TEST(PictureScale, DoesNotGrowIntoTheBudgetsEdge) {
  PictureScale scale(kBudgetMs);
  for (int i = 0; i < 3; ++i) scale.drawn(30.0);
  ASSERT_EQ(scale.share(), 0.85);  // 21.7 ms expected
  // Whole, 16 ms would become 22.1 ms, which leaves less than a fifth of the budget.
  for (int i = 0; i < 100; ++i) scale.drawn(16.0);
  EXPECT_EQ(scale.share(), 0.85);
  for (int i = 0; i < 12; ++i) scale.drawn(13.0);
  EXPECT_EQ(scale.share(), 1.0);
}

}  // namespace
}  // namespace cusp::test
