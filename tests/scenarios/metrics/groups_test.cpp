// Surface, over-cut by face and margin of boxes carved by analysis. Eight cases at voxels of 0.1 mm; with CUSP_FULL=1 two hundred, a
// hundred each at 0.05 and 0.078 mm, and the rows of scenarios/metrics/errors.md on stdout.

#include "scenarios/metrics/groups.h"

#include "scenarios/shapes/distance.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"
#include "tests/scenarios/metrics/box_exercise.h"
#include "tests/scenarios/metrics/preparation.h"
#include "tests/scenarios/regions.h"

namespace cusp::test {
namespace {

constexpr Vec3 kHalf(3.4, 3.0, 1.7);
/// A block of enamel whose top is a plane through the origin.
struct Block {
  double slope_x = 0, slope_y = 0;
  Vec3 up() const { return glm::normalize(Vec3(-slope_x, -slope_y, 1.0)); }
  double operator()(Vec3 p) const { return std::max(box_distance(p, Vec3(0, 0, -1.7), kHalf + Vec3(0, 0, 0.8)), glm::dot(p, up())); }
};

std::shared_ptr<const Specimen> specimen_of(const Block& block, double voxel_mm, Draw& draw) {
  Grid grid;
  grid.voxel_mm = voxel_mm;
  const Vec3 half = kHalf + Vec3(0, 0, 0.8);
  grid.size = IVec3(glm::ceil(2.0 * half / voxel_mm)) + 10;
  const double x = draw(0, 1), y = draw(0, 1), z = draw(0, 1);
  grid.origin_mm = Vec3(0, 0, -1.7) - half + voxel_mm * (Vec3(x, y, z) - 5.0);
  return carved::specimen(grid, Reading::banded, block, [](Vec3) { return Tissue::enamel; });
}

/// A box about the axis, turned: size over its floor, depth below z = 0, and how much further each face was cut.
struct BoxCut {
  double length = 3, width = 2, depth = 1.8, turn_deg = 0;
  std::array<double, 5> further{};  // mesial, distal, buccal, lingual, floor

