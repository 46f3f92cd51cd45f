// The exact proxy of heads against closed forms, the engine's own profile and blind sampling; and what `heads` catches.
// CUSP_TOLERANCE_ZERO=1 prints the residuals by failing every bound.
#include "tests/bench/heads.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "engine/contact/surface_contact.h"
#include "scenarios/burs/bur_catalogue.h"
#include "tests/bench/head_courses.h"
#include "tests/bench/rows.h"

namespace cusp::bench {
namespace {

double bound(double value) { return std::getenv("CUSP_TOLERANCE_ZERO") ? 0.0 : value; }

const Bur& bur_of(std::string_view number) { return catalogue_bur(number)->bur; }

Vec3 random_unit(Random& random) {
  const double z = random.between(-1.0, 1.0), phi = random.between(0.0, 2.0 * std::numbers::pi);
  const double rho = std::sqrt(1.0 - z * z);
  return {rho * std::cos(phi), rho * std::sin(phi), z};
}

/// Signed distance of a place to a head by the engine's profile, which the truth does not use.
double by_profile(const Bur& bur, Vec3 axis, Vec3 from_pivot) {
  if (bur.head.ball()) return length(from_pivot) - bur.radius_mm;
  const double t = glm::dot(from_pivot, axis);
  OnHalf none;
  return bur.head.distance({t, length(from_pivot - axis * t)}, none);
}

/// Points of a head's surface from its pivot: furthest in evenly spread directions, and along its straight lines.
std::vector<Vec3> skin(const Bur& bur, Vec3 axis) {
  const HeadCurve curve(bur);
  std::vector<OnHalf> outline;
  constexpr int kAngles = 120, kOnLine = 20;
  for (int i = 0; i <= kAngles; ++i) {
    const double angle = std::numbers::pi * i / kAngles;
    outline.push_back(curve.furthest(OnHalf{std::cos(angle), std::sin(angle)}));
  }
  for (int i = 0; i < bur.head.size(); ++i) {
    const OutlinePiece& p = bur.head.piece(i);
    for (int k = 0; k <= kOnLine && !(p.radius > 0.0); ++k) {
      const double s = static_cast<double>(k) / kOnLine;
      outline.push_back({p.from.t + s * (p.to.t - p.from.t), p.from.rho + s * (p.to.rho - p.from.rho)});
    }
  }
  const Frame f = Frame::of(axis, Vec3(0.31, 0.77, 0.11), Vec3(0.0));
  std::vector<Vec3> out;
  constexpr int kRound = 48;
  for (const OnHalf& o : outline)
    for (int k = 0; k < kRound; ++k) {
      const double phi = 2.0 * std::numbers::pi * k / kRound;
      out.push_back(f.direction({o.rho * std::cos(phi), o.rho * std::sin(phi), o.t}));
    }
  return out;
}

TEST(HeadCurve, HasTheCataloguesLengthAndRadiusAndTheProfilesDistance) {
  Random random(5);
  for (const std::string_view number : kHeadBurs) {
    const CatalogueBur& entry = *catalogue_bur(number);
    const HeadCurve curve(entry.bur);
    const double top = curve.furthest(OnHalf{1.0, 0.0}).t, tip = curve.furthest(OnHalf{-1.0, 0.0}).t;
    EXPECT_NEAR(top - tip, entry.head_length_mm, 1e-12) << number;
    EXPECT_NEAR(tip, -entry.bur.radius_mm, 1e-12) << number;
    EXPECT_NEAR(curve.furthest(OnHalf{0.0, 1.0}).rho, entry.bur.radius_mm, 1e-12) << number;
    for (int k = 0; k < 300; ++k) {
      const Vec3 axis = random_unit(random), place = random_unit(random) * random.between(0.0, 9.0);
      const double far = by_profile(entry.bur, axis, place);
      // The nearest point, and the supporting plane between it and the place: primal and dual give the same distance.
      if (far > 1e-3) {
        const Vec3 nearest = curve.nearest(place, axis), n = unit(place - nearest);
        EXPECT_NEAR(length(place - nearest), far, bound(1e-9)) << number;
        EXPECT_NEAR(glm::dot(n, place - curve.furthest(n, axis)), far, bound(1e-7)) << number;
      }
      const Vec3 u = random_unit(random);
      EXPECT_NEAR(by_profile(entry.bur, axis, curve.furthest(u, axis)), 0.0, bound(1e-9)) << number;
    }
  }
}

TEST(ConvexTruth, LiftsATiltedFissureByItsRim) {
  // The rim's lowest point lies r cos a + r sin a below the pivot: the end stands one radius below it.
  const Bur& bur = bur_of("57");
  const ConvexTissue face;
  ConvexTruth truth(face, bur);
  for (const double tilt : {0.0, 0.1, 0.5}) {
    const Vec3 axis = face.frame.direction({std::sin(tilt), 0.0, std::cos(tilt)});
    const double rim = bur.radius_mm * (std::cos(tilt) + std::sin(tilt));
    truth.start(face.frame.to_world({0.2, 0.1, 2.0}), axis);
    const Exact exact = truth.follow(face.frame.to_world({0.3, 0.1, rim - 0.3}), axis);
    EXPECT_NEAR(length(exact.pose_mm - face.frame.to_world({0.3, 0.1, rim})), 0.0, bound(1e-12)) << tilt;
    EXPECT_NEAR(truth.clearance_mm(face.frame.to_world({1.0, 1.0, rim - 0.2})), -0.2, bound(1e-12)) << tilt;
  }
}

/// A ball against the truth of balls: on the same slide, the other axes of its frame where those differ.
void expect_ball_truth(std::string_view name, ConvexTissue tissue) {
  Bur ball;
  ball.radius_mm = 0.5;
  const auto shape = make_shape(name, ball.radius_mm);
  const auto of_balls = shape->truth();
  ConvexTruth truth(tissue, ball);
  Slide slide(*shape, 50.0, 3);
  const Vec3 first = slide.next(), before = shape->before(first);
  of_balls->start(before);
  truth.start(before, shape->tool_axis());
  double pose = 0.0, clearance = 0.0;
  for (int k = 0; k < 800; ++k) {
    const Vec3 device = k == 0 ? first : slide.next();
    const Exact a = of_balls->follow(device), b = truth.follow(device, shape->tool_axis());
    pose = std::max(pose, length(a.pose_mm - b.pose_mm));
    const Vec3 near = a.pose_mm + (device - a.pose_mm) * 0.01;
    clearance = std::max(clearance, std::fabs(of_balls->clearance_mm(near) - truth.clearance_mm(near)));
  }
  EXPECT_LE(pose, bound(1e-8)) << name;       // mm
  EXPECT_LE(clearance, bound(1e-8)) << name;  // mm
}

TEST(ConvexTruth, EqualsTheTruthOfBalls) {
  ConvexTissue tissue;
  expect_ball_truth("face", tissue);
  tissue.kind = ConvexKind::sphere;
  tissue.radius_mm = 4.0;
  expect_ball_truth("sphere", tissue);
  ConvexTissue edge{ConvexKind::edge, oblique_frame(), 0.0};
  std::swap(edge.frame.x, edge.frame.y);  // that edge runs along y
  expect_ball_truth("edge", edge);
}

struct Blind {
  double in_tissue_mm = 0.0, clearance_mm = 0.0, nearer_mm = 0.0;
  int contacts = 0;
};

/// Follows a turning course. At every tenth tick: the skin against the tissue, and random pivots about the proxy.
Blind blind(std::string_view number, std::string_view shape, const ConvexTissue& tissue) {
  const Bur& bur = bur_of(number);
  const auto course = make_course(shape, bur, 17);
  const auto truth = course->truth();
  AxisMotion axis = course->axis_motion("turning", 4);
  Random random(9);
  truth->start(course->way_in(axis.now()).back(), axis.now());
  Blind out;
  for (int k = 0; k < 120; ++k) {
    const Vec3 device = course->next(axis.next(), 0.05);
    const Exact exact = truth->follow(device, axis.now());
    if (k % 10 != 9 || !exact.contact) continue;
    ++out.contacts;
    double least = 1e9;
    for (const Vec3& point : skin(bur, axis.now())) least = std::min(least, tissue.distance_mm(exact.pose_mm + point));
    out.in_tissue_mm = std::max(out.in_tissue_mm, -least);
    out.clearance_mm = std::max(out.clearance_mm, std::fabs(truth->clearance_mm(exact.pose_mm)));
    // Away from the sphere about the device point a pivot is nearer only by as much as it is inside.
    const double far = length(exact.pose_mm - device);
    for (int i = 0; i < 30; ++i) {
      const Vec3 other = exact.pose_mm + random_unit(random) * std::pow(10.0, random.between(-5.0, -2.0));
      const double closer = far - length(other - device);
      if (closer > 0.0 && truth->clearance_mm(other) > 0.0) out.nearer_mm = std::max(out.nearer_mm, closer);
    }
  }
  return out;
}

TEST(ConvexTruth, TouchesTheTissueAndHasNoNearerAdmissiblePivot) {
  for (const std::string_view number : kHeadBurs)
    for (const std::string_view shape : {"face", "sphere", "edge", "corner"}) {
      ConvexTissue tissue;
      if (shape == "sphere") tissue.kind = ConvexKind::sphere, tissue.radius_mm = 4.0;
      if (shape == "edge") tissue.kind = ConvexKind::edge;
      if (shape == "corner") tissue.kind = ConvexKind::corner;
      const Blind seen = blind(number, shape, tissue);
      EXPECT_GE(seen.contacts, 6) << number << ' ' << shape;
      EXPECT_LE(seen.in_tissue_mm, bound(1e-9)) << number << ' ' << shape;
      EXPECT_LE(seen.clearance_mm, bound(1e-9)) << number << ' ' << shape;
      EXPECT_LE(seen.nearer_mm, bound(1e-8)) << number << ' ' << shape;
    }
}

TEST(ConvexTruth, ClearanceIsTheSkinsDistance) {
  Random random(3);
  const ConvexTissue corner{ConvexKind::corner, oblique_frame(), 0.0};
  for (const std::string_view number : {"57", "330", "368-023"}) {
    const Bur& bur = bur_of(number);
    ConvexTruth truth(corner, bur);
    for (int k = 0; k < 10; ++k) {
      const Vec3 axis = unit(corner.frame.z + random_unit(random) * 0.5);
      const Vec3 pivot = corner.frame.to_world(glm::abs(random_unit(random)) * random.between(2.0, 4.0));
      truth.start(pivot, axis);
      double least = 1e9;
      for (const Vec3& point : skin(bur, axis)) least = std::min(least, corner.distance_mm(pivot + point));
      const double exact = truth.clearance_mm(pivot);
      EXPECT_LE(exact, least + 1e-12) << number;
      EXPECT_GE(exact, least - 0.02) << number;  // samples are 7 degrees and 0.1 mm apart
    }
  }
}

TEST(SlotTruth, HoldsABurWithItsOwnAxisOnTheMilledLine) {
  constexpr double kThin = SurfaceContact::kHeadClearanceMm;
  for (const std::string_view number : kHeadBurs) {
    const Bur& bur = bur_of(number);
    const auto course = make_course("slot", bur, 21);
    const auto truth = course->truth();
    const HeadSlot slot = slot_of(bur, course->rest_axis());
    truth->start(slot.at(0.5), slot.axis);
    double off = 0.0;
    for (int k = 0; k < 30; ++k) {
      const Vec3 device = course->next(slot.axis, 0.05);
      const Exact exact = truth->follow(device, slot.axis);
      ASSERT_TRUE(truth->is_valid());
      const Vec3 foot = slot.at(glm::dot(device - slot.pivot, slot.frame.x));
      off = std::max(off, length(exact.pose_mm - foot - unit(device - foot) * kThin));
    }
    EXPECT_LE(off, bound(5e-3) * kThin) << number;  // 4.4e-3: a quarter of a degree, half a step of the walls' normals
  }
}

/// Depth of a place in what the slot leaves of the tissue: below the face and outside the milled heads.
double in_slot_tissue(const HeadSlot& slot, const Bur& bur, Vec3 place) {
  const double under = -glm::dot(place - slot.frame.origin, slot.frame.z);
  if (under <= 0.0) return under;
  double low = -1.0, high = 1.0;  // of the milled line; the distance to a convex head is convex along it
  const double middle = glm::dot(place - slot.pivot, slot.frame.x);
  const auto far = [&](double along) { return by_profile(bur, slot.axis, place - slot.at(middle + along)); };
  for (int i = 0; i < 28; ++i) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    (far(a) < far(b) ? high : low) = far(a) < far(b) ? b : a;
  }
  return std::min(under, far(0.5 * (low + high)));
}

/// Largest depth of the skin in tissue, largest clearance, and largest gain of a random admissible pivot about the
/// proxy.
struct SlotLook {
  double deepest_mm = 0.0, clearance_mm = 0.0, nearer_mm = 0.0;
  int seen = 0;

