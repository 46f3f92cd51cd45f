// Proposals on grown teeth: voxels are made, the landmarks forgotten, proposed anew, and compared with those of the generator.

#include "scenarios/landmarks/propose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>

#include "scenarios/import/quarter_turn.h"
#include "scenarios/landmarks/landmarks.h"
#include "scenarios/teeth/tooth.h"
#include "tests/full_run.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// The sixteen kinds, in both hands.
constexpr std::array kKinds = {11, 22, 13, 24, 15, 26, 17, 28, 41, 32, 43, 34, 45, 36, 47, 38};

/// From the nearest place of a line. Ends::are_open: 0 beyond its ends, where it has no side.
enum class Ends : std::uint8_t { are_open, count };
double off_line(Vec3 p, const std::vector<Vec3>& line, Ends ends) {
  double best = 1e9;
  bool beyond = false;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec3 ab = line[i + 1] - line[i];
    const double t = std::clamp(glm::dot(p - line[i], ab) / std::max(1e-12, glm::dot(ab, ab)), 0.0, 1.0);
    const double off = glm::length(p - line[i] - t * ab);
    if (off >= best) continue;
    best = off;
    beyond = (i == 0 && t == 0.0) || (i + 2 == line.size() && t == 1.0);
  }
  return beyond && ends == Ends::are_open ? 0.0 : best;
}

struct Worst {
  double off = 0;
  int found = 0, sought = 0;
};
using Errors = std::map<MarkKind, Worst>;

void add_places(MarkKind kind, const std::vector<SurfacePlace>& truth, const SpecimenLandmarks& found, Errors& out) {
  for (const SurfacePlace& one : truth) {
    ++out[kind].sought;
    const Landmark* mark = found.find(kind, one.name);
    if (mark == nullptr) continue;
    ++out[kind].found;
    out[kind].off = std::max(out[kind].off, glm::length(mark->points_mm.front() - one.at_mm));
  }
}
void add_lines(MarkKind kind, const std::vector<SurfaceLine>& truth, const SpecimenLandmarks& found, Errors& out) {
  for (const SurfaceLine& one : truth) {
    ++out[kind].sought;
    const Landmark* mark = found.find(kind, one.name);
    if (mark == nullptr) continue;
    ++out[kind].found;
    // Its ends are those of the average tooth: what lies beside the true line counts.
    for (const Vec3& p : mark->points_mm) out[kind].off = std::max(out[kind].off, off_line(p, one.points_mm, Ends::are_open));
  }
}

Errors errors_of(const ToothLandmarks& truth, const SpecimenLandmarks& found) {
  Errors out;
  const auto turned = turn_deg(found), tilted = tilt_deg(found);
  out[MarkKind::mesial_axis] = {std::fabs(turned.value_or(0.0)), turned ? 1 : 0, 1};
  out[MarkKind::long_axis] = {tilted.value_or(0.0), tilted ? 1 : 0, 1};
  add_places(MarkKind::cusp_tip, truth.cusp_tips, found, out);
  add_places(MarkKind::pit, truth.pits, found, out);
  add_lines(MarkKind::fissure, truth.fissures, found, out);
  add_lines(MarkKind::marginal_ridge, truth.marginal_ridges, found, out);
  add_places(MarkKind::contact, {{"mesial", truth.mesial_contact}, {"distal", truth.distal_contact}}, found, out);
  const ToothLandmarks grown = as_grown(found);
  out[MarkKind::contour] = {std::fabs(grown.dims.buccolingual - truth.dims.buccolingual), grown.dims.buccolingual > 0 ? 1 : 0, 1};
  ++out[MarkKind::cej].sought;
  if (const Landmark* mark = found.find(MarkKind::cej)) {
    ++out[MarkKind::cej].found;
    for (const Vec3& p : mark->points_mm) out[MarkKind::cej].off = std::max(out[MarkKind::cej].off, off_line(p, truth.cej, Ends::count));
  }
  return out;
}

struct Case {
  std::uint64_t seed;
  double voxel_mm;
};

