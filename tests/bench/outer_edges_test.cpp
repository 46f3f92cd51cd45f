// Heads with a flat end and a sharp rim on the outer edge and corner of a block, against the exact proxy.
#include <gtest/gtest.h>

#include "tests/bench/heads.h"

namespace cusp::bench {
namespace {

Measure on_edges(std::int64_t most_ticks) {
  Measure what;
  what.budget_s = 100.0;  // the ticks end it
  what.most_ticks = most_ticks;
  return what;
}

/// Where a minimum vanishes the two may part, each into another one.
void expect_exact(const Row& row, double apart_percent = 0.5) {
  const std::string of = row.bur + ' ' + row.shape + ' ' + row.axis + ' ' + row.motion;
  EXPECT_GE(row.samples, 50) << of;
  EXPECT_EQ(row.infeasible_ticks, 0) << of;
  EXPECT_LT(row.apart_percent, apart_percent) << of;
  EXPECT_LT(row.angle_deg_mean, 0.4 * apart_percent) << of;
  EXPECT_LT(row.depth_um_mean, 0.1) << of;
}

/// 50 um deep in an edge a head is nearer to its flat end than to the flank that it came with.
TEST(OuterEdges, PressedOnThemAHeadKeepsTheSideThatItCameWith) {
  for (const std::string_view bur : {"57", "35"})
    for (const std::string_view shape : {"edge", "corner"})
      expect_exact(measure_head({bur, shape, "fixed"}, "press", on_edges(100)));
}

/// A rim that rests on one face is no deeper than that in the tissue, however far it is below the other face.
TEST(OuterEdges, SlidingOnOneFaceARimIsNotLiftedByTheOther) {
  for (const std::string_view bur : {"57", "35"})
    for (const std::string_view shape : {"edge", "corner"})
      expect_exact(measure_head({bur, shape, "jitter"}, "slide", on_edges(1000)));
}

/// Where an edge cuts into a rim the head's distance has a kink.
TEST(OuterEdges, CrossedByARimTheyHoldItByWhatDoesNotRunAlongThem) {
  Measure what = on_edges(3000);
  what.speed_mm_s = 5.0;
  const Row row = measure_head({"35", "corner", "fixed"}, "slide", what);
  expect_exact(row, 2.0);  // without it a quarter of the ticks, and 20 degrees
  EXPECT_LT(row.depth_um_max, 5.0);
}

TEST(OuterEdges, AtACornerAnOliveEntersTheTissueByLessThanATenthOfAMicrometre) {
  const Row row = measure_head({"368-023", "corner", "turning"}, "press", on_edges(60));
  expect_exact(row);
}

}  // namespace
}  // namespace cusp::bench
