// Kinds of mesh files, several of them together, and what can be mended.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "scenarios/import/import.h"
#include "scenarios/import/mesh_repair.h"
#include "scenarios/import/triangle_mesh.h"
#include "tests/modules.h"
#include "tests/scenarios/import/image_files.h"

namespace cusp::test {
namespace {


TriangleMesh triangles_of(const Mesh& mesh) {
  TriangleMesh out{mesh.name, mesh.points, {}};
  for (const auto& t : mesh.triangles)
    out.triangles.push_back({static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2])});
  weld(out);
  return out;
}

std::size_t voxels_of(const VoxelVolume& volume, Tissue tissue) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < volume.s.size(); ++i) n += volume.s[i] >= kHalf && volume.tissue[i] == tissue;
  return n;
}

TEST(MeshFiles, StlPlyAndThreeDsHoldTheSameBall) {
  const TempFolder folder;
  const Mesh ball = sphere("ball", {0, 0, 0}, 2.0, 3);
  write_text(folder / "a.stl", binary_stl(ball));
  write_text(folder / "b.ply", ply_file(ball, PlyData::binary));
  write_text(folder / "c.ply", ply_file(ball, PlyData::text));
  write_text(folder / "d.3ds", three_ds_file({ball}));
  write_text(folder / "E.STL", binary_stl(ball));
  for (const char* name : {"a.stl", "b.ply", "c.ply", "d.3ds", "E.STL"}) {
    const auto list = list_meshes(folder / name);
    ASSERT_TRUE(list) << name << " " << list.error().detail;
    ASSERT_EQ(list->size(), 1u) << name;
    EXPECT_TRUE(list->front().closed && list->front().oriented) << name;
    EXPECT_EQ(list->front().triangles, ball.triangles.size()) << name;
    EXPECT_NEAR(list->front().volume, 33.0, 0.5) << name;  // 4/3 pi 8 = 33.5, less the facets
  }
}

TEST(MeshFiles, ThreeDsKeepsItsObjectsApart) {
  const TempFolder folder;
  write_text(folder / "t.3ds", three_ds_file({sphere("crown", {0, 0, 0}, 3.0, 3), sphere("pulp", {0, 0, 0}, 1.0, 2)}));
  const auto list = list_meshes(folder / "t.3ds");
  ASSERT_TRUE(list);
  ASSERT_EQ(list->size(), 2u);
  EXPECT_EQ(list->at(0).name, "crown");
  EXPECT_EQ(list->at(1).name, "pulp");
}

TEST(MeshFiles, NestedFilesGiveTheSameSpecimenInEveryOrder) {
  const TempFolder folder;
  write_text(folder / "enamel.stl", binary_stl(sphere("solid", {0, 0, 0}, 3.0, 3)));
  write_text(folder / "dentine.stl", binary_stl(sphere("solid", {0.2, 0, 0}, 2.0, 3)));
  write_text(folder / "pulp.stl", binary_stl(sphere("solid", {0.2, 0.1, 0}, 1.0, 3)));
  std::vector<std::string> names = {"dentine", "enamel", "pulp"};
  std::optional<VoxelVolume> first;
  do {
    MeshImport what;
    what.voxel_mm = 0.2;
    what.path = folder / (names[0] + ".stl");
    what.more = {folder / (names[1] + ".stl"), folder / (names[2] + ".stl")};
    for (const std::string& name : names) what.tissues.emplace_back(name, *tissue_from_key(name));
    const auto v = import_mesh(what);
    ASSERT_TRUE(v) << key_of(v.error().code) << v.error().where;
    if (!first) first = *v;
    EXPECT_TRUE(v->s == first->s && v->tissue == first->tissue && v->grid == first->grid);
  } while (std::ranges::next_permutation(names).found);
  EXPECT_GT(voxels_of(*first, Tissue::pulp), 400u);
  EXPECT_GT(voxels_of(*first, Tissue::dentine), 2 * voxels_of(*first, Tissue::pulp));
}

TEST(MeshFiles, AnObjOpensNothingButItself) {
  const TempFolder folder;
  const Mesh ball = sphere("ball", {0, 0, 0}, 1.0, 2);
  write_obj(folder / "m.obj", {ball});
  write_text(folder / "m.obj", "mtllib other.mtl\n" + read_text(folder / "m.obj"));
  write_text(folder / "other.mtl", std::string(1000, '\1'));
  EXPECT_TRUE(list_meshes(folder / "m.obj"));
}

