// The mesh of the picture, against closed forms of a ball and against itself.
#include "engine/mirror/surface_patches.h"
#include "tests/modules.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace cusp::test {
namespace {

constexpr double kVoxel = 0.1;

/// A ball of radius `mm` in the middle of a padded box.
VoxelVolume ball(double mm, Tissue tissue = Tissue::enamel) {
  const int n = static_cast<int>(std::ceil(2 * mm / kVoxel)) + 10;
  VoxelVolume out(Grid{IVec3(n), kVoxel, Vec3(-kVoxel * (n - 1) / 2.0)});
  IVec3 v;
  for (v.z = 0; v.z < n; ++v.z)
    for (v.y = 0; v.y < n; ++v.y)
      for (v.x = 0; v.x < n; ++v.x) {
        const double d = (glm::length(out.grid.centre_mm(v)) - mm) / kVoxel;
        const std::size_t i = out.grid.index(v);
        out.s[i] = solid_from_distance(d);
        out.tissue[i] = out.s[i] > 0 ? tissue : Tissue::empty;
      }
  return out;
}

/// Carves a ball out of the cut field, as a bur would leave it.
std::vector<int> carve(Volume& volume, Vec3 centre, double mm) {
  std::vector<int> touched;
  const Specimen& specimen = volume.specimen();
  const IVec3 n = specimen.brick_count();
  for (int b = 0; b < n.x * n.y * n.z; ++b) {
    const IVec3 corner = specimen.brick_at(b) * kBrickEdge;
    std::uint16_t* cut = nullptr;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
      const double d = (mm - glm::length(volume.grid().centre_mm(v) - centre)) / kVoxel;
      const std::uint16_t s = solid_from_distance(d);
      if (s == kSolid || s >= volume.cut(v)) continue;
      if (cut == nullptr) cut = volume.cut_for_writing(b);
      if (cut == nullptr) break;
      cut[o] = s;
    }
    if (cut != nullptr) {
      volume.touched(b);
      touched.push_back(b);
    }
  }
  return touched;
}

std::vector<Patch> all_patches(const Volume& volume, int level) {
  std::vector<Patch> out;
  const IVec3 n = volume.specimen().brick_count();
  for (int b = 0; b < n.x * n.y * n.z; ++b) out.push_back(build_patch(volume, b, level));
  return out;
}

using Key = std::array<float, 3>;

struct Mesh {
  std::map<std::pair<Key, Key>, int> edges;  // directed
  double volume = 0, area = 0;
  std::size_t triangles = 0;
};

/// The patches' own triangles, vertices joined where their places are equal bit for bit.
Mesh joined(const std::vector<Patch>& patches) {
  Mesh out;
  for (const Patch& patch : patches) {
    for (std::size_t i = 0; i < patch.own; i += 3) {
      std::array<Vec3, 3> p;
      std::array<Key, 3> key;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3f at = patch.vertices[patch.indices[i + k]].position_mm;
        p[k] = Vec3(at);
        key[k] = {at.x, at.y, at.z};
      }
      for (std::size_t k = 0; k < 3; ++k) ++out.edges[{key[k], key[(k + 1) % 3]}];
      out.volume += glm::dot(p[0], glm::cross(p[1], p[2])) / 6;
      out.area += glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) / 2;
      ++out.triangles;
    }
  }
  return out;
}

void expect_closed(const Mesh& mesh) {
  ASSERT_GT(mesh.triangles, 0u);
  for (const auto& [edge, count] : mesh.edges) {
    ASSERT_EQ(count, 1);
    const auto back = mesh.edges.find({edge.second, edge.first});
    ASSERT_NE(back, mesh.edges.end());
    ASSERT_EQ(back->second, 1);
  }
}

bool same(const Patch& a, const Patch& b) {
  if (a.indices != b.indices || a.own != b.own || a.vertices.size() != b.vertices.size()) return false;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const PatchVertex &p = a.vertices[i], &q = b.vertices[i];
    if (p.position_mm != q.position_mm || p.normal != q.normal || p.tissue != q.tissue || p.cut != q.cut) return false;
  }
  return true;
}

/// At the mouth of a cut two sheets may share an edge: it is then met twice from each side.
void expect_without_gaps(const Mesh& mesh) {
  ASSERT_GT(mesh.triangles, 0u);
  for (const auto& [edge, count] : mesh.edges) {
    const auto back = mesh.edges.find({edge.second, edge.first});
    ASSERT_NE(back, mesh.edges.end());
    ASSERT_EQ(back->second, count);
  }
}