void expect_within_stated(const std::vector<Case>& cases) {
  Errors all;
  for (const auto& [seed, voxel] : cases)
    for (const int fdi : kKinds) {
      if (!full_run() && fdi != 24 && fdi != 43 && fdi != 36) continue;  // a tooth takes a second
      SCOPED_TRACE("tooth " + std::to_string(fdi) + " seed " + std::to_string(seed) + " voxel " + std::to_string(voxel));
      const auto tooth = grow_tooth({.fdi = fdi, .seed = seed, .voxel_mm = voxel});
      ASSERT_TRUE(tooth);
      const auto found = propose_landmarks(tooth->volume, fdi);
      ASSERT_TRUE(found);
      std::cout << fdi << " seed " << seed << " voxel " << voxel;
      for (const auto& [kind, worst] : errors_of(tooth->landmarks, *found)) {
        std::cout << "  " << key_of(kind) << " " << worst.off << " (" << worst.found << "/" << worst.sought << ")";
        EXPECT_LE(worst.off, proposal_error(kind, voxel)) << key_of(kind);
        Worst& of = all[kind];
        of = {std::max(of.off, worst.off), of.found + worst.found, of.sought + worst.sought};
      }
      std::cout << "\n";
    }
  for (const auto& [kind, worst] : all) std::cout << key_of(kind) << " " << worst.off << " (" << worst.found << "/" << worst.sought << ")\n";
}

// The errors were set on these teeth.
TEST(ProposedLandmarks, OfEveryKindOfToothAreWithinTheirStatedErrors) {
  std::vector<Case> cases = {{3, 0.2}};
  if (full_run()) cases = {{0, 0.1}, {3, 0.1}, {7, 0.1}, {3, 0.2}, {12, 0.2}, {5, 0.15}};
  expect_within_stated(cases);
}

// Nothing was set on these: seeds that were drawn once the errors stood.
TEST(ProposedLandmarks, OfTeethThatNothingWasSetOnAreWithinTheStatedErrorsToo) {
  if (!full_run()) GTEST_SKIP() << "a minute; ./check --full sets CUSP_FULL";
  expect_within_stated({{101, 0.1}, {102, 0.15}, {103, 0.2}, {104, 0.1}, {105, 0.15}, {106, 0.2}});
}

TEST(ProposedLandmarks, FollowAToothThatIsTurned) {
  const auto tooth = grow_tooth({.fdi = 26, .seed = 3, .voxel_mm = 0.3});
  ASSERT_TRUE(tooth);
  for (const int quarters : {1, 2}) {
    const auto found = propose_landmarks(quarter_turned(tooth->volume, 2, quarters), 26);
    ASSERT_TRUE(found);
    const auto turned = turn_deg(*found);
    ASSERT_TRUE(turned) << quarters;
    const double off = std::remainder(*turned - 90.0 * quarters, 360.0);
    EXPECT_LE(std::fabs(off), proposal_error(MarkKind::mesial_axis, 0.3)) << quarters;
    EXPECT_EQ(mesial_x_of(*found), 0) << "its sides are not those of its frame";
  }
}

TEST(ProposedLandmarks, OfOneTissueHaveNoJunction) {
  const auto plastic = grow_tooth({.fdi = 44, .voxel_mm = 0.3, .typodont = true});
  ASSERT_TRUE(plastic);
  const auto found = propose_landmarks(plastic->volume, 44);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->find(MarkKind::cej), nullptr);
  EXPECT_NE(found->find(MarkKind::contact, "mesial"), nullptr);
}

TEST(ProposedLandmarks, NameNothingOfWhatIsNoTooth) {
  Grid grid;
  grid.size = {60, 50, 40};
  grid.voxel_mm = 0.2;
  VoxelVolume block(grid);
  for (int z = 4; z < 36; ++z)
    for (int y = 4; y < 46; ++y)
      for (int x = 4; x < 46; ++x) {
        block.s[grid.index({x, y, z})] = engine::kSolid;
        block.tissue[grid.index({x, y, z})] = Tissue::plastic;
      }
  const auto found = propose_landmarks(block, 36);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->marks.empty()) << "a box has neither axis nor cusps";
  EXPECT_EQ(propose_landmarks(VoxelVolume(grid), 36).error().code, ProposeError::no_tooth);
  EXPECT_EQ(propose_landmarks(block, 19).error().code, ProposeError::unknown_fdi);
}

}  // namespace
}  // namespace cusp::test