TEST(Gaps, TheWidestComesFirstWithItsPlaceAndWidth) {
  Mesh open = sphere("m", {5, 0, 0}, 1.0, 3);
  // All triangles above z 0.9 and one far below.
  std::erase_if(open.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](int p) { return open.points[static_cast<std::size_t>(p)].z > 0.8; });
  });
  const auto lowest = std::ranges::min_element(open.triangles, {}, [&](const auto& t) { return open.points[static_cast<std::size_t>(t[0])].z; });
  open.triangles.erase(lowest);
  const auto gaps = gaps_of(triangles_of(open));
  ASSERT_EQ(gaps.size(), 2u);
  EXPECT_NEAR(gaps[0].middle().x, 5.0, 0.05);
  EXPECT_GT(gaps[0].middle().z, 0.7);
  EXPECT_GT(gaps[0].width(), 1.0);
  EXPECT_EQ(gaps[1].edges, 3u);
  EXPECT_LT(gaps[1].middle().z, -0.9);
}

TEST(Repair, SmallHolesAreClosedAndLargeOnesAreLeft) {
  TriangleMesh mesh = triangles_of(sphere("m", {0, 0, 0}, 2.0, 4));
  const double whole = check(mesh).volume;
  mesh.triangles.erase(mesh.triangles.begin() + 40);
  mesh.triangles.erase(mesh.triangles.begin() + 900);
  TriangleMesh untouched = mesh;
  const MeshRepair done = repair(mesh, 0.5);
  EXPECT_EQ(done.holes_closed, 2u);
  EXPECT_GT(done.widest_hole, 0.05);
  const MeshCheck c = check(mesh);
  EXPECT_TRUE(c.closed && c.oriented);
  EXPECT_NEAR(c.volume, whole, 1e-3 * whole);
  EXPECT_EQ(repair(untouched, 0.01).holes_closed, 0u);
  EXPECT_FALSE(check(untouched).closed);
}

TEST(Repair, CracksTurnedAndDoubledTrianglesAreMended) {
  Mesh ball = sphere("m", {0, 0, 0}, 2.0, 3);
  // Each triangle gets points of its own, shifted by less than a micrometre: an STL that was rounded twice.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-2e-5, 2e-5);
  Mesh cracked{"m", {}, {}};
  for (const auto& t : ball.triangles) {
    const int base = static_cast<int>(cracked.points.size());
    for (const int p : t) cracked.points.push_back(ball.points[static_cast<std::size_t>(p)] + Vec3(shift(random), shift(random), shift(random)));
    cracked.triangles.push_back({base, base + 1, base + 2});
  }
  for (const std::size_t i : {3u, 100u, 101u, 500u}) std::swap(cracked.triangles[i][0], cracked.triangles[i][1]);
  cracked.triangles.push_back(cracked.triangles[7]);
  TriangleMesh mesh = triangles_of(cracked);
  EXPECT_FALSE(check(mesh).closed);
  const MeshRepair done = repair(mesh, 0.0);
  EXPECT_GT(done.points_joined, 3000u);
  EXPECT_EQ(done.triangles_dropped, 1u);
  EXPECT_EQ(done.triangles_turned, 4u);
  const MeshCheck c = check(mesh);
  EXPECT_TRUE(c.closed && c.oriented);
  EXPECT_NEAR(c.volume, check(triangles_of(ball)).volume, 1e-3);
}

TEST(Repair, AClosedSurfaceThatIsThereTwiceOrHasTwoSidesKeepsOne) {
  const Mesh ball = sphere("m", {0, 0, 0}, 2.0, 3);
  for (const bool same_way : {true, false}) {
    TriangleMesh mesh = triangles_of(joined(ball, same_way ? ball : inside_out(ball)));
    ASSERT_TRUE(check(mesh).closed && check(mesh).oriented);
    EXPECT_EQ(repair(mesh, 0.0).triangles_dropped, ball.triangles.size());
    const MeshCheck c = check(mesh);
    EXPECT_TRUE(c.closed && c.oriented);
    EXPECT_NEAR(std::abs(c.volume), check(triangles_of(ball)).volume, 1e-9);
  }
}

TEST(Repair, AShellThatIsInsideOutBesideAnotherIsTurned) {
  const Mesh big = sphere("m", {0, 0, 0}, 2.0, 3), small = sphere("m", {0, 3.0, 0}, 0.9, 2);
  TriangleMesh mesh = triangles_of(joined(big, inside_out(small)));
  EXPECT_EQ(repair(mesh, 0.0).triangles_turned, small.triangles.size());
  EXPECT_EQ(shells_of(mesh).solids.size(), 2u);
  // With a hole in it as well.
  Mesh open = big;
  open.triangles.erase(open.triangles.begin() + 9);
  TriangleMesh holed = triangles_of(joined(open, inside_out(small)));
  const MeshRepair done = repair(holed, 1.0);
  EXPECT_EQ(done.holes_closed, 1u);
  EXPECT_EQ(done.triangles_turned, small.triangles.size());
  EXPECT_EQ(shells_of(holed).solids.size(), 2u);
}