  Region region(bool cut) const {
    const auto more = [&](std::size_t i) { return cut ? further[i] : 0.0; };
    const double turn = turn_deg * kRadians, top = 1.0;
    const Vec3 x(std::cos(turn), std::sin(turn), 0), y(-x.y, x.x, 0);
    const Vec3 size(length + more(0) + more(1), width + more(2) + more(3), depth + more(4) + top);
    Region out = box_region(0.5 * (more(0) - more(1)) * x + 0.5 * (more(2) - more(3)) * y + Vec3(0, 0, top - 0.5 * size.z), size);
    out.x_axis = x;
    out.faces = {{"x_low", FaceName::distal_wall}, {"x_high", FaceName::mesial_wall}, {"y_low", FaceName::lingual_wall}, {"y_high", FaceName::buccal_wall}};
    return out;
  }
};

Scenario exercise(const Region& target) {
  Scenario s = box_exercise_on_36({2, 1, 2}, {Tissue::enamel, 3, 0.5});
  s.target = target;
  s.leeway = {0.2, 0.2};
  s.rubric = whole_rubric();
  return s;
}

BoxCut random_box(Draw& draw) {
  BoxCut out{draw(2.4, 3.2), draw(1.6, 2.2), draw(1.4, 2.0), draw(-25, 25), {}};
  for (double& mm : out.further) mm = draw(-0.25, 0.45);
  return out;
}

/// Distances from the target's surface below z = 0 to the cut box, over cells of 0.01 mm.
std::map<std::string, double> surface_truth(const BoxCut& b) {
  const RegionShape cut(b.region(true));
  const double turn = b.turn_deg * kRadians, step = 0.02;
  const Vec3 x(std::cos(turn), std::sin(turn), 0), y(-x.y, x.x, 0);
  std::vector<double> all;
  const auto patch = [&](Vec3 corner, Vec3 u, double along, Vec3 v, double across) {
    for (double s = 0.5 * step; s < along; s += step)
      for (double t = 0.5 * step; t < across; t += step) all.push_back(std::fabs(cut.near(corner + s * u + t * v).distance_mm));
  };
  const Vec3 low = -0.5 * b.length * x - 0.5 * b.width * y - Vec3(0, 0, b.depth), z(0, 0, 1);
  patch(low, x, b.length, y, b.width);
  patch(low, x, b.length, z, b.depth);
  patch(low + b.width * y, x, b.length, z, b.depth);
  patch(low, y, b.width, z, b.depth);
  patch(low + b.length * x, y, b.width, z, b.depth);
  std::ranges::sort(all);
  std::map<std::string, double> out;
  const auto count = static_cast<double>(all.size());
  for (const int um : {100, 200, 300, 400, 500})
    out["surface_within_" + std::to_string(um)] = 100.0 * static_cast<double>(std::ranges::upper_bound(all, 1e-3 * um) - all.begin()) / count;
  double squares = 0;
  for (const double mm : all) squares += mm * mm;
  out["surface_rms"] = std::sqrt(squares / count);
  out["surface_p95"] = all[static_cast<std::size_t>(0.95 * count)];
  out["surface_greatest"] = all.back();
  return out;
}

/// The over-cut of a box that was enlarged: slabs, edges and corners by how far they lie out of each face, divided where the
/// tolerance zone ends.
std::map<std::string, double> volume_truth(const BoxCut& b, double leeway) {
  struct Part {
    FaceName face;        // pulpal_floor also where nothing is beyond
    double from, extent;  // mm out of the face; within: from 0, the target's own
    bool beyond;
  };
  const auto parts_of = [&](std::initializer_list<std::pair<FaceName, double>> ends, double inner) {
    std::vector<Part> out;
    for (const auto& [face, further] : ends) {
      inner += std::min(0.0, further);
      if (further > 0.0) out.push_back({face, 0.0, std::min(further, leeway), true});
      if (further > leeway) out.push_back({face, leeway, further - leeway, true});
    }
    out.push_back({FaceName::pulpal_floor, 0.0, inner, false});
    return out;
  };
  const auto& f = b.further;
  const auto xs = parts_of({{FaceName::mesial_wall, f[0]}, {FaceName::distal_wall, f[1]}}, b.length);
  const auto ys = parts_of({{FaceName::buccal_wall, f[2]}, {FaceName::lingual_wall, f[3]}}, b.width);
  const auto zs = parts_of({{FaceName::pulpal_floor, f[4]}}, b.depth);
  std::map<std::string, double> out;
  for (const char* zone : {"leeway", "beyond"})
    for (const FaceName face : {FaceName::pulpal_floor, FaceName::mesial_wall, FaceName::distal_wall, FaceName::buccal_wall, FaceName::lingual_wall})
      out["overcut_" + std::string(zone) + "_" + std::string(key_of(face))] = 0.0;
  constexpr int kSteps = 60;
  for (const Part& x : xs)
    for (const Part& y : ys)
      for (const Part& z : zs) {
        const std::array<Part, 3> p = {z, x, y};  // the floor first, as the leaf's slots
        const auto steps = [&](std::size_t i) { return p[i].beyond ? kSteps : 1; };
        for (int i = 0; i < steps(0); ++i)
          for (int j = 0; j < steps(1); ++j)
            for (int k = 0; k < steps(2); ++k) {
              const std::array<int, 3> at = {i, j, k};
              double cell = 1, square = 0, most = 0;
              std::optional<FaceName> face;
              for (std::size_t a = 0; a < 3; ++a) {
                cell *= p[a].extent / steps(a);
                const double beyond = p[a].beyond ? p[a].from + p[a].extent * (at[a] + 0.5) / steps(a) : 0.0;
                square += beyond * beyond;
                if (beyond > most) face = p[a].face;
                most = std::max(most, beyond);
              }
              if (face) out["overcut_" + std::string(std::sqrt(square) <= leeway ? "leeway_" : "beyond_") + std::string(key_of(*face))] += cell;
            }
      }
  return out;
}

TEST(Groups, SurfaceAndOverCutOfAKnownBoxAreWithinTheirUncertainty) {
  constexpr std::uint64_t kSeed = 31;
  KnownTable table("block");
  for (const double voxel_mm : known_voxels()) {
    Draw draw{std::mt19937_64(kSeed)};
    for (int i = 0; i < known_cases(voxel_mm, 8, 200); ++i) {
      const BoxCut box = random_box(draw);
      auto truth = surface_truth(box);
      truth.merge(volume_truth(box, 0.2));
      Scenario s = exercise(box.region(false));
      s.rubric = rubric_of(truth);
      const auto specimen = specimen_of({}, voxel_mm, draw);
      Volume volume(specimen);
      carved::carve(volume, [shape = RegionShape(box.region(true))](Vec3 p) { return shape.near(p).distance_mm; });
      count_groups(Reference(s, specimen), volume, truth, table.rows(voxel_mm));
    }
  }
  // Where a whole face lies at a tolerance, its share is unsure.
  table.expect(kSeed, {"surface_within_100", "surface_within_200", "surface_within_300", "surface_within_400", "surface_within_500"});
}

/// A box with a lean of its own for each wall, in a block with a sloping top; its line angles sharp or rounded.
struct LeaningBox {
  std::array<double, 4> lean_deg{};  // mesial, distal, buccal, lingual; above 0: opens upwards
  double half_x = 1.4, half_y = 1.0, depth = 1.8, turn_deg = 0, rounding = 0;

