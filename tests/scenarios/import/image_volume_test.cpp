// Images as specimens: thresholds, labels, crops, sizes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/volume/cut_volume.h"
#include "engine/volume/specimen.h"
#include "scenarios/import/image_volume.h"
#include "scenarios/import/limit_figures.h"
#include "scenarios/import/components.h"
#include "tests/modules.h"
#include "tests/scenarios/import/image_files.h"

namespace cusp::test {
namespace {

Image grey_ball(IVec3 size, Vec3 spacing, Vec3 centre, double radius) {
  Image out;
  out.layout = *lay_out(size, {Vec3(spacing.x, 0, 0), Vec3(0, spacing.y, 0), Vec3(0, 0, spacing.z)}, Vec3(0.0), {});
  IVec3 v;
  for (v.z = 0; v.z < size.z; ++v.z)
    for (v.y = 0; v.y < size.y; ++v.y)
      for (v.x = 0; v.x < size.x; ++v.x) {
        const double d = glm::length(Vec3(v) * spacing - centre) - radius;
        // What a scanner makes of a sharp edge: half the contrast at the surface.
        out.value.push_back(static_cast<float>(1000.0 - 2000.0 * std::clamp(d / 1.5 + 0.5, 0.0, 1.0)));
      }
  return out;
}

Result<VoxelVolume, ImportFailure> made(const Image& image, const ImageTissues& what, std::vector<ImportRemark>* noted = nullptr) {
  std::vector<ImportRemark> remarks;
  auto out = volume_of_image(image, what, "v", {}, remarks);
  if (noted) *noted = remarks;
  return out;
}

TEST(ImageVolume, AThresholdedBallIsFarMoreExactThanItsVoxels) {
  const Vec3 centre(4.03, 3.97, 4.11);
  const Image image = grey_ball({41, 41, 41}, Vec3(0.2), centre, 3.0);
  ImageTissues what;
  what.thresholds = {{0.0, Tissue::dentine}};
  const auto v = made(image, what);
  ASSERT_TRUE(v);
  double worst = 0.0;
  IVec3 at;
  for (at.z = 0; at.z < v->grid.size.z; ++at.z)
    for (at.y = 0; at.y < v->grid.size.y; ++at.y)
      for (at.x = 0; at.x < v->grid.size.x; ++at.x) {
        const double d = (glm::length(v->grid.centre_mm(at) - centre) - 3.0) / 0.2;
        if (std::abs(d) < 2.0) worst = std::max(worst, std::abs(distance_from_solid(v->s[v->grid.index(at)]) - d));
      }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 0.1);  // measured 0.02 of a voxel; by labels it is half a voxel
  const double exact = 4.0 / 3.0 * std::numbers::pi * 27.0;
  EXPECT_NEAR(specimen_solid(*Specimen::build(*v, Reading::banded)).total_mm3(), exact, 0.005 * exact);
}

TEST(ImageVolume, AnisotropicVoxelsBecomeCubesWithARemark) {
  const Image image = grey_ball({41, 41, 17}, Vec3(0.2, 0.2, 0.5), Vec3(4.0), 3.0);
  ImageTissues what;
  what.thresholds = {{0.0, Tissue::dentine}};
  std::vector<ImportRemark> remarks;
  const auto v = made(image, what, &remarks);
  ASSERT_TRUE(v);
  EXPECT_NEAR(v->grid.voxel_mm, 0.2, 1e-12);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_EQ(remarks[0].code, RemarkCode::resampled);
  EXPECT_EQ(remarks[0].numbers, (std::vector<double>{0.2, 0.2, 0.5, 0.2}));
  const double exact = 4.0 / 3.0 * std::numbers::pi * 27.0;
  EXPECT_NEAR(specimen_solid(*Specimen::build(*v, Reading::banded)).total_mm3(), exact, 0.02 * exact);
  std::vector<ImportRemark> silent;
  ASSERT_TRUE(made(grey_ball({21, 21, 21}, Vec3(0.4), Vec3(4.0), 3.0), what, &silent));
  EXPECT_TRUE(silent.empty());
}

TEST(ImageVolume, LabelsKeepTheirPlaceAndSizeWhenResampled) {
  Image image;
  image.layout = *lay_out({4, 4, 2}, {Vec3(0.5, 0, 0), Vec3(0, 0.5, 0), Vec3(0, 0, 1.0)}, Vec3(10.0), {});
  image.kind = ImageKind::labels;
  image.value.assign(32, 7.0f);
  image.value[0] = 9.0f;
  ImageTissues what;
  what.labels = {{7, Tissue::bone}, {9, Tissue::pulp}};
  const auto v = made(image, what);
  ASSERT_TRUE(v);
  EXPECT_EQ(v->grid.size, IVec3(4 + 8));
  EXPECT_LT(glm::length(v->grid.centre_mm(IVec3(4)) - Vec3(10.0, 10.0, 9.75)), 1e-9);
  std::size_t pulp = 0, bone = 0;
  for (std::size_t i = 0; i < v->s.size(); ++i) {
    pulp += v->s[i] >= kHalf && v->tissue[i] == Tissue::pulp;
    bone += v->s[i] >= kHalf && v->tissue[i] == Tissue::bone;
  }
  EXPECT_EQ(pulp, 2u);
  EXPECT_EQ(bone, 62u);
}

TEST(ImageVolume, ALabelThatNoVoxelHasIsRefusedByItsNumber) {
  Image image;
  image.layout = *lay_out({4, 4, 4}, {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, Vec3(0.0), {});
  image.kind = ImageKind::labels;
  image.value.assign(64, 2.0f);
  image.value[5] = 0.0f;
  image.value[9] = 4.0f;
  const auto refused = [&](std::uint32_t label) {
    ImageTissues what;
    what.labels = {{2, Tissue::dentine}, {label, Tissue::pulp}};
    const auto r = made(image, what);
    return r ? std::string("read") : std::string(key_of(r.error().code)) + " " + r.error().where;
  };
  EXPECT_EQ(refused(4), "read");
  EXPECT_EQ(refused(3), "mesh_not_found 3") << "the tooth would have no pulp";
  EXPECT_EQ(refused(0), "mesh_not_found 0") << "0 stands for nothing";
}

TEST(ImageVolume, WhatIsUpTurnsTheVolumeWithoutMirroringIt) {
  Image image;
  image.layout = *lay_out({2, 3, 4}, {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, Vec3(0.0), {});
  image.kind = ImageKind::labels;
  image.value.assign(24, 1.0f);
  image.value[0] = 2.0f;  // at the origin
  ImageTissues what;
  what.labels = {{1, Tissue::bone}, {2, Tissue::pulp}};
  what.up = UpAxis::y;  // (x, y, z) becomes (x, -z, y)
  const auto v = made(image, what);
  ASSERT_TRUE(v);
  EXPECT_EQ(v->grid.size - 2 * kPadVoxels, IVec3(2, 4, 3));
  EXPECT_EQ(v->tissue[v->grid.index(IVec3(0, 3, 0) + kPadVoxels)], Tissue::pulp);
}

TEST(ImageVolume, ObliqueAxesAreReportedWhicheverIsUp) {
  const double turn = 0.3;
  Image image;
  image.layout = *lay_out({2, 3, 4}, {Vec3(std::cos(turn), std::sin(turn), 0), Vec3(-std::sin(turn), std::cos(turn), 0), Vec3(0, 0, 1)}, Vec3(0.0), {});
  image.kind = ImageKind::labels;
  image.value.assign(24, 1.0f);
  ImageTissues what;
  what.labels = {{1, Tissue::bone}};
  for (const UpAxis up : {UpAxis::z, UpAxis::y, UpAxis::minus_x}) {
    what.up = up;
    std::vector<ImportRemark> remarks;
    ASSERT_TRUE(made(image, what, &remarks));
    const auto straightened = std::ranges::find(remarks, RemarkCode::straightened, &ImportRemark::code);
    ASSERT_NE(straightened, remarks.end()) << kUpAxisKeys[static_cast<std::size_t>(up)];
    EXPECT_NEAR(straightened->numbers.at(0), turn * 180.0 / std::numbers::pi, 1e-9);
  }
}

TEST(ImageVolume, SidesThatAreNotKnownAreReportedWhicheverIsUp) {
  Image image = grey_ball({9, 9, 9}, Vec3(1.0), Vec3(4.0), 3.0);
  ImageTissues what;
  what.thresholds = {{0.0, Tissue::dentine}};
  for (const bool known : {true, false})
    for (const UpAxis up : {UpAxis::z, UpAxis::x}) {
      image.sides_known = known;
      what.up = up;
      std::vector<ImportRemark> remarks;
      ASSERT_TRUE(made(image, what, &remarks));
      EXPECT_EQ(std::ranges::count(remarks, RemarkCode::sides_assumed, &ImportRemark::code), known ? 0 : 1);
    }
}

TEST(ImageVolume, SmallComponentsAreRemovedAndHollowsAreFilled) {
  Grid g;
  g.size = {9, 9, 9};
  std::vector<Tissue> labels(g.voxels(), Tissue::empty);
  IVec3 v;
  for (v.z = 1; v.z < 6; ++v.z)
    for (v.y = 1; v.y < 6; ++v.y)
      for (v.x = 1; v.x < 6; ++v.x) labels[g.index(v)] = Tissue::dentine;
  labels[g.index({3, 3, 3})] = Tissue::empty;
  labels[g.index({8, 8, 8})] = Tissue::dentine;
  EXPECT_EQ(keep_largest_component(g, labels), 1u);
  EXPECT_EQ(labels[g.index({8, 8, 8})], Tissue::empty);
  EXPECT_EQ(fill_hollows(g, labels, Tissue::pulp), 1u);
  EXPECT_EQ(labels[g.index({3, 3, 3})], Tissue::pulp);
  labels[g.index({3, 3, 3})] = labels[g.index({3, 3, 4})] = labels[g.index({3, 3, 5})] = Tissue::empty;  // a way out
  EXPECT_EQ(fill_hollows(g, labels, Tissue::pulp), 0u);
}

TEST(ImageVolume, OptionsThatCannotBeAreRefusedByName) {
  const Image image = grey_ball({9, 9, 9}, Vec3(1.0), Vec3(4.0), 3.0);
  const auto code = [&](const ImageTissues& what) { const auto r = made(image, what); return r ? std::string("read") : std::string(key_of(r.error().code)) + " " + r.error().where; };
  ImageTissues what;
  EXPECT_EQ(code(what), "nothing_solid v");
  what.thresholds = {{0.0, Tissue::dentine}, {0.0, Tissue::enamel}};
  EXPECT_EQ(code(what), "bad_option threshold");
  what.thresholds = {{5000.0, Tissue::dentine}};
  EXPECT_EQ(code(what), "nothing_solid v");
  what.thresholds = {{0.0, Tissue::dentine}};
  EXPECT_EQ(code(what), "read");
  what.unit_mm = 0.0;
  EXPECT_EQ(code(what), "bad_option unit-mm");
  what.unit_mm = 1.0;
  what.voxel_mm = 0.006;  // 1508 voxels an edge, 3.4 thousand million in all
  EXPECT_EQ(code(what).substr(0, 9), "too_large");
  what.voxel_mm = 100.0;
  EXPECT_EQ(code(what), "bad_option voxel-mm");
  ImageTissues twice;
  twice.labels = {{3, Tissue::enamel}, {3, Tissue::dentine}};
  EXPECT_EQ(code(twice), "bad_option tissue 3");
}

/// A jaw of labels at 0.4 mm: two teeth of 8 x 8 x 20 mm that stand far apart, each with a pulp of its own.
Image jaw() {
  Image image;
  image.layout = *lay_out({160, 120, 60}, {Vec3(0.4, 0, 0), Vec3(0, 0.4, 0), Vec3(0, 0, 0.4)}, Vec3(-32.0, -24.0, -12.0), {});
  image.kind = ImageKind::labels;
  image.value.assign(160 * 120 * 60, 0.0f);
  const auto fill = [&](IVec3 low, IVec3 high, float value) {
    for (int z = low.z; z < high.z; ++z)
      for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x) image.value[static_cast<std::size_t>(x + 160 * (y + 120 * z))] = value;
  };
  fill({5, 5, 5}, {25, 25, 55}, 11.0f);
  fill({12, 12, 15}, {18, 18, 45}, 111.0f);
  fill({130, 90, 5}, {150, 110, 55}, 21.0f);
  return image;
}

TEST(ImageVolume, OneToothOfAJawIsMadeFinerThanTheWholeJawCouldBe) {
  const Image image = jaw();
  ImageTissues what;
  what.labels = {{11, Tissue::dentine}, {111, Tissue::pulp}};
  what.voxel_mm = 0.1;
  VolumeLimits limits;
  limits.max_voxels = 3'000'000;  // the jaw would take 74 million, the tooth 1.4 million
  std::vector<ImportRemark> remarks;
  const auto v = volume_of_image(image, what, "jaw", limits, remarks);
  ASSERT_TRUE(v) << key_of(v.error().code) << " " << v.error().detail;
  EXPECT_EQ(v->grid.size, IVec3(80 + 8, 80 + 8, 200 + 8));
  const SolidMeasure m = specimen_solid(*Specimen::build(*v, Reading::banded));
  EXPECT_NEAR(m.total_mm3(), 8.0 * 8.0 * 20.0, 0.005 * 1280.0);
  EXPECT_NEAR(m.mm3[index_of(Tissue::pulp)], 2.4 * 2.4 * 12.0, 0.01 * 69.0);
  // The same voxels in the same places as in the whole jaw.
  what.voxel_mm = 0.2;
  const auto tooth = volume_of_image(image, what, "jaw", {}, remarks);
  what.labels.emplace_back(21, Tissue::dentine);
  const auto both = volume_of_image(image, what, "jaw", {}, remarks);
  ASSERT_TRUE(tooth && both);
  const IVec3 shift(glm::round((tooth->grid.origin_mm - both->grid.origin_mm) / 0.2));
  EXPECT_LT(glm::length(both->grid.centre_mm(shift) - tooth->grid.origin_mm), 1e-9);
  std::size_t differs = 0;
  IVec3 at;
  std::size_t i = 0;
  for (at.z = 0; at.z < tooth->grid.size.z; ++at.z)
    for (at.y = 0; at.y < tooth->grid.size.y; ++at.y)
      for (at.x = 0; at.x < tooth->grid.size.x; ++at.x, ++i)
        differs += tooth->s[i] != both->s[both->grid.index(at + shift)] || tooth->tissue[i] != both->tissue[both->grid.index(at + shift)];
  EXPECT_EQ(differs, 0u);
}

TEST(ImageVolume, ARefusalForSizeGivesTheFiguresAndAVoxelThatFits) {
  const Image image = jaw();
  ImageTissues what;
  what.labels = {{11, Tissue::dentine}, {21, Tissue::dentine}};
  what.voxel_mm = 0.1;
  VolumeLimits limits;
  limits.max_voxels = 3'000'000;
  std::vector<ImportRemark> remarks;
  const auto refused = volume_of_image(image, what, "jaw", limits, remarks);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ImportError::too_large);
  const auto figures = limit_figures(refused.error().detail);
  ASSERT_TRUE(figures) << refused.error().detail;
  EXPECT_EQ(figures->kind, LimitKind::voxels);
  EXPECT_NEAR(figures->asked, 588.0 * 428.0 * 208.0, 0.1 * 588.0 * 428.0 * 208.0);  // both teeth and what lies between
  EXPECT_EQ(figures->allowed, 3e6);
  ASSERT_GT(figures->fits_mm, 0.1);
  what.voxel_mm = figures->fits_mm;
  EXPECT_TRUE(volume_of_image(image, what, "jaw", limits, remarks));
  what.voxel_mm = 0.8 * figures->fits_mm;
  EXPECT_FALSE(volume_of_image(image, what, "jaw", limits, remarks)) << "a far finer one would have fitted too";
  // Fewer labels are a way out.
  what.voxel_mm = 0.1;
  what.labels = {{21, Tissue::dentine}};
  EXPECT_TRUE(volume_of_image(image, what, "jaw", limits, remarks));
  // And so is the largest component alone.
  what.labels = {{11, Tissue::dentine}, {111, Tissue::pulp}, {21, Tissue::dentine}};
  EXPECT_FALSE(volume_of_image(image, what, "jaw", limits, remarks));
  what.largest_component = true;
  const auto component = volume_of_image(image, what, "jaw", limits, remarks);
  ASSERT_TRUE(component) << component.error().detail;
  EXPECT_EQ(component->grid.size, IVec3(88, 88, 208));
}

TEST(LimitFigures, GoThroughTextAndAreNotReadFromOtherText) {
  const LimitFigures f{LimitKind::edge, 4096.0, 2048.0, 0.21};
  EXPECT_EQ(limit_figures(text_of(f)), f);
  EXPECT_EQ(limit_figures(text_of(f) + "\nand what the process remarks"), f);
  for (const char* bad : {"", "limit", "limit edge 1 2", "limit edge 1 2 3 4", "limit nothing 1 2 3", "limit edge a 2 3", "12 gaps"})
    EXPECT_FALSE(limit_figures(bad)) << bad;
  const auto file = limit_figures(passed_file_limit({2000, 2000, 2000}, {}));
  ASSERT_TRUE(file);
  EXPECT_EQ(*file, (LimitFigures{LimitKind::file_voxels, 8e9, 512.0 * 512.0 * 512.0, 0.0}));
  EXPECT_EQ(passed_file_limit({512, 512, 512}, {}), "");
  // No voxel up to the coarsest fits a specimen of a hundred metres.
  EXPECT_EQ(passed_limit(Vec3(1e6), Vec3(1e5), 0.1, {})->fits_mm, 0.0);
}

TEST(ImageVolume, MetalAboveEnamelCanBeLeftOut) {
  EXPECT_EQ(tissue_at(500.0, {{0.0, Tissue::dentine}, {1000.0, Tissue::enamel}, {3000.0, Tissue::empty}}), Tissue::dentine);
  EXPECT_EQ(tissue_at(1000.0, {{0.0, Tissue::dentine}, {1000.0, Tissue::enamel}, {3000.0, Tissue::empty}}), Tissue::enamel);
  EXPECT_EQ(tissue_at(9000.0, {{0.0, Tissue::dentine}, {1000.0, Tissue::enamel}, {3000.0, Tissue::empty}}), Tissue::empty);
  EXPECT_EQ(tissue_at(-1.0, {{0.0, Tissue::dentine}}), Tissue::empty);
}

TEST(ImageVolume, TheSuggestedThresholdsPartThreeHeaps) {
  std::vector<float> values(3000, -1000.0f);
  values.insert(values.end(), 800, 1200.0f);
  values.insert(values.end(), 300, 2500.0f);
  const auto t = suggested_thresholds(values);
  EXPECT_NEAR(t[0], 100.0, 10.0);   // in the middle between the heaps, to a bin of 512
  EXPECT_NEAR(t[1], 1850.0, 10.0);
}

}  // namespace
}  // namespace cusp::test
