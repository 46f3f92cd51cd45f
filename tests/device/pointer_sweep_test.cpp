// A pointer that sweeps, holds still and releases, over tissue that gives way under its push: what is cut, and how fast
// the bur is out again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

#include "device/pointer/pointer_motion.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

constexpr double kSweepTickS = 0.001;

/// A strip of tissue along x, cut by a ball: each column gives way by the force on it. No friction; walls hold.
struct Strip {
  static constexpr double kCell = 0.05, kRadius = 0.5, kHalf = 5.0;
  static constexpr double kSpeed = 1.2;  // mm/s for a newton: the paper's softest material
  std::vector<double> top = std::vector<double>(static_cast<std::size_t>(2 * kHalf / kCell) + 1, 0.0);
  double stiffness = 2.0;
  Vec3 proxy{0, 0, 1};

  double x_of(std::size_t i) const { return -kHalf + kCell * static_cast<double>(i); }
  /// The columns that a ball over this x may touch: from the first to before the last.
  std::pair<std::size_t, std::size_t> under(double x) const {
    const double column = (x + kHalf) / kCell, reach = kRadius / kCell + 1, most = static_cast<double>(top.size());
    return {static_cast<std::size_t>(std::clamp(column - reach, 0.0, most)), static_cast<std::size_t>(std::clamp(column + reach + 1, 0.0, most))};
  }
  /// Lowest place of the ball's centre over this x.
  double floor_at(double x) const {
    double out = -1e9;
    for (auto [i, end] = under(x); i < end; ++i) {
      const double off = x_of(i) - x;
      if (std::abs(off) < kRadius) out = std::max(out, top[i] + std::sqrt(kRadius * kRadius - off * off));
    }
    return out;
  }
  Feedback feel(Vec3 device) {
    // The proxy goes down and across in steps as far as nothing stands in its way, as a sliding contact does.
    constexpr double kSlide = 0.005;
    for (int i = 0; i < 200; ++i) {
      const double dx = std::clamp(device.x - proxy.x, -kSlide, kSlide);
      const double floor = floor_at(proxy.x + dx);
      // Uphill only as far as the spring's own slope lets it.
      if (floor <= proxy.z + std::abs(dx) || floor <= device.z) proxy.x += dx;
      proxy.z = std::max(device.z, floor_at(proxy.x));
      if (std::abs(dx) < kSlide) break;
    }
    Feedback out;
    out.proxy_mm = {proxy.x, device.y, proxy.z};
    out.stiffness_n_per_mm = stiffness;
    out.force_n = (out.proxy_mm - device) * stiffness;
    out.in_contact = glm::length(out.force_n) > 1e-9;
    return out;
  }
  void cut(const Feedback& felt) {
    const double force = glm::length(felt.force_n);
    if (force < 1e-9) return;
    const Vec3 into = -felt.force_n / force;
    const Vec3 at = proxy + into * (kSpeed * force * kSweepTickS);
    for (auto [i, end] = under(at.x); i < end; ++i) {
      const double off = x_of(i) - at.x;
      if (std::abs(off) < kRadius) top[i] = std::min(top[i], at.z - std::sqrt(kRadius * kRadius - off * off));
    }
  }
  double area() const {
    double out = 0;
    for (const double t : top) out -= t * kCell;
    return out;
  }
  double depth() const { return -*std::ranges::min_element(top); }
  double width() const {
    return kCell * static_cast<double>(std::ranges::count_if(top, [](double t) { return t < -0.02; }));
  }
};

struct SweepBench {
  explicit SweepBench(Vec3 start) : hand(start), motion(start), felt(strip.feel(start)) {}
  Strip strip;
  PointerHand hand;
  PointerMotion motion;
  Feedback felt;
  double most_step_mm = 0;
  void tick() {
    const Vec3 before = motion.device_mm();
    const Vec3 device = motion.advance(hand.latest(), felt, kSweepTickS);
    most_step_mm = std::max(most_step_mm, glm::length(device - before));
    felt = strip.feel(device);
    strip.cut(felt);
  }
};

