// Outer edges of a banded specimen: where they are, how they run, and that nothing else is taken for one. The bounds are
// in voxels beside the measured residual; the trilinear field alone rounds a right angle by 0.22 voxel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/volume/cell_field.h"
#include "engine/volume/specimen.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

constexpr double kVoxel = 0.1;

struct Found {
  Vec3 at{0.0}, tangent{0.0}, bend{0.0};
};

/// Edges and the worst of the other points (distance to the surface, voxels) in the middle of a 5 mm cube.
struct Surface {
  std::vector<Found> edges;
  double worst_point = 0.0;
  int points = 0;
};

std::shared_ptr<const Specimen> specimen_of(const std::function<double(Vec3)>& distance) {
  const int n = 56;
  Grid grid{IVec3(n), kVoxel, Vec3(-0.5 * kVoxel * (n - 1))};
  VoxelVolume volume(grid);
  IVec3 v;
  for (v.z = 0; v.z < n; ++v.z)
    for (v.y = 0; v.y < n; ++v.y)
      for (v.x = 0; v.x < n; ++v.x) {
        const std::size_t i = grid.index(v);
        volume.s[i] = solid_from_distance(distance(grid.centre_mm(v)) / kVoxel);
        if (volume.s[i] > 0) volume.tissue[i] = Tissue::dentine;
      }
  return Specimen::build(volume, Reading::banded);
}

Surface surface_of(const std::function<double(Vec3)>& distance) {
  const auto specimen = specimen_of(distance);
  Surface out;
  const IVec3 bricks = specimen->brick_count();
  for (int b = 0; b < bricks.x * bricks.y * bricks.z; ++b) {
    const BasePoints points = specimen->surface().in(b);
    const Vec3 corner = specimen->grid().origin_mm + kVoxel * Vec3(specimen->brick_at(b) * kBrickEdge);
    for (int i = 0; i < points.count; ++i) {
      const Vec3 p = corner + kVoxel * Vec3(points.x[i], points.y[i], points.z[i]);
      if (std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) > 2.0) continue;
      if (points.normal[i].edge()) {
        out.edges.push_back(
            {p, Vec3(points.normal[i].unit()), Vec3(specimen->surface().edge_details(points, i).first->vector)});
      } else {
        out.worst_point = std::max(out.worst_point, std::fabs(distance(p)) / kVoxel);
        ++out.points;
      }
    }
  }
  return out;
}

/// Distance to the tissue below both planes: exact, so rounded outside.
double wedge(Vec3 p, Vec3 a, Vec3 b) {
  const double da = glm::dot(p, a), db = glm::dot(p, b);
  return da > 0.0 && db > 0.0 ? std::sqrt(da * da + db * db) : std::max(da, db);
}

const Vec3 kA = glm::normalize(Vec3(0.11, 0.18, 1.0));
const Vec3 kB = glm::normalize(glm::cross(kA, Vec3(0.3, 1.0, 0.2)));

TEST(SharpEdge, an_outer_right_angle_is_a_line_without_gaps) {
  const Surface found = surface_of([](Vec3 p) { return wedge(p, kA, kB); });
  const Vec3 line = glm::cross(kA, kB);
  std::vector<double> along;
  double mean = 0.0;
  for (const Found& e : found.edges) {
    const double off = std::sqrt(glm::dot(e.at, e.at) - std::pow(glm::dot(e.at, line), 2)) / kVoxel;
    EXPECT_LT(off, 0.15);  // measured 0.08 at worst
    EXPECT_GT(std::fabs(glm::dot(e.tangent, line)), 0.999);
    mean += off / static_cast<double>(found.edges.size());
    along.push_back(glm::dot(e.at, line) / kVoxel);
  }
  EXPECT_LT(mean, 0.02);
  std::sort(along.begin(), along.end());
  ASSERT_GT(along.size(), 30u);
  // Each holds 0.7 voxel either way.
  for (std::size_t i = 1; i < along.size(); ++i) EXPECT_LT(along[i] - along[i - 1], 1.4);
  EXPECT_LT(found.worst_point, 0.1);  // measured 0.06: points beside the edge stand on their face
}