class PatchLevels : public testing::TestWithParam<int> {};

TEST_P(PatchLevels, a_ball_closes_across_bricks_every_edge_met_once_from_each_side) {
  const Volume volume(Specimen::build(ball(1.5), Reading::banded));
  expect_closed(joined(all_patches(volume, GetParam())));
}

TEST_P(PatchLevels, volume_and_area_of_a_ball_are_those_of_the_closed_form_to_the_chords) {
  const double r = 1.5;
  const Volume volume(Specimen::build(ball(r), Reading::banded));
  const Mesh mesh = joined(all_patches(volume, GetParam()));
  // A mesh with its vertices on a sphere loses at most what chords of one cell's diagonal lose: (d / r)^2 / 4 of the
  // volume, d = cell edge, and as much again where a coarse vertex is the mean of fine ones; measured 0.2 and 0.9 %.
  const double cell = kVoxel * GetParam();
  const double bound = 0.6 * cell * cell / (r * r);
  EXPECT_NEAR(mesh.volume / (4.0 / 3 * std::numbers::pi * r * r * r), 1.0, bound);
  EXPECT_NEAR(mesh.area / (4 * std::numbers::pi * r * r), 1.0, bound);
  // The naive reading, a voxel for every s >= 1/2, misses this area by half.
}

TEST_P(PatchLevels, a_cavity_cut_into_a_ball_leaves_no_gap) {
  Volume volume(Specimen::build(ball(1.5), Reading::banded));
  carve(volume, Vec3(0.1, 0.05, 1.3), 0.6);
  expect_without_gaps(joined(all_patches(volume, GetParam())));
}

TEST_P(PatchLevels, rebuilding_only_what_a_cut_touches_equals_building_all_anew) {
  Volume volume(Specimen::build(ball(1.5), Reading::banded));
  std::vector<Patch> patches = all_patches(volume, GetParam());
  for (int step = 0; step < 4; ++step) {
    const std::vector<int> cut = carve(volume, Vec3(0.3 * step - 0.5, 0.1, 1.4), 0.35);
    ASSERT_FALSE(cut.empty());
    std::set<int> anew;
    for (const int b : cut)
      for (const int t : patches_touched_by(volume.specimen(), b)) anew.insert(t);
    for (const int b : anew) patches[static_cast<std::size_t>(b)] = build_patch(volume, b, GetParam());
    const std::vector<Patch> whole = all_patches(volume, GetParam());
    for (std::size_t b = 0; b < whole.size(); ++b) ASSERT_TRUE(same(whole[b], patches[b])) << "brick " << b;
  }
}

INSTANTIATE_TEST_SUITE_P(levels, PatchLevels, testing::Values(kFinePatch, kCoarsePatch));

TEST(SurfacePatches, a_block_that_fills_its_box_has_a_surface_on_all_six_sides) {
  VoxelVolume block(Grid{IVec3(16), kVoxel, Vec3(0.0)});
  std::fill(block.s.begin(), block.s.end(), kSolid);
  std::fill(block.tissue.begin(), block.tissue.end(), Tissue::bone);
  const Volume volume(Specimen::build(block, Reading::filled));
  const Mesh mesh = joined(all_patches(volume, kFinePatch));
  expect_closed(mesh);
  // Faces half a voxel beyond the outer centres: 1.6 mm. Each edge loses a quarter of a voxel's face, since the mean of
  // its crossings stands a quarter of a voxel from each face (measured 4.050, 4.048 by this reckoning).
  EXPECT_NEAR(mesh.volume, 1.6 * 1.6 * 1.6 - 12 * 1.6 * 0.25 * kVoxel * kVoxel, 0.004);
}

TEST(SurfacePatches, normals_point_out_of_the_tissue_and_along_the_radius) {
  const Volume volume(Specimen::build(ball(1.5), Reading::banded));
  double least = 1.0, sum = 0.0;
  std::size_t count = 0;
  for (const Patch& patch : all_patches(volume, kFinePatch))
    for (const PatchVertex& v : patch.vertices) {
      const double along = glm::dot(Vec3(v.normal), glm::normalize(Vec3(v.position_mm)));
      least = std::min(least, along);
      sum += along;
      ++count;
    }
  // Measured: 0.99874 where a ball of 15 voxels has a cell that no polynomial describes, 0.99999 in the mean.
  EXPECT_GT(least, 0.998);
  EXPECT_GT(sum / static_cast<double>(count), 0.99995);
}

