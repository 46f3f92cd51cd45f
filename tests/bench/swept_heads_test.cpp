// SweptHeads against the engine's profile and the slot's exact proxy, and the cavity that `heads` measures with it.
#include "tests/bench/swept_heads.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/contact/surface_contact.h"
#include "engine/tool/swept.h"
#include "scenarios/burs/bur_catalogue.h"
#include "tests/bench/head_slot.h"
#include "tests/bench/heads.h"
#include "tests/random.h"

namespace cusp::bench {
namespace {

using test::Random;

/// Below the face and outside the milled heads; the distance to a convex head is convex along the milled line.
double depth_by_profile(const HeadSlot& slot, const Bur& bur, Vec3 place) {
  const double under = -glm::dot(place - slot.frame.origin, slot.frame.z);
  double low = slot.from_mm, high = slot.to_mm;
  Vec3 gradient;
  const auto far = [&](double along) { return head_distance(bur, slot.axis, place - slot.at(along), gradient); };
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    (far(a) < far(b) ? high : low) = far(a) < far(b) ? b : a;
  }
  return std::min(under, far(0.5 * (low + high)));
}

/// The slot as sweeps of its head.
SweptHeads swept_slot(const HeadSlot& slot, const Bur& bur) {
  const auto piece = [&](Vec3 from, Vec3 to, double share, double next) {
    return HeadSweep{from + (to - from) * share, from + (to - from) * next, slot.axis};
  };
  std::vector<HeadSweep> sweeps;
  for (int k = 0; k < 100; ++k) sweeps.push_back(piece(slot.at(slot.from_mm), slot.at(slot.to_mm), 0.01 * k, 0.01 * (k + 1)));
  sweeps.push_back(piece(slot.above(), slot.at(slot.from_mm), 0.0, 1.0));
  return {bur, sweeps, slot.frame};
}

TEST(SweptHeads, HasTheDepthThatTheProfileGives) {
  Random random(12);
  for (const std::string_view number : {"57", "330", "35"}) {
    const Bur& bur = catalogue_bur(number)->bur;
    const HeadSlot slot = slot_of(bur, unit(oblique_frame().z + oblique_frame().x * 0.1));
    const SweptHeads swept = swept_slot(slot, bur);
    for (int k = 0; k < 200; ++k) {
      const Vec3 off = random.in(Vec3(-0.7), Vec3(0.7));
      const Vec3 place = slot.at(random.between(-1.0, 1.0)) + off;
      Vec3 inwards;
      const double exact = depth_by_profile(slot, bur, place), depth = swept.depth_mm(place, inwards);
      const bool below = glm::dot(place - slot.frame.origin, slot.frame.z) < 0.0;
      if (below && exact > -SweptHeads::kFarMm) {
        EXPECT_NEAR(depth, exact, 1e-5) << number;
      }
      if (exact > 0.01) {
        EXPECT_NEAR(swept.depth_mm(place - inwards * exact, inwards), 0.0, 1e-5) << number;  // on the surface
      }
    }
  }
}

TEST(SweptHeads, ItsProxyIsTheSlotsExactOne) {
  for (const std::string_view number : {"57", "330"}) {
    const Bur& bur = catalogue_bur(number)->bur;
    const HeadSlot slot = slot_of(bur, oblique_frame().z);
    const SweptHeads swept = swept_slot(slot, bur);
    SlotTruth truth(slot, bur, SurfaceContact::kHeadClearanceMm);
    truth.start(slot.at(0.5), slot.axis);
    for (const Vec3 push : {Vec3(0.0, 0.1, -0.2), Vec3(0.0, -0.2, -0.1), Vec3(0.0, 0.0, -0.3)}) {
      const Vec3 device = slot.at(0.5) + slot.frame.direction(push);
      const Exact exact = truth.follow(device, slot.axis);
      const Vec3 from = exact.pose_mm + slot.frame.direction({0.0, 0.001, 0.02});
      const std::optional<Vec3> found = swept.proxy_from(from, slot.axis, device, SurfaceContact::kHeadClearanceMm);
      ASSERT_TRUE(found) << number;
      EXPECT_LT(length(*found - exact.pose_mm), 2e-3) << number;  // places of the skin are 0.04 mm apart
    }
  }
}

TEST(HeadCavity, IsMilledAndComparedTickByTick) {
  Measure what;
  what.speed_mm_s = 50.0;
  const Row row = measure_head_cavity({"330", "cavity", "jitter"}, what, {0.05, 0.05, 400, 100});
  EXPECT_EQ(row.shape, "cavity");
  EXPECT_EQ(row.axis, "jitter");
  EXPECT_EQ(row.minutes, 0.05);
  EXPECT_GE(row.samples + row.skipped, 1);
}

TEST(HeadCavity, NamesAHeadThatIsABall) {
  EXPECT_THROW(measure_head_cavity({"4", "cavity", "fixed"}, {}, {}), std::runtime_error);
}

}  // namespace
}  // namespace cusp::bench
