// Patches of contact, unsupported enamel, caries and protected parts, in two round teeth that touch: against their closed forms.

#include "scenarios/metrics/evidence_patch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "scenarios/metrics/caries.h"
#include "tests/scenarios/metrics/two_teeth.h"

namespace cusp::test {
namespace {

constexpr double kVoxelMm = 0.1;

/// A cut of a specimen, what is measured of it, and the patches.
struct Case {
  std::shared_ptr<const Reference> reference;
  std::shared_ptr<Volume> volume;
  EvidencePatches patches;

  Case(const Scenario& scenario, std::shared_ptr<const Specimen> specimen, const std::function<double(Vec3)>& cut)
      : reference(std::make_shared<const Reference>(scenario, specimen)), volume(carved(specimen, cut)), patches(reference, volume) {}
  static std::shared_ptr<Volume> carved(const std::shared_ptr<const Specimen>& specimen, const std::function<double(Vec3)>& cut) {
    auto out = std::make_shared<Volume>(specimen);
    carved::carve(*out, cut);
    return out;
  }
  Measure measured(std::string_view metric) const { return get(measure(*reference, *volume, {}), metric); }
};

/// What is asked of the measures: others take most of a test's time.
Scenario asking(const std::string& metric) {
  Scenario s = exercise();
  s.rubric = rubric_of({{metric, 0}});
  return s;
}

template <class TissueAt>
std::shared_ptr<const Specimen> specimen_of(TissueAt&& tissue) {
  Draw draw{std::mt19937_64(1)};
  return two_teeth(kVoxelMm, draw, tissue);
}

const std::shared_ptr<const Specimen>& sound_teeth() {
  static const std::shared_ptr<const Specimen> once = specimen_of(tissue_at);
  return once;
}

constexpr auto kUncut = [](Vec3) { return 1.0; };
/// A box from above, 2.4 mm square about x = 1, y = 0.
auto shaft_to(double z) {
  return [z](Vec3 p) { return box_distance(p, Vec3(1, 0, 0.5 * (1 + z)), Vec3(1.2, 1.2, 0.5 * (1 - z))); };
}

double mm2_of(const EvidencePatch& patch) {
  double sum = 0;
  for (const auto& t : patch.triangles) sum += 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
  return sum;
}
Vec3 middle(const std::array<Vec3, 3>& t) { return (t[0] + t[1] + t[2]) / 3.0; }

template <class IsThere>
bool all_lie(const EvidencePatch& patch, IsThere is_there) {
  return std::ranges::all_of(patch.triangles, [&](const auto& t) { return is_there(middle(t)); });
}
double distance_mm(const EvidencePatch& patch, Vec3 p) {
  double least = 1e9;
  for (const auto& t : patch.triangles)
    for (const Vec3& corner : t) least = std::min(least, glm::length(corner - p));
  return least;
}

TEST(TissuePatch, OfAContactThatStandsIsWhereLessThanATenthLiesBetweenTheTeeth) {
  const auto specimen = sound_teeth();
  const Case left(asking("contact_broken"), specimen, [](Vec3 p) { return std::max(Box{}.distance(p), p.x - 4.7); });
  const Measure measured = left.measured("contact_broken");
  ASSERT_TRUE(measured.measured && measured.value == 0.0 && measured.where_mm);
  const EvidencePatch patch = left.patches.of("contact_broken");
  // Two balls of radius R that are 0.01 mm apart are less than 0.1 mm apart within sqrt(0.09 R) of their axis.
  const double radius = std::sqrt((kOpenContactMm - 0.01) * kRadius);
  EXPECT_TRUE(all_lie(patch, [&](Vec3 p) { return std::fabs(own_tooth(p)) < kVoxelMm && std::hypot(p.y, p.z - kMiddle) < radius + 1.5 * kVoxelMm; }));
  double facing_mm2 = 0;
  for (const auto& t : patch.triangles) facing_mm2 += 0.5 * std::fabs(glm::cross(t[1] - t[0], t[2] - t[0]).x);
  const double whole = std::numbers::pi * radius * radius;
  EXPECT_NEAR(facing_mm2, whole, 0.25 * whole) << "a rim of a voxel";
  EXPECT_LT(distance_mm(patch, *measured.where_mm), 1.5 * kVoxelMm);
  const Case open(asking("contact_broken"), specimen, [](Vec3 p) { return Box{}.distance(p); });
  ASSERT_EQ(open.measured("contact_broken").value, 1.0);
  EXPECT_TRUE(open.patches.of("contact_broken").empty());
}

TEST(TissuePatch, OfAClearanceIsTheLineThatIsMeasured) {
  const Case cut(asking("clearance_gingival"), sound_teeth(), [](Vec3 p) { return Box{}.distance(p); });
  int lines = 0;
  for (const Measure& m : measure(*cut.reference, *cut.volume, {})) {
    if (!m.metric.starts_with("clearance_")) continue;
    const EvidencePatch patch = cut.patches.of(m.metric);
    ASSERT_EQ(patch.lines.size(), 1u) << m.metric;
    const auto [from, to] = patch.lines.front();
    EXPECT_EQ(from, *m.where_mm) << m.metric;
    EXPECT_NEAR(glm::length(to - from), m.value, 1e-9) << m.metric;
    EXPECT_NEAR(neighbour(to), 0.0, 0.5 * kVoxelMm) << m.metric;
    ++lines;
  }
  EXPECT_EQ(lines, 7);
  Scenario slot = asking("clearance_gingival");
  slot.target = Box::target().parts.front();  // holds no contact
  const Case elsewhere(slot, cut.volume->specimen_ptr(), [](Vec3 p) { return Box{}.distance(p); });
  for (const char* metric : {"contact_broken", "clearance_gingival"}) EXPECT_TRUE(elsewhere.patches.of(metric).empty()) << metric;
}

TEST(TissuePatch, OfUnsupportedEnamelIsTheSurfaceOfWhatIsUndermined) {
  const UndercutSlot slot{.groove = 0.3};
  const Case cut(asking("unsupported_enamel"), specimen_of(UndercutSlot::tissue), [&](Vec3 p) { return slot.distance(p); });
  const Measure measured = cut.measured("unsupported_enamel");
  ASSERT_GT(measured.value, 0.0);
  const EvidencePatch patch = cut.patches.of("unsupported_enamel");
  const auto is_undermined = [&](Vec3 p) { return own_tooth(p) < 0.0 && UndercutSlot::dentine(p) >= 0.0 && !slot.removed(p) && slot.unsupported(p); };
  EXPECT_TRUE(all_lie(patch, [&](Vec3 p) {
    for (int i = 0; i < 125; ++i)  // within a voxel and a half
      if (is_undermined(p + 0.75 * kVoxelMm * (Vec3(i % 5, i / 5 % 5, i / 25) - 2.0))) return true;
    return false;
  }));
  // All of the tooth's top that is undermined is shown.
  for (double x = -0.5; x < 2.5; x += 0.1)
    for (double y = -1.2; y < 1.2; y += 0.1) {
      bool all = true;
      for (const Vec3 off : {Vec3(0), Vec3(kVoxelMm, 0, 0), Vec3(-kVoxelMm, 0, 0), Vec3(0, kVoxelMm, 0), Vec3(0, -kVoxelMm, 0)})
        all = all && is_undermined(Vec3(x, y, -0.5 * kVoxelMm) + off);
      if (!all) continue;
      EXPECT_LT(distance_mm(patch, Vec3(x, y, 0)), kVoxelMm) << x << " " << y;
    }
  EXPECT_LT(distance_mm(patch, *measured.where_mm), 2 * kVoxelMm);
  // Half a millimetre deep and flared, it cuts no rod of what is left.
  const Case shallow(asking("unsupported_enamel"), cut.volume->specimen_ptr(), [](Vec3 p) { return std::max(-0.5 - p.z, std::hypot(p.x - 1, p.y) - 1.0 - p.z); });
  ASSERT_EQ(shallow.measured("unsupported_enamel").value, 0.0);
  EXPECT_TRUE(shallow.patches.of("unsupported_enamel").empty());
}

TEST(TissuePatch, OfCariesIsTheBareSurfaceOfWhatIsLeft) {
  const Lesion lesion{Vec3(2.1, 0.0, -1.4), 0.9};
  constexpr double kFloor = -1.6;
  const auto specimen = specimen_of(lesion);
  const Case cut(asking("caries_left_pulp"), specimen, [](Vec3 p) { return box_distance(p, Vec3(2, 0, kFloor + 2), Vec3(1.5, 1.5, 2)); });
  const auto off_shell = [](Vec3 p) { return -ball_distance(p, Vec3(0, 0, kMiddle), kDentineRadius); };
  double mm2 = 0;
  for (const char* metric : {"caries_left_periphery", "caries_left_pulp", "caries_left_pulp_firm"}) {
    const EvidencePatch patch = cut.patches.of(metric);
    ASSERT_GT(cut.measured(metric).value, 0.0) << metric;
    ASSERT_FALSE(patch.empty()) << metric;
    mm2 += mm2_of(patch);
    const bool periphery = std::string_view(metric).ends_with("periphery");
    EXPECT_TRUE(all_lie(patch, [&](Vec3 p) {
      const bool there = periphery ? off_shell(p) < kPeripheryMm + kVoxelMm : off_shell(p) > kPeripheryMm - kVoxelMm;
      return there && std::fabs(p.z - kFloor) < 0.5 * kVoxelMm && ball_distance(p, lesion.at, lesion.radius) < kVoxelMm;
    })) << metric;
    EXPECT_LT(distance_mm(patch, *cut.measured(metric).where_mm), lesion.radius) << metric << ": within what is left";
  }
  const double disc = std::numbers::pi * (lesion.radius * lesion.radius - (kFloor - lesion.at.z) * (kFloor - lesion.at.z));
  EXPECT_NEAR(mm2, disc, 0.1 * disc) << "the floor across the lesion";
  // Nothing cut: the tooth's top over the lesion.
  const Case buried(asking("caries_left_pulp"), specimen, kUncut);
  const EvidencePatch over = buried.patches.of("caries_left_pulp");
  EXPECT_FALSE(over.empty());
  EXPECT_TRUE(all_lie(over, [&](Vec3 p) { return std::fabs(p.z) < 0.5 * kVoxelMm && std::hypot(p.x - lesion.at.x, p.y - lesion.at.y) < lesion.radius + kVoxelMm; }));
  const Vec3 within = *buried.measured("caries_left_pulp").where_mm, shown = shown_place("caries_left_pulp", over, within);
  EXPECT_LT(within.z, -0.3) << "in the lesion";
  EXPECT_LT(distance_mm(over, shown), 0.5 * kVoxelMm);
  EXPECT_EQ(shown_place("unsupported_enamel", over, within), within) << "whose place lies on the surface";
  EXPECT_EQ(shown_place("caries_left_pulp", {}, within), within) << "nothing is painted";
  const Case clean(asking("caries_left_pulp"), specimen, [&](Vec3 p) { return ball_distance(p, lesion.at, lesion.radius + 2 * kVoxelMm); });
  for (const char* metric : {"caries_left_periphery", "caries_left_pulp", "caries_left_pulp_firm", "caries_left_enamel"})
    EXPECT_TRUE(clean.patches.of(metric).empty()) << metric;
}

TEST(TissuePatch, OfSoundTissueLostIsTheCutThatIsCounted) {
  Scenario s = asking("sound_lost");
  s.target = box_region({1, 0, -0.5}, {2.4, 2.4, 3});  // down to z = -2
  s.leeway = {0.2, 0.2};
  const auto specimen = specimen_of(Lesion{});
  const Case deep(s, specimen, shaft_to(-2.7));
  const Measure measured = deep.measured("sound_lost");
  const EvidencePatch patch = deep.patches.of("sound_lost");
  EXPECT_NEAR(mm2_of(patch), measured.uncertainty / deep.reference->surface_sigma_mm(), 1e-6) << "the cut face of the measure's uncertainty";
  const double floor_and_walls = 2.4 * 2.4 + 4 * 2.4 * 0.5;  // beyond the zone
  EXPECT_NEAR(mm2_of(patch), floor_and_walls, 0.15 * floor_and_walls);
  EXPECT_TRUE(all_lie(patch, [](Vec3 p) { return p.z < -2.2 + kVoxelMm; }));
  EXPECT_LT(distance_mm(patch, *measured.where_mm), kVoxelMm);
  const Case exact(s, specimen, shaft_to(-2.0));
  ASSERT_EQ(exact.measured("sound_lost").value, 0.0);
  EXPECT_TRUE(exact.patches.of("sound_lost").empty());
}

TEST(TissuePatch, OfANickedNeighbourIsTheNick) {
  Scenario s = asking("protected_removed");
  s.protected_parts = {Protected(kNeighbourEnamel)};
  const auto specimen = sound_teeth();
  const auto nick = [](Vec3 p) { return ball_distance(p, Vec3(5.2, 0, -1.5), 0.6); };
  const Case nicked(s, specimen, nick);
  ASSERT_EQ(nicked.measured("protected_damage").value, 1.0);
  const Case spared(s, specimen, [](Vec3 p) { return std::max(Box{}.distance(p), p.x - 4.7); });
  ASSERT_EQ(spared.measured("protected_removed").value, 0.0);
  for (const char* metric : {"protected_removed", "protected_damage"}) {
    const EvidencePatch patch = nicked.patches.of(metric);
    // The ball's part in the neighbour: a cap 0.8 mm deep less what the neighbour's own roundness takes.
    EXPECT_GT(mm2_of(patch), 0.8 * 2 * std::numbers::pi * 0.6 * 0.7) << metric;
    EXPECT_TRUE(all_lie(patch, [&](Vec3 p) { return std::fabs(nick(p)) < 0.5 * kVoxelMm && neighbour(p) < kVoxelMm; })) << metric;
    EXPECT_TRUE(spared.patches.of(metric).empty()) << metric;
  }
}

TEST(TissuePatch, OfAProtectedRegionIsWhatIsDeepEnoughToDamageIt) {
  Scenario s = asking("protected_damage");
  const auto specimen = sound_teeth();
  const auto with_depth = [&](double depth_mm) {
    // Of 1 mm each way, from z = -2.5 down; the floor at -2.7 is 0.2 mm below its top.
    Protected region(box_region({1, 0, -3}, {1, 1, 1}), Damage::depth);
    region.depth_mm = depth_mm;
    s.protected_parts = {region};
    return Case(s, specimen, shaft_to(-2.7));
  };
  const Case damaged = with_depth(0.1);
  EXPECT_NEAR(mm2_of(damaged.patches.of("protected_removed")), 1.0, 0.1);
  const double inset = 1.0 - 2 * 0.11;  // off the region's sides by the depth and the uncertainty of a place
  EXPECT_NEAR(mm2_of(damaged.patches.of("protected_damage")), inset * inset, 0.15);
  EXPECT_LT(distance_mm(damaged.patches.of("protected_damage"), *damaged.measured("protected_damage").where_mm), kVoxelMm);
  const Case spared = with_depth(0.5);
  ASSERT_EQ(spared.measured("protected_damage").value, 0.0);
  EXPECT_TRUE(spared.patches.of("protected_damage").empty());
  EXPECT_FALSE(spared.patches.of("protected_removed").empty());
}

TEST(TissuePatch, OfAnOpenPulpIsWhereItLiesOpen) {
  const Vec3 at(1, 0, -2.5);
  constexpr double kRadiusMm = 0.5;
  const auto specimen = specimen_of([&](Vec3 p) { return ball_distance(p, at, kRadiusMm) < 0.0 ? Tissue::pulp : tissue_at(p); });
  const Case open(asking("pulp_exposure"), specimen, shaft_to(-2.3));
  ASSERT_EQ(open.measured("pulp_exposure").value, 1.0);
  const EvidencePatch patch = open.patches.of("pulp_exposure");
  const double disc = std::numbers::pi * (kRadiusMm * kRadiusMm - 0.2 * 0.2);
  EXPECT_NEAR(mm2_of(patch), disc, 0.25 * disc) << "a rim of half a voxel";
  EXPECT_LT(distance_mm(patch, *open.measured("pulp_exposure").where_mm), kVoxelMm);
  // All of it gone: the floor beneath, nearest to where it stood.
  const EvidencePatch gone = Case(asking("pulp_exposure"), specimen, shaft_to(-3.2)).patches.of("pulp_exposure");
  EXPECT_FALSE(gone.empty());
  EXPECT_TRUE(all_lie(gone, [](Vec3 p) { return std::fabs(p.z + 3.2) < kVoxelMm && std::hypot(p.x - 1, p.y) < 0.7; }));
  const Case closed(asking("pulp_exposure"), specimen, shaft_to(-1.8));
  ASSERT_EQ(closed.measured("pulp_exposure").value, 0.0);
  EXPECT_TRUE(closed.patches.of("pulp_exposure").empty());
}

}  // namespace
}  // namespace cusp::test