/// The mesh near z = 0 is fine, or coarse, by turns of a brick: wherever it is met along a ray, it lies on the ball.
TEST(SurfacePatches, coarse_patches_beside_fine_ones_leave_no_gap_for_a_ray) {
  const double r = 1.5;
  const Volume volume(Specimen::build(ball(r), Reading::banded));
  const IVec3 n = volume.specimen().brick_count();
  std::vector<std::array<Vec3, 3>> triangles;
  std::vector<std::array<Vec3, 3>> without_seam;
  for (int b = 0; b < n.x * n.y * n.z; ++b) {
    const IVec3 at = volume.specimen().brick_at(b);
    const Patch patch = build_patch(volume, b, (at.x + at.y + at.z) % 2 == 0 ? kFinePatch : kCoarsePatch);
    for (std::size_t i = 0; i < patch.indices.size(); i += 3) {
      std::array<Vec3, 3> t;
      for (std::size_t k = 0; k < 3; ++k) t[k] = Vec3(patch.vertices[patch.indices[i + k]].position_mm);
      triangles.push_back(t);
      if (i < patch.own) without_seam.push_back(t);
    }
  }
  // Rays from the middle along a spiral over the whole ball.
  const auto missed = [](const std::vector<std::array<Vec3, 3>>& mesh) {
    int count = 0;
    for (int i = 0; i < 4000; ++i) {
      const double z = 1 - (2 * i + 1) / 4000.0, a = 2.399963 * i, s = std::sqrt(1 - z * z);
      const Vec3 d(s * std::cos(a), s * std::sin(a), z);
      bool met = false;
      for (const auto& t : mesh) {
        const double u = glm::dot(d, glm::cross(t[0], t[1])), v = glm::dot(d, glm::cross(t[1], t[2])),
                     w = glm::dot(d, glm::cross(t[2], t[0]));
        met = u >= -1e-12 && v >= -1e-12 && w >= -1e-12;
        if (met) break;
      }
      count += met ? 0 : 1;
    }
    return count;
  };
  EXPECT_EQ(missed(triangles), 0);
  EXPECT_GT(missed(without_seam), 0);  // the seam is what closes it
}

TEST(SurfacePatches, a_brick_of_air_or_of_whole_tissue_has_no_triangle) {
  const Volume volume(Specimen::build(ball(1.5), Reading::banded));
  EXPECT_TRUE(build_patch(volume, 0, kFinePatch).indices.empty());
  const IVec3 middle = volume.specimen().brick_count() / 2;
  EXPECT_TRUE(build_patch(volume, volume.specimen().brick_index(middle), kFinePatch).indices.empty());
}

TEST(SurfacePatches, what_a_bur_left_is_marked_as_cut_and_the_rest_is_not) {
  Volume volume(Specimen::build(ball(1.5), Reading::banded));
  const Vec3 centre(0.0, 0.0, 1.5);
  carve(volume, centre, 0.5);
  std::size_t cut = 0;
  for (const Patch& patch : all_patches(volume, kFinePatch)) {
    for (const PatchVertex& v : patch.vertices) {
      const double from_cut = glm::length(Vec3(v.position_mm) - centre);
      if (v.cut) ++cut;
      if (from_cut > 0.5 + 2 * kVoxel) {
        EXPECT_FALSE(v.cut);
      }
      if (glm::length(Vec3(v.position_mm)) < 1.5 - 2 * kVoxel) {
        EXPECT_TRUE(v.cut);
      }
    }
  }
  EXPECT_GT(cut, 50u);
}

TEST(SurfacePatches, a_brick_at_the_corner_of_the_box_touches_eight_and_one_inside_twenty_seven) {
  const auto specimen = Specimen::build(ball(1.5), Reading::banded);
  EXPECT_EQ(patches_touched_by(*specimen, 0).size(), 8u);
  EXPECT_EQ(patches_touched_by(*specimen, specimen->brick_index({2, 2, 2})).size(), 27u);
}

}  // namespace
}  // namespace cusp::test