TEST(SharpEdge, a_curved_rim_bends_as_it_does) {
  // A ball of 1.5 mm, its top cut off 0.5 mm above the middle: the rim is a circle of 1.414 mm.
  const double rim = std::sqrt(1.5 * 1.5 - 0.25);
  const Surface found = surface_of([rim](Vec3 p) {
    const double height = glm::dot(p, kA) - 0.5;
    const double ball = std::sqrt(glm::dot(p, p)) - 1.5;
    const Vec3 flat = p - kA * glm::dot(p, kA);
    const double across = std::sqrt(glm::dot(flat, flat)) - rim;
    // Beyond both the nearest place is the rim.
    if (height > 0.0 && ball > 0.0 && across > 0.0) {
      const double to_ball = glm::dot(Vec3(across, height, 0.0), Vec3(rim / 1.5, 0.5 / 1.5, 0.0));
      if (height > 0.0 && to_ball > 0.0 && across * 0.5 < height * rim) return std::hypot(across, height);
    }
    return std::max(height, ball);
  });
  ASSERT_GT(found.edges.size(), 40u);
  int bent = 0;
  for (const Found& e : found.edges) {
    const double height = glm::dot(e.at, kA) - 0.5;
    const Vec3 flat = e.at - kA * glm::dot(e.at, kA);
    EXPECT_LT(std::hypot(height, std::sqrt(glm::dot(flat, flat)) - rim) / kVoxel, 0.25);
    // x = at + t t + b t^2 on a circle of R voxels: |b| = 1 / 2R, towards its middle.
    const double towards = -glm::dot(e.bend, glm::normalize(flat));
    if (std::fabs(towards - 0.5 * kVoxel / rim) < 0.3 * 0.5 * kVoxel / rim) ++bent;
  }
  EXPECT_GT(bent, static_cast<int>(0.8 * static_cast<double>(found.edges.size())));
}

/// Distance to the tissue below three planes at right angles.
double corner(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 over(glm::dot(p, a), glm::dot(p, b), glm::dot(p, c));
  const double most = std::max({over.x, over.y, over.z});
  return most < 0.0 ? most : glm::length(glm::max(over, Vec3(0.0)));
}

TEST(SharpEdge, three_end_where_they_meet) {
  const Vec3 c = glm::cross(kA, kB), face[3] = {kA, kB, c};
  for (const Vec3 tip : {Vec3(0.0), Vec3(0.013, 0.04, 0.071), Vec3(0.052, -0.027, 0.009)}) {
    const Surface found = surface_of([&](Vec3 p) { return corner(p - tip, kA, kB, c); });
    for (const Vec3& along : face) {
      std::vector<double> at;  // of the pieces, from the corner inwards, voxels
      for (const Found& e : found.edges) {
        if (std::fabs(glm::dot(e.tangent, along)) < 0.999) continue;
        const Vec3 v = (e.at - tip) / kVoxel;
        EXPECT_LT(glm::length(v - along * glm::dot(v, along)), 0.02);
        at.push_back(-glm::dot(v, along));
      }
      std::sort(at.begin(), at.end());
      ASSERT_GT(at.size(), 10u);
      EXPECT_NEAR(at.front(), 0.7, 0.01);  // a piece holds 0.7 voxel either way
      for (std::size_t i = 1; i < at.size(); ++i) EXPECT_LT(at[i] - at[i - 1], 1.4);
    }
    EXPECT_LT(found.worst_point, 0.05);  // measured 0.02
  }
}