TEST(Repair, AHollowStaysOne) {
  // The second lies across two solids that overlap, in neither's box whole.
  const Mesh one = joined(sphere("m", {0, 0, 0}, 2.0, 3), inside_out(sphere("m", {0.2, 0, 0}, 1.0, 2)));
  const Mesh across = joined(joined(sphere("m", {0, 0, 0}, 2.0, 3), sphere("m", {2.0, 0, 0}, 2.0, 3)), inside_out(sphere("m", {1.0, 0, 0}, 1.2, 2)));
  for (const Mesh& hollow : {one, across}) {
    TriangleMesh mesh = triangles_of(hollow);
    const TriangleMesh before = mesh;
    EXPECT_EQ(repair(mesh, 1.0).triangles_turned, 0u);
    EXPECT_EQ(mesh.triangles, before.triangles);
    EXPECT_EQ(shells_of(mesh).cavities.size(), 1u);
  }
}

TEST(Repair, JoinsThePointsThatAPairwiseSearchJoins) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int> step(0, 40);
  // Loose triangles over a box of diagonal 10, their points on a lattice whose step is the least distance that is joined.
  const double near = 1e-3;
  Mesh loose{"m", {Vec3(0), Vec3(10, 0, 0), Vec3(0, 1e-2, 0)}, {{0, 1, 2}}};
  for (int n = 0; n < 1500; ++n) {
    const int base = static_cast<int>(loose.points.size());
    for (int i = 0; i < 3; ++i) loose.points.push_back(0.999 * near * Vec3(step(random), step(random), step(random)));
    loose.triangles.push_back({base, base + 1, base + 2});
  }
  TriangleMesh mesh = triangles_of(loose);
  const MeshCheck box = check(mesh);
  const double reach = 1e-4 * glm::length(box.high - box.low);
  ASSERT_NEAR(reach, near, 1e-6);
  std::vector<std::size_t> group(mesh.points.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto root = [&](std::size_t i) { while (group[i] != i) i = group[i]; return i; };
  for (std::size_t i = 0; i < group.size(); ++i)
    for (std::size_t j = i + 1; j < group.size(); ++j)
      if (glm::length(mesh.points[i] - mesh.points[j]) <= reach) group[std::max(root(i), root(j))] = std::min(root(i), root(j));
  std::size_t left = 0;
  for (std::size_t i = 0; i < group.size(); ++i) left += root(i) == i;
  EXPECT_GT(left, 1000u);
  EXPECT_EQ(repair(mesh, 0.0).points_joined, group.size() - left);
}

TEST(Repair, ASoundMeshIsLeftAsItIs) {
  TriangleMesh mesh = triangles_of(torus("t", {0, 0, 0}, 3, 1, 40));
  const TriangleMesh before = mesh;
  const MeshRepair done = repair(mesh, 10.0);
  EXPECT_EQ(done.points_joined + done.triangles_dropped + done.triangles_turned + done.holes_closed, 0u);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(Repair, AnImportMendsOnRequestAndReportsIt) {
  const TempFolder folder;
  Mesh open = sphere("ball", {0, 0, 0}, 4.0, 3);
  open.triangles.erase(open.triangles.begin() + 11);
  write_obj(folder / "m.obj", {open});
  MeshImport what;
  what.path = folder / "m.obj";
  what.tissues = {{"ball", Tissue::enamel}};
  what.unit_mm = 0.5;
  const auto refused = import_mesh(what);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ImportError::mesh_open);
  EXPECT_TRUE(refused.error().detail.starts_with("1: ")) << refused.error().detail;
  what.mend_holes_mm = 0.01;
  EXPECT_FALSE(import_mesh(what));
  what.mend_holes_mm = 1.0;
  std::vector<ImportRemark> remarks;
  const auto mended = import_mesh(what, {}, &remarks);
  ASSERT_TRUE(mended) << key_of(mended.error().code);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_EQ(remarks[0].code, RemarkCode::holes_closed);
  EXPECT_EQ(remarks[0].subject, "ball");
  EXPECT_NEAR(static_cast<double>(voxels_of(*mended, Tissue::enamel)) * 1e-3, 33.5, 1.0);
  what.mend_holes_mm = -1.0;
  EXPECT_EQ(import_mesh(what).error().code, ImportError::bad_option);
}

TEST(Unit, TheUsualUnitThatMakesATooth) {
  EXPECT_EQ(guessed_unit_mm(21.6), 1.0);
  EXPECT_EQ(guessed_unit_mm(0.0216), 1000.0);
  EXPECT_EQ(guessed_unit_mm(2.16), 10.0);
  EXPECT_EQ(guessed_unit_mm(21600.0), 0.001);
  EXPECT_EQ(guessed_unit_mm(1e9), 1.0);
}

}  // namespace
}  // namespace cusp::test