  void at(const HeadSlot& slot, const Bur& bur, Vec3 axis, const HeadTruth& truth, const Exact& exact, Vec3 device) {
    ++seen;
    for (const Vec3& point : skin(bur, axis))
      deepest_mm = std::max(deepest_mm, in_slot_tissue(slot, bur, exact.pose_mm + point));
    clearance_mm = std::max(clearance_mm, std::fabs(truth.clearance_mm(exact.pose_mm)));
    Random random(6);
    for (int i = 0; i < 40; ++i) {
      const Vec3 other = exact.pose_mm + random_unit(random) * std::pow(10.0, random.between(-5.0, -2.5));
      const double closer = length(exact.pose_mm - device) - length(other - device);
      if (truth.clearance_mm(other) > 0.0) nearer_mm = std::max(nearer_mm, closer);
    }
  }
  void expect(std::string_view what) const {
    EXPECT_LE(deepest_mm, SurfaceContact::kHeadClearanceMm + bound(1e-5)) << what;  // so much is cut for the head
    EXPECT_LE(clearance_mm, bound(1e-6)) << what;
    EXPECT_LE(nearer_mm, bound(1e-7)) << what;
  }
};

TEST(SlotTruth, KeepsATurnedHeadOutOfTheWallsAndAsNearAsItCan) {
  for (const std::string_view number : {"57", "330", "35", "862-012"})
    for (const std::string_view kind : {"turning", "jitter"}) {
      if (number == "35" && kind == "turning") continue;  // its undercut slot holds an inverted cone upright
      const Bur& bur = bur_of(number);
      const auto course = make_course("slot", bur, 8);
      const auto truth = course->truth();
      const HeadSlot slot = slot_of(bur, course->rest_axis());
      AxisMotion axis = course->axis_motion(kind, 2);
      truth->start(course->way_in(slot.axis).back(), slot.axis);
      SlotLook look;
      for (int k = 0; k < 60; ++k) {
        const Vec3 device = course->next(axis.next(), 0.02);
        const Exact exact = truth->follow(device, axis.now());
        if (k % 30 == 29 && truth->is_valid()) look.at(slot, bur, axis.now(), *truth, exact, device);
      }
      EXPECT_GE(look.seen, 2) << number << ' ' << kind;
      look.expect(number);
    }
}

TEST(SlotTruth, LiftsAHeadOverTheSlotsEdges) {
  // A slot shallower than the football is wide: pushed aside, it rolls over an upper edge.
  const Bur& bur = bur_of("368-023");
  const HeadSlot slot = slot_of(bur, oblique_frame().z);
  for (const double side : {-1.0, 1.0}) {
    SlotTruth truth(slot, bur, SurfaceContact::kHeadClearanceMm);
    truth.start(slot.at(0.5), slot.axis);
    SlotLook look;
    for (int k = 1; k <= 12; ++k) {
      const Vec3 device = slot.at(0.5) + slot.frame.y * (side * 0.025 * k);
      const Exact exact = truth.follow(device, slot.axis);
      if (k % 4 != 0) continue;
      look.at(slot, bur, slot.axis, truth, exact, device);
      EXPECT_GT(glm::dot(exact.pose_mm - slot.pivot, slot.frame.z), 0.03);
    }
    look.expect(side > 0.0 ? "one side" : "other side");
  }
}

Measure quick() {
  Measure what;
  what.voxel_mm = 0.2;
  what.budget_s = 1e9;
  what.most_ticks = 150;
  return what;
}

TEST(Heads, ReadsTheAxisThatTheEngineTakesFromTheInput) {
  Measure what = quick();
  const HeadCase of{"57", "face", "turning"};
  const Vec3 rest = make_course(of.shape, bur_of(of.bur), 1)->rest_axis();
  double off = 0.0, turned = 0.0;
  what.stepper = [&](StepState& state, const StepInput& input) {
    const StepOutput out = step(state, input);
    off = std::max(off, length(out.axis - axis_of_input(input, rest)));
    turned = std::max(turned, length(out.axis - rest));
    return out;
  };
  measure_head(of, "slide", what);
  EXPECT_LE(off, 1e-12);
  EXPECT_GT(turned, 0.1);
}

TEST(Heads, FindsNoErrorInTheExactProxyAndSeesAnIgnoredTurn) {
  const HeadCase of{"330", "edge", "turning"};
  const auto course = make_course(of.shape, bur_of(of.bur), 1);
  const auto truth = course->truth();
  Measure what = quick();
  bool begun = false;
  what.stepper = [&](StepState& state, const StepInput& input) {
    StepOutput out = step(state, input);
    const Vec3 axis = axis_of_input(input, course->rest_axis());
    if (!begun) truth->start(input.position_mm(), axis);
    begun = true;
    out.proxy_mm = truth->follow(input.position_mm(), axis).pose_mm;
    out.force_raw_n = out.proxy_mm - out.device_mm;
    return out;
  };
  const Row exact = measure_head(of, "slide", what);
  EXPECT_EQ(exact.apart_percent, 0.0);
  EXPECT_GE(exact.samples, 100);
  EXPECT_LT(exact.angle_deg_max, 1e-4);
  EXPECT_LT(exact.pose_um_max, 1e-3);
  EXPECT_LT(exact.depth_um_max, 1e-3);

  what.stepper = [](StepState& state, StepInput input) {
    input.qx = input.qy = input.qz = 0;
    input.qw = 32767;
    return step(state, input);
  };
  const Row ignored = measure_head(of, "slide", what);
  EXPECT_GT(ignored.depth_um_mean, 10.0 * measure_head(of, "slide", quick()).depth_um_mean);
}

/// A rim reaches into the inner edge of its own slot, which the field rounds; a tapered flank needs the clearance.
TEST(Heads, SlidesInItsOwnSlotWhileTheHandTrembles) {
  for (const std::string_view number : {"57", "35", "330", "245"}) {
    Measure what = quick();
    what.voxel_mm = 10.0 / 128;
    const Row row = measure_head({number, "slot", "jitter"}, "slide", what);
    EXPECT_GE(row.samples, 400) << number;
    EXPECT_EQ(row.infeasible_ticks, 0) << number;
    EXPECT_EQ(row.apart_percent, 0.0) << number;
    EXPECT_LT(row.angle_deg_mean, 1.0) << number;
    EXPECT_LT(row.pose_um_mean, 5.0) << number;
    EXPECT_LT(row.depth_um_mean, 1.0) << number;
  }
}

/// Without the tissue's own samples a rim goes 5.5 um too deep there.
TEST(Heads, TurnsInItsOwnSlotWithoutEnteringItsInnerEdge) {
  Measure what = quick();
  what.voxel_mm = 10.0 / 128;
  const Row row = measure_head({"57", "slot", "turning"}, "slide", what);
  EXPECT_LT(row.angle_deg_mean, 1.0);
  EXPECT_LT(row.depth_um_max, 3.0);
}

TEST(Heads, GivesARowForEachBurShapeAxisAndMotion) {
  Options options;
  options.burs = {"57"};
  options.shapes = {"face", "slot"};
  options.voxels_mm = {0.2};
  options.budget_s = 0.001;
  const std::vector<Row> rows = heads_rows(options);
  ASSERT_EQ(rows.size(), 3u * 3 + 3u * 2);  // a slot has no presses
  EXPECT_EQ(rows.front().bur, "straight_fissure 57");
  EXPECT_EQ(rows.front().axis, "fixed");
  EXPECT_EQ(rows.front().motion, "press");
  EXPECT_EQ(rows.back().shape, "slot");
  EXPECT_EQ(rows.back().axis, "jitter");
}

}  // namespace
}  // namespace cusp::bench
