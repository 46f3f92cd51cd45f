// The scale of a criterion's bands: places, hits and limits, without a widget.

#include "ui/editor/band_scale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "scenarios/format/keys.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

constexpr BandPlot kPlot{10, 20, 300, 60};
constexpr Bands kDepth{1.2, 1.3, 1.5, 2.0, 2.5, 3.0};  // mm, dentistry.md: full, half, none
constexpr BandRange kMm{0, 1e9};
constexpr double kStep = 0.05;

TEST(BandScale, PutsEachEdgeWhereItsValueAndItsShareLie) {
  const BandScale scale(kDepth, kMm, kStep);
  EXPECT_LT(scale.shown().least, 1.2);
  EXPECT_GT(scale.shown().most, 3.0);
  for (std::size_t edge = 0; edge < kBandEdges.size(); ++edge) {
    const BandSpot spot = scale.spot_of(edge, kPlot);
    EXPECT_NEAR(scale.value_at(spot.x, kPlot), kDepth.*kBandEdges[edge], 1e-9);
    EXPECT_DOUBLE_EQ(spot.y, 20 + 60 * (1 - kBandEdgeShares[edge]));
    EXPECT_EQ(scale.edge_at(spot, kPlot, 8), edge);
  }
  EXPECT_EQ(scale.edge_at({10 + 150, 20 + 60}, kPlot, 8), std::nullopt) << "the foot of the band's middle";
}

TEST(BandScale, TellsCoincidingEdgesApartByTheirHeight) {
  const BandScale scale({1, 2, 2, 3, 3, 4}, kMm, kStep);
  const BandSpot half = scale.spot_of(1, kPlot), full = scale.spot_of(2, kPlot);
  EXPECT_DOUBLE_EQ(half.x, full.x);
  EXPECT_EQ(scale.edge_at({half.x + 3, half.y}, kPlot, 10), 1u);
  EXPECT_EQ(scale.edge_at({full.x + 3, full.y}, kPlot, 10), 2u);
}

TEST(BandScale, KeepsTheBandsOrderedWhereverAnEdgeIsDragged) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-20, 20);
  for (int i = 0; i < 2000; ++i) {
    std::array<double, 6> edges{};
    for (double& edge : edges) edge = std::round(anywhere(random) * 100) / 100;
    std::ranges::sort(edges);
    const Bands bands{edges[0], edges[1], edges[2], edges[3], edges[4], edges[5]};
    const BandScale scale(bands, {-20, 20}, kStep);
    const std::size_t edge = random() % 6;
    const Bands after = scale.moved(edge, anywhere(random), kStep);
    std::array<double, 6> now{};
    for (std::size_t k = 0; k < 6; ++k) now[k] = after.*kBandEdges[k];
    EXPECT_TRUE(std::ranges::is_sorted(now)) << "seed 7, " << i;
    edges[edge] = now[edge];
    EXPECT_EQ(now, edges) << "the others stay";
  }
}

TEST(BandScale, SnapsAnEdgeToTheStepOfItsUnit) {
  const BandScale scale(kDepth, kMm, kStep);
  EXPECT_DOUBLE_EQ(scale.moved(3, 2.218, kStep).ideal_hi, 2.2);
  EXPECT_DOUBLE_EQ(scale.moved(3, 2.218, kStep * kFineBandStep).ideal_hi, 2.22);
  EXPECT_DOUBLE_EQ(scale.moved(3, 9.0, kStep).ideal_hi, 2.5) << "its neighbour";
  EXPECT_DOUBLE_EQ(scale.moved(0, -9.0, kStep).fail_lo, 0.0) << "no depth is below the surface";
}

TEST(BandScale, GivesANaturalEndNoHandleAndAFarOneNoRoom) {
  const BandScale removed({0, 60, 97, 100, 100, 100}, {0, 100}, 0.5);
  EXPECT_FALSE(removed.movable(3) || removed.movable(4) || removed.movable(5)) << "nobody removes more than all";
  EXPECT_TRUE(removed.movable(0) && removed.movable(1) && removed.movable(2));
  EXPECT_DOUBLE_EQ(removed.shown().most, 100);
  const BandScale ridge({1.2, 1.6, 2.0, 1000, 1000, 1000}, kMm, kStep);
  EXPECT_LT(ridge.shown().most, 4) << "an end that nothing reaches would flatten the flank";
  EXPECT_FALSE(ridge.movable(3));
  const BandScale over({0, 0, 0, 0.2, 0.6, 1.2}, kMm, kStep);
  EXPECT_DOUBLE_EQ(over.shown().least, 0);
  EXPECT_FALSE(over.movable(0));
  EXPECT_TRUE(over.movable(5));
}

TEST(BandScale, WidensForAMeasuredValueButNotForOneFarOff) {
  const double near[] = {3.4}, far[] = {40};
  EXPECT_GT(BandScale(kDepth, kMm, kStep, near).shown().most, 3.4);
  EXPECT_LT(BandScale(kDepth, kMm, kStep, far).shown().most, 4);
}

TEST(BandScale, HasFourToTwelveFiguresOnTheScaleOfEveryMetric) {
  for (const MetricKey& metric : kMetricKeys) {
    const double step = band_step(metric.unit);
    const double at = std::max(metric.least, 0.0);
    const BandScale scale({at, at, at, at + 10 * step, at + 20 * step, at + 30 * step}, {metric.least, std::max(metric.most, at + 30 * step)}, step);
    const auto ticks = scale.ticks();
    EXPECT_GE(ticks.size(), 4u) << metric.key;
    EXPECT_LE(ticks.size(), 12u) << metric.key;
  }
}

}  // namespace
}  // namespace cusp::test