  Vec3 out_of(std::size_t wall) const {
    const double deg = lean_deg[wall] * kRadians, turn = turn_deg * kRadians;
    const Vec3 x(std::cos(turn), std::sin(turn), 0), y(-x.y, x.x, 0);
    const Vec3 level = (wall % 2 == 0 ? 1.0 : -1.0) * (wall < 2 ? x : y);
    return std::cos(deg) * level - Vec3(0, 0, std::sin(deg));
  }
  double out_mm(std::size_t wall) const { return (wall < 2 ? half_x : half_y) * std::cos(lean_deg[wall] * kRadians); }
  double distance(Vec3 p) const {
    double walls = -1e9;
    for (std::size_t i = 0; i < 4; ++i) walls = std::max(walls, glm::dot(p + Vec3(0, 0, depth), out_of(i)) - out_mm(i));
    return rounded_corner(walls, -depth - p.z, rounding);
  }
  /// Corner of the margin between two walls.
  Vec3 corner(std::size_t a, std::size_t b, Vec3 up) const {
    const glm::dmat3 rows = glm::transpose(glm::dmat3(out_of(a), out_of(b), up));
    const Vec3 at = glm::inverse(rows) * Vec3(out_mm(a) - depth * out_of(a).z, out_mm(b) - depth * out_of(b).z, 0.0);
    return at;
  }
};

TEST(Groups, TheCavosurfaceAngleOfAKnownBoxIsWithinItsUncertainty) {
  constexpr std::uint64_t kSeed = 32;
  KnownTable table("block");
  for (const double voxel_mm : known_voxels()) {
    Draw draw{std::mt19937_64(kSeed)};
    for (int i = 0; i < known_cases(voxel_mm, 8, 40); ++i) {
      LeaningBox box;
      for (double& deg : box.lean_deg) deg = draw(-8, 16);
      box.turn_deg = draw(-25, 25);
      box.rounding = i % 2 == 0 ? 0.0 : 0.3;
      const Block block{draw(-0.25, 0.25), draw(-0.25, 0.25)};
      const auto specimen = specimen_of(block, voxel_mm, draw);
      Volume volume(specimen);
      carved::carve(volume, [&](Vec3 p) { return box.distance(p); });
      double sum = 0, all = 0, off = 0;
      for (std::size_t wall = 0; wall < 4; ++wall) {
        const std::size_t one = wall < 2 ? 2 : 0, other = wall < 2 ? 3 : 1;
        const double mm = glm::length(box.corner(wall, one, block.up()) - box.corner(wall, other, block.up()));
        const double deg = 180.0 - std::acos(glm::dot(block.up(), -box.out_of(wall))) / kRadians;
        sum += mm * deg;
        all += mm;
        if (deg < 80 || deg > 110) off += mm;
      }
      const std::map<std::string, double> truth = {{"cavosurface_angle", sum / all}, {"cavosurface_off", 100 * off / all}};
      Scenario s = exercise(BoxCut{}.region(false));
      s.rubric = rubric_of(truth);
      count_groups(Reference(s, specimen), volume, truth, table.rows(voxel_mm));
    }
  }
  // Line angles have no angle, and a whole wall may lie at the band's end.
  table.expect(kSeed, {"cavosurface_angle", "cavosurface_off"});
}

Measure get(const std::vector<Measure>& measures, std::string_view metric) {
  const auto found = std::ranges::find(measures, metric, &Measure::metric);
  return found == measures.end() ? not_measured("absent", "") : *found;
}

TEST(Groups, AreComputedOnlyWhereTheRubricAsksForThem) {
  Draw draw{std::mt19937_64(1)};
  Scenario s = exercise(BoxCut{}.region(false));
  const auto specimen = specimen_of({}, 0.1, draw);
  Volume volume(specimen);
  carved::carve(volume, [shape = RegionShape(BoxCut{}.region(true))](Vec3 p) { return shape.near(p).distance_mm; });
  const auto measured = [&](std::string_view asked, std::string_view metric) {
    s.rubric.criteria.clear();
    if (!asked.empty()) s.rubric.criteria.push_back({std::string(asked), 1, {}});
    return get(measure(Reference(s, specimen), volume, {}), metric).metric != "absent";
  };
  EXPECT_FALSE(measured("", "surface_rms"));
  EXPECT_FALSE(measured("overcut_leeway_floor", "overcut_leeway_pulpal_floor"));
  EXPECT_TRUE(measured("overcut_beyond_mesial_wall", "overcut_leeway_pulpal_floor")) << "a group comes whole";
  EXPECT_TRUE(measured("surface_within_200", "surface_rms"));
  EXPECT_TRUE(measured("cavosurface_off", "cavosurface_angle"));
  EXPECT_FALSE(measured("cavosurface_off", "surface_rms"));
}

TEST(Groups, EachPlaceLiesOnTheSurfaceThatItsMeasureIsOf) {
  Draw draw{std::mt19937_64(33)};
  BoxCut box;
  box.further = {0.3, -0.1, 0.25, 0.1, 0.3};
  const Scenario s = exercise(box.region(false));
  const Block block;
  const auto specimen = specimen_of(block, 0.1, draw);
  const RegionShape target(box.region(false)), cut(box.region(true));
  Volume volume(specimen);
  carved::carve(volume, [&](Vec3 p) { return cut.near(p).distance_mm; });
  int places = 0;
  for (const Measure& m : measure(Reference(s, specimen), volume, {})) {
    const bool overcut = m.metric.starts_with("overcut_") && (m.metric.ends_with("_wall") || m.metric.ends_with("pulpal_floor"));
    const bool margin = m.metric.starts_with("cavosurface_"), surface = m.metric.starts_with("surface_");
    if (!m.measured || !(m.value > 0.0) || !(overcut || margin || surface)) continue;
    ASSERT_TRUE(m.where_mm) << m.metric;
    const double off = surface ? target.near(*m.where_mm).distance_mm : cut.near(*m.where_mm).distance_mm;
    EXPECT_NEAR(off, 0.0, 0.05) << m.metric << ": half a voxel";
    if (margin) {
      EXPECT_NEAR(block(*m.where_mm), 0.0, 0.05) << m.metric;
    }
    ++places;
  }
  EXPECT_GE(places, 10);
}

TEST(Groups, AChordThatTheVoxelsDoNotResolveIsNotMeasured) {
  const Scenario s = exercise(BoxCut{}.region(false));
  for (const auto& [voxel_mm, measured] : {std::pair{0.15, true}, {0.2, false}}) {
    Draw draw{std::mt19937_64(1)};
    const auto specimen = specimen_of({}, voxel_mm, draw);
    Volume volume(specimen);
    carved::carve(volume, [shape = RegionShape(BoxCut{}.region(true))](Vec3 p) { return shape.near(p).distance_mm; });
    EXPECT_EQ(get(measure(Reference(s, specimen), volume, {}), "cavosurface_angle").measured, measured) << voxel_mm;
  }
}

TEST(Groups, WhatCannotBeMeasuredIsNotZero) {
  Draw draw{std::mt19937_64(1)};
  const Scenario s = exercise(BoxCut{}.region(false));
  const auto specimen = specimen_of({}, 0.1, draw);
  const auto untouched = measure(Reference(s, specimen), Volume(specimen), {});
  for (const char* metric : {"surface_within_200", "surface_greatest", "gingival_above_cej", "box_height", "axial_past_junction_mean", "cavosurface_angle",
                             "cavosurface_off", "unsupported_enamel", "contact_broken", "clearance_gingival", "gingival_floor_mesiodistal", "caries_left_periphery"}) {
    EXPECT_EQ(get(untouched, metric).metric, metric);
    EXPECT_FALSE(get(untouched, metric).measured) << metric;
  }
  EXPECT_TRUE(get(untouched, "overcut_beyond_mesial_wall").measured) << "nothing was over-cut";
}

}  // namespace
}  // namespace cusp::test