TEST(PointerMotion, SweepsCutABroadShallowLayerAndHoldingStillSinks) {
  for (const double push : {0.5, 1.0}) {
    SweepBench still(Vec3(0, 0, 1));
    still.hand.set_push(push);
    for (int i = 0; i < 8000; ++i) still.tick();
    for (const double speed : {4.0, 8.0, 16.0}) {
      SweepBench bench(Vec3(0, 0, 1));
      bench.hand.set_push(push);
      double x = 0, way = 1;
      for (int i = 0; i < 8000; ++i) {
        x += way * speed * kSweepTickS;
        if (std::abs(x) > 2.0) way = -way;
        bench.hand.move_to(Vec3(x, 0, 0));
        bench.tick();
      }
      std::cout << push << " N, " << speed << " mm/s: " << bench.strip.area() << " mm2, deepest " << bench.strip.depth()
                << " mm, " << bench.strip.width() << " mm wide; still " << still.strip.depth() << " mm deep\n";
      // Measured 0.038 to 0.148 mm; with the whole push 0.077 to 0.240 mm.
      EXPECT_LT(bench.strip.depth(), 0.15 * push) << push << " N at " << speed << " mm/s";
      EXPECT_GT(bench.strip.width(), 3.5);
      EXPECT_LE(bench.most_step_mm, 0.15 + 1e-12);
    }
    EXPECT_GT(still.strip.depth(), 0.8 * push * Strip::kSpeed * 8.0);
  }
}

TEST(PointerMotion, ASweepingPushStopsAtTheFloorARestingOneSinksAndAHeldDepthStopsBoth) {
  const auto drill = [](double sweep_mm, bool hold) {
    SweepBench bench(Vec3(0, 0, 1));
    bench.hand.set_floor(Vec3(0, 0, -0.5));  // pivot: 1 mm deep, for a radius of 0.5 mm
    if (hold) bench.hand.hold_depth(Vec3(0, 0, -0.2));
    bench.hand.set_push(1.0);
    for (int i = 0; i < 20000; ++i) {
      bench.hand.move_to(Vec3(sweep_mm * std::sin(0.00628 * i), 0, 0));
      bench.tick();
    }
    return bench.strip.depth();
  };
  const double swept = drill(1.0, false);
  EXPECT_LE(swept, 1.0);  // measured 0.90: the pull to the side lifts the bur a little
  EXPECT_GT(swept, 0.8);
  EXPECT_GT(drill(0.0, false), 5.0);
  EXPECT_NEAR(drill(0.0, true), 0.7, 0.01);
  EXPECT_LE(drill(1.0, true), 0.7);  // measured 0.64
}

TEST(PointerMotion, ARestingPushComesToTheFloorAsFastAsWithoutOneAndWaitsThereForAMoment) {
  const auto deep_after = [](double seconds, bool floor) {
    SweepBench bench(Vec3(0, 0, 1));
    if (floor) bench.hand.set_floor(Vec3(0, 0, -0.5));
    bench.hand.set_push(1.0);
    for (int i = 0; i < static_cast<int>(seconds / kSweepTickS); ++i) bench.tick();
    return bench.strip.depth();
  };
  double comes_s = 0;
  while (deep_after(comes_s, false) < 1.0) comes_s += 0.01;
  EXPECT_NEAR(deep_after(comes_s, true), 1.0, 0.01);
  EXPECT_NEAR(deep_after(comes_s + 0.5, true), 1.0, 0.01);  // a hand sees it and releases within 0.3 s [M]
  EXPECT_GT(deep_after(comes_s + 1.0, true), 1.1);
}

TEST(PointerMotion, AReleaseTakesItOutOfADeepHoleAtOnceWhateverThePointerPullsAt) {
  SweepBench bench(Vec3(0, 0, 1));
  bench.hand.set_push(1.5);
  while (bench.strip.depth() < 5.0) bench.tick();
  bench.hand.move_to(Vec3(3, 0, -5));  // the pointer shows the floor of the hole, and lies to the side
  bench.hand.lift();
  int ticks = 0;
  while (bench.motion.device_mm().z < Strip::kRadius + 0.1 && ticks < 2000) {
    bench.tick();
    ++ticks;
    ASSERT_LE(bench.most_step_mm, 0.15 + 1e-12);
  }
  std::cout << "out of " << bench.strip.depth() << " mm after " << ticks << " ms\n";
  EXPECT_LE(ticks, 300);
}

}  // namespace
}  // namespace cusp::test
