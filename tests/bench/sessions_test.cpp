// Sessions as students have them, with every bur of the catalogue and its own neck: circles, sways, tremor and a leaning handpiece.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scenarios/burs/bur_catalogue.h"
#include "tests/bench/head_courses.h"
#include "tests/bench/motions.h"
#include "tests/bench/removal.h"
#include "tests/modules.h"

namespace cusp::bench {
namespace {

constexpr int kTicks = 6000;

/// A hand that goes down in circles, drawn from a seed.
class Hand {
 public:
  Hand(const Bur& bur, std::uint64_t seed) : random_(seed), low_mm_(bur.head.ball() ? -bur.radius_mm : bur.head.low()) {
    circle_mm_ = random_.between(0.0, 1.0);
    circles_per_s_ = random_.between(0.5, 8.0);
    down_mm_s_ = random_.between(0.1, 1.0);
    deepest_mm_ = random_.between(0.5, 2.5);
    sway_per_s_ = random_.between(0.3, 5.0);
    tremor_mm_ = seed % 2 == 0 ? random_.between(0.02, 0.1) : 0.0;
    lean_ = seed % 4 < 2 ? random_.between(0.0, 0.35) : 0.0;
    turns_per_s_ = random_.between(0.0, 3.0);
    phase_ = random_.between(0.0, 2.0 * std::numbers::pi);
  }
  StepInput at(int tick) const {
    const double t = 1e-3 * tick, turn = circles_per_s_ * t, shake = tremor_mm_ * std::sin(2.0 * std::numbers::pi * 8.7 * t + phase_);
    const double down = std::min(down_mm_s_ * t * (1.0 + 0.3 * std::sin(sway_per_s_ * t)), deepest_mm_);
    const Vec3 device(circle_mm_ * std::sin(turn) + 0.3 * std::sin(sway_per_s_ * t + phase_) + shake, 0.8 * circle_mm_ * (1.0 - std::cos(turn)) - 0.4 - shake,
                      0.1 - low_mm_ - down + 0.7 * shake);
    const double about = phase_ + turns_per_s_ * t;
    const Vec3 axis(std::sin(lean_) * std::cos(about), std::sin(lean_) * std::sin(about), std::cos(lean_));
    StepInput out = turned_input(device, {0.0, 0.0, 1.0}, axis);
    out.buttons = StepInput::kCut;
    return out;
  }

 private:
  Random random_;
  double low_mm_, circle_mm_, circles_per_s_, down_mm_s_, deepest_mm_, sway_per_s_, tremor_mm_, lean_, turns_per_s_, phase_;
};

TEST(Sessions, let_no_bur_of_the_catalogue_stand_still) {
  std::uint64_t seed = 0;
  for (const CatalogueBur& entry : bur_catalogue()) {
    const auto scene = hole_scene(entry.bur);
    scene->tilt_cosine = 0.5;
    for (int session = 0; session < 4; ++session) {
      const Hand hand(entry.bur, seed++);
      StepState state(scene);
      int run = 0, longest = 0;
      for (int tick = 0; tick < kTicks; ++tick) {
        const StepOutput out = step(state, hand.at(tick));
        run = out.deferred ? run + 1 : 0;
        longest = std::max(longest, run);
      }
      EXPECT_LE(longest, 60) << entry.bur.name << ", session " << session << ": ms without a cut";
    }
  }
}

/// A ball and a head by turns, two seconds each: in the hole that the other has made.
TEST(Sessions, let_no_bur_stand_still_in_another_s_hole) {
  std::vector<const CatalogueBur*> balls, heads;
  for (const CatalogueBur& entry : bur_catalogue()) (entry.bur.head.ball() ? balls : heads).push_back(&entry);
  for (std::uint64_t seed = 0; seed < 36; ++seed) {
    const Bur &ball = balls[seed % balls.size()]->bur, &head = heads[seed % heads.size()]->bur;
    const auto scene = hole_scene(ball);
    scene->tilt_cosine = 0.5;
    scene->burs.push_back(head);
    const Hand hand(ball, seed);
    StepState state(scene);
    int run = 0, longest = 0;
    for (int tick = 0; tick < kTicks; ++tick) {
      StepInput input = hand.at(tick);
      const int of_turn = tick % 2000;
      input.bur = static_cast<std::uint16_t>(tick / 2000 % 2);
      if (of_turn < 400) {  // out of the hole and back, for the other
        input.buttons = 0;
        input.z += static_cast<std::int32_t>(4e4 * std::sin(std::numbers::pi * of_turn / 400.0));
      }
      run = step(state, input).deferred ? run + 1 : 0;
      longest = std::max(longest, run);
    }
    EXPECT_LE(longest, 60) << ball.name << " and " << head.name << ", session " << seed << ": ms without a cut";
  }
}

}  // namespace
}  // namespace cusp::bench
