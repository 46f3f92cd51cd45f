// Meshes of one tooth that overlap: which tissue gets what, and what is reported of it. The volumes of the prisms are exact.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/volume/cut_volume.h"
#include "engine/volume/specimen.h"
#include "scenarios/import/import.h"
#include "tests/modules.h"
#include "tests/scenarios/import/mesh_files.h"

namespace cusp::test {
namespace {


// An incisor in its roughest form: the outer surface of its enamel, open at the neck; dentine from the root's tip to below
// the incisal edge, with a hollow; and the pulp that fills the hollow.
const Prism kEnamel{4.0, 0.0, 6.0, true}, kDentine{3.0, -10.0, 5.0}, kPulp{1.0, -9.0, 3.0};
const double kEnamelMm3 = kEnamel.mm3() - kDentine.area() * 5.0;
const double kDentineMm3 = kDentine.mm3() - kPulp.mm3();

struct Imported {
  Result<VoxelVolume, ImportFailure> volume;
  std::vector<ImportRemark> remarks;
  SolidMeasure measure;
  double mm3(Tissue tissue) const { return measure.mm3[index_of(tissue)]; }
  const ImportRemark* remark(RemarkCode code, const std::string& subject) const {
    const auto it = std::ranges::find_if(remarks, [&](const ImportRemark& r) { return r.code == code && r.subject == subject; });
    return it == remarks.end() ? nullptr : &*it;
  }
  std::vector<std::string> order() const {
    std::vector<std::string> out;
    for (const ImportRemark& r : remarks)
      if (r.code == RemarkCode::precedence) out.push_back(r.subject);
    return out;
  }
};

Imported import(const std::vector<Mesh>& meshes, const std::vector<std::pair<std::string, Tissue>>& tissues,
                PartPrecedence precedence = PartPrecedence::innermost, double voxel_mm = 0.2) {
  const TempFolder folder;
  write_obj(folder / "m.obj", meshes);
  MeshImport what;
  what.path = folder / "m.obj";
  what.tissues = tissues;
  what.precedence = precedence;
  what.voxel_mm = voxel_mm;
  what.mend_holes_mm = 12.0;
  Imported out;
  out.volume = import_mesh(what, {}, &out.remarks);
  EXPECT_TRUE(out.volume) << key_of(out.volume.error().code) << " " << out.volume.error().where;
  if (out.volume) out.measure = specimen_solid(*Specimen::build(*out.volume, Reading::banded));
  return out;
}

Mesh hollow_dentine() { return joined(prism("dentine", kDentine), inside_out(prism("dentine", kPulp))); }

TEST(MeshPrecedence, AnEnamelShellThatIsOpenAtTheNeckYieldsToTheDentineWithinWhateverTheOrder) {
  std::vector<std::pair<std::string, Tissue>> tissues = {
      {"dentine", Tissue::dentine}, {"enamel", Tissue::enamel}, {"pulp", Tissue::pulp}};
  // Turned, so that no wall lies along the voxels.
  const std::vector<Mesh> meshes = {turned(prism("enamel", kEnamel)), turned(hollow_dentine()), turned(prism("pulp", kPulp))};
  std::optional<VoxelVolume> first;
  do {
    const Imported got = import(meshes, tissues, PartPrecedence::innermost, 0.1);
    ASSERT_TRUE(got.volume);
    // Measured: enamel 0.03 %, dentine 0.02 %, pulp 0.06 %. The rule of least volume gave enamel 301 mm³ for 160.
    EXPECT_NEAR(got.mm3(Tissue::enamel), kEnamelMm3, 0.005 * kEnamelMm3);
    EXPECT_NEAR(got.mm3(Tissue::dentine), kDentineMm3, 0.005 * kDentineMm3);
    EXPECT_NEAR(got.mm3(Tissue::pulp), kPulp.mm3(), 0.005 * kPulp.mm3());
    RecordProperty("enamel", std::to_string(got.mm3(Tissue::enamel) / kEnamelMm3));
    RecordProperty("dentine", std::to_string(got.mm3(Tissue::dentine) / kDentineMm3));
    RecordProperty("pulp", std::to_string(got.mm3(Tissue::pulp) / kPulp.mm3()));
    EXPECT_EQ(got.order(), (std::vector<std::string>{"pulp", "dentine", "enamel"}));
    if (!first) first = *got.volume;
    EXPECT_TRUE(got.volume->s == first->s && got.volume->tissue == first->tissue);
    std::ranges::next_permutation(tissues);
  } while (std::ranges::next_permutation(tissues).found);
}

TEST(MeshPrecedence, AShellThatWasClosedIsNamedWithTheAreaOfItsCap) {
  const Imported got = import({prism("enamel", kEnamel), prism("dentine", kDentine)},
                              {{"enamel", Tissue::enamel}, {"dentine", Tissue::dentine}});
  const ImportRemark* cap = got.remark(RemarkCode::shell_capped, "enamel");
  ASSERT_NE(cap, nullptr);
  EXPECT_NEAR(cap->numbers.at(0), kEnamel.area(), 1e-6 * kEnamel.area());
  const double own = kEnamel.area() + 64 * 2.0 * 4.0 * std::sin(std::numbers::pi / 64) * 6.0;  // upper end and sides
  EXPECT_NEAR(cap->numbers.at(1), kEnamel.area() / own, 1e-6);
  EXPECT_EQ(cap->numbers.at(2), static_cast<double>(index_of(Tissue::enamel)));
  EXPECT_EQ(got.remark(RemarkCode::shell_capped, "dentine"), nullptr);
}

TEST(MeshPrecedence, ASpeckThatWasClosedIsNoShell) {
  Mesh ball = sphere("ball", {0, 0, 0}, 4.0, 3);
  ball.triangles.pop_back();
  const Imported got = import({ball}, {{"ball", Tissue::bone}});
  EXPECT_NE(got.remark(RemarkCode::holes_closed, "ball"), nullptr);
  EXPECT_EQ(got.remark(RemarkCode::shell_capped, "ball"), nullptr);
}

TEST(MeshPrecedence, AnOverlapOfClosedPartsIsReportedWithItsVolumeAndWhoGotIt) {
  const Imported got = import({prism("crown", {4.0, 0.0, 6.0}), prism("core", kDentine), prism("pulp", kPulp)},
                              {{"crown", Tissue::enamel}, {"core", Tissue::dentine}, {"pulp", Tissue::pulp}}, PartPrecedence::innermost, 0.1);
  const ImportRemark* overlap = got.remark(RemarkCode::parts_overlap, "core");
  ASSERT_NE(overlap, nullptr);
  EXPECT_EQ(overlap->other, "crown");
  const double shared = kDentine.area() * 5.0;
  EXPECT_NEAR(overlap->numbers.at(0), shared, 0.01 * shared);  // whole voxels: measured 0.4 %
  EXPECT_EQ(overlap->numbers.at(1), static_cast<double>(index_of(Tissue::dentine)));
  EXPECT_EQ(overlap->numbers.at(2), static_cast<double>(index_of(Tissue::enamel)));
  const ImportRemark* within = got.remark(RemarkCode::part_within, "pulp");
  ASSERT_NE(within, nullptr);
  EXPECT_EQ(within->other, "core");
  EXPECT_NEAR(within->numbers.at(0), kPulp.mm3(), 0.02 * kPulp.mm3());
}

TEST(MeshPrecedence, PartsThatOnlyTouchDoNotOverlap) {
  const Imported got = import({turned(prism("crown", {3.0, 0.0, 6.0})), turned(prism("root", {3.0, -8.0, 0.0}))},
                              {{"crown", Tissue::enamel}, {"root", Tissue::dentine}});
  for (const ImportRemark& r : got.remarks) {
    EXPECT_NE(r.code, RemarkCode::parts_overlap) << r.subject << " " << r.other << " " << r.numbers.at(0);
    EXPECT_NE(r.code, RemarkCode::part_within);
  }
  EXPECT_NEAR(got.mm3(Tissue::enamel), 6.0 * kDentine.area(), 0.005 * 6.0 * kDentine.area());
}

TEST(MeshPrecedence, TheOrderGivenWinsWhereItIsAskedFor) {
  const std::vector<Mesh> meshes = {prism("crown", {4.0, 0.0, 6.0}), prism("core", kDentine)};
  const Imported crown = import(meshes, {{"crown", Tissue::enamel}, {"core", Tissue::dentine}}, PartPrecedence::given);
  EXPECT_NEAR(crown.mm3(Tissue::enamel), kEnamel.mm3(), 0.005 * kEnamel.mm3());
  EXPECT_EQ(crown.order(), (std::vector<std::string>{"crown", "core"}));
  const Imported core = import(meshes, {{"core", Tissue::dentine}, {"crown", Tissue::enamel}}, PartPrecedence::given);
  EXPECT_NEAR(core.mm3(Tissue::enamel), kEnamelMm3, 0.005 * kEnamelMm3);
}

TEST(MeshPrecedence, NothingIsLeftBetweenTwoPartsThatShareAWall) {
  // The dentine's hollow and the pulp have the same wall: each alone is half a voxel there.
  const Imported got = import({turned(hollow_dentine()), turned(prism("pulp", kPulp))},
                              {{"dentine", Tissue::dentine}, {"pulp", Tissue::pulp}}, PartPrecedence::innermost, 0.1);
  ASSERT_TRUE(got.volume);
  const Imported whole = import({turned(prism("dentine", kDentine))}, {{"dentine", Tissue::dentine}}, PartPrecedence::innermost, 0.1);
  ASSERT_TRUE(whole.volume);
  ASSERT_EQ(got.volume->grid, whole.volume->grid);
  std::size_t differs = 0;
  for (std::size_t i = 0; i < whole.volume->s.size(); ++i) differs += got.volume->s[i] != whole.volume->s[i];
  EXPECT_EQ(differs, 0u);
}

TEST(MeshPrecedence, ATooLongOrTooShortToothIsQuestionedWithTheFactorsThatWouldMakeItOne) {
  const auto odd = [](double radius) {
    const TempFolder folder;
    write_obj(folder / "m.obj", {sphere("m", {0, 0, 0}, radius, 3)});
    MeshImport what;
    what.path = folder / "m.obj";
    what.tissues = {{"m", Tissue::dentine}};
    what.voxel_mm = std::min(radius / 10.0, 5.0);
    std::vector<ImportRemark> remarks;
    EXPECT_TRUE(import_mesh(what, {}, &remarks));
    return remarks;
  };
  const auto large = odd(77.5);
  ASSERT_EQ(large.size(), 1u);
  EXPECT_EQ(large[0].code, RemarkCode::size_odd);
  EXPECT_NEAR(large[0].numbers.at(0), 155.0, 1.0);
  EXPECT_EQ(large[0].numbers.at(1), 0.1);
  const auto small = odd(0.65);
  ASSERT_EQ(small.size(), 1u);
  EXPECT_NEAR(small[0].numbers.at(0), 1.3, 0.01);
  EXPECT_EQ(small[0].numbers.at(1), 10.0);
  EXPECT_TRUE(odd(2.1).empty());
  EXPECT_TRUE(odd(49.0).empty());
  EXPECT_FALSE(odd(1.9).empty());
  EXPECT_FALSE(odd(51.0).empty());
}

}  // namespace
}  // namespace cusp::test