TEST(SharpEdge, beside_three_a_face_ends_at_two) {
  const Vec3 c = glm::cross(kA, kB), face[3] = {kA, kB, c};
  const auto specimen = specimen_of([&](Vec3 p) { return corner(p, kA, kB, c); });
  const BaseSurface& surface = specimen->surface();
  const IVec3 bricks = specimen->brick_count();
  int near = 0;
  for (int b = 0; b < bricks.x * bricks.y * bricks.z; ++b) {
    const BasePoints points = surface.in(b);
    for (int i = 0; i < points.count; ++i) {
      const Vec3 p = (specimen->grid().origin_mm + kVoxel * (Vec3(specimen->brick_at(b) * kBrickEdge) +
                                                             Vec3(points.x[i], points.y[i], points.z[i]))) / kVoxel;
      if (points.normal[i].edge() || glm::length(p) > 1.5) continue;
      ++near;
      ASSERT_TRUE(points.normal[i].beside_edge());
      const BaseSurface::EdgeDetails beside = surface.edge_details(points, i);
      ASSERT_NE(beside.second, nullptr);
      for (const BaseSurface::EdgeDetail* other : {beside.first, beside.second}) {
        EXPECT_NEAR(other->other_d, glm::dot(p, Vec3(other->vector)), 0.01);
        EXPECT_TRUE(std::any_of(face, face + 3, [&](Vec3 n) { return glm::dot(n, Vec3(other->vector)) > 0.9999; }));
        EXPECT_LT(glm::dot(Vec3(other->vector), Vec3(points.normal[i].unit())), 0.01);
      }
    }
  }
  EXPECT_GE(near, 6);
}

TEST(SharpEdge, a_smooth_surface_and_an_inner_edge_have_none) {
  EXPECT_TRUE(surface_of([](Vec3 p) { return std::sqrt(glm::dot(p, p)) - 1.7; }).edges.empty());
  EXPECT_TRUE(surface_of([](Vec3 p) { return 0.4 - std::sqrt(glm::dot(p, p)); }).edges.empty());
  const Surface inner = surface_of([](Vec3 p) { return -wedge(p, kA, kB); });
  EXPECT_TRUE(inner.edges.empty());
  EXPECT_GT(inner.points, 500);
}

/// Of the crossed cells in the middle of a 5 mm cube: those whose field rounds an inner edge, and how far the points of
/// the others stand from the surface at most, voxels.
struct InnerEdges {
  int rounded = 0, other = 0;
  double worst_other = 0.0, farthest = 0.0;  // of a rounded one from the line through the origin
};

InnerEdges inner_edges_of(const std::function<double(Vec3)>& distance, Vec3 line) {
  const auto specimen = specimen_of(distance);
  const Grid& grid = specimen->grid();
  InnerEdges out;
  IVec3 cell;
  for (cell.z = 10; cell.z < 45; ++cell.z)
    for (cell.y = 10; cell.y < 45; ++cell.y)
      for (cell.x = 10; cell.x < 45; ++cell.x) {
        CellField field;
        field.load(*specimen, cell);
        Vec3 at, normal;
        if (!field.crossed() || !cell_point(field, at, normal)) continue;
        const Vec3 p = grid.centre_mm(cell) + kVoxel * at;
        if (field.rounds_inner_edge()) {
          ++out.rounded;
          const Vec3 off = p - line * glm::dot(p, line);
          out.farthest = std::max(out.farthest, std::sqrt(glm::dot(off, off)) / kVoxel);
        } else {
          ++out.other;
          out.worst_other = std::max(out.worst_other, std::fabs(distance(p)) / kVoxel);
        }
      }
  return out;
}

TEST(InnerEdge, is_seen_where_the_field_rounds_it) {
  const InnerEdges right = inner_edges_of([](Vec3 p) { return -wedge(p, kA, kB); }, glm::cross(kA, kB));
  EXPECT_GT(right.rounded, 35);
  EXPECT_GT(right.other, 500);
  EXPECT_LT(right.worst_other, 0.02);  // the rounding is 0.3 voxel where it is most
  EXPECT_LT(right.farthest, 2.0);
}

TEST(InnerEdge, is_none_in_a_hollow_of_three_and_a_half_voxels) {
  const InnerEdges ball = inner_edges_of([](Vec3 p) { return 0.35 - std::sqrt(glm::dot(p, p)); }, Vec3(0.0));
  EXPECT_EQ(ball.rounded, 0);
  EXPECT_GT(ball.other, 60);
}

}  // namespace
}  // namespace cusp::test
