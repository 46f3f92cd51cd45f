// A tooth from a file: what is measured by its landmarks, and what is not measurable without them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenarios/landmarks/landmarks.h"
#include "scenarios/landmarks/propose.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/teeth/tooth.h"
#include "scenarios/templates/templates.h"
#include "tests/engine/volume/carved.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

/// A box on the mesial side of 46, cut by analysis, on the generator's tooth and on the same voxels as a file's.
class Imported : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    tooth_ = new Tooth(grow_tooth({.fdi = 46, .seed = 3, .voxel_mm = 0.2}).value());
    specimen_ = Specimen::build(tooth_->volume, Reading::banded);
  }
  static void TearDownTestSuite() {
    delete tooth_;
    tooth_ = nullptr;
    specimen_.reset();
  }

  static Scenario exercise() {
    Scenario s;
    s.specimen.voxel_mm = 0.2;
    s.tissues = {{Tissue::enamel}, {Tissue::dentine}};
    s.target.kind = RegionKind::box;
    s.target.from_mm = from_mm();
    s.target.size_mm = {3.0, 3.0, 6.0};
    s.target.faces = {{"z_low", FaceName::gingival_floor}};
    for (const char* metric : {"gingival_above_cej", "wall_angle_buccal", "wall_angle_distal", "ridge_distal"}) s.rubric.criteria.push_back({metric, 1, {}});
    return s;
  }
  static Vec3 from_mm() {
    const Vec3 contact = tooth_->landmarks.mesial_contact;
    return {contact.x + 0.5, contact.y, contact.z + 2.0};
  }
  static Measure measured(const Scenario& s, const char* metric) {
    Volume volume(specimen_);
    const Vec3 middle = from_mm();
    engine::carved::carve(volume, [middle](Vec3 p) {
      const Vec3 off = glm::abs(p - middle) - Vec3(1.5, 1.5, 3.0);
      return std::max({off.x, off.y, off.z});
    });
    const auto all = measure(Reference(s, specimen_), volume, {});
    const auto one = std::ranges::find(all, metric, &Measure::metric);
    return one == all.end() ? Measure{} : *one;
  }
  static Scenario grown() {
    Scenario s = exercise();
    s.specimen.generator = "tooth";
    s.specimen.fdi = 46;
    s.specimen.seed = 3;
    return s;
  }
  static Scenario of_file(SpecimenLandmarks landmarks) {
    Scenario s = exercise();
    s.specimen.volume = "tooth.nrrd";
    s.specimen.landmarks = std::move(landmarks);
    return s;
  }
  static SpecimenLandmarks proposed() { return propose_landmarks(tooth_->volume, 46).value(); }

  inline static Tooth* tooth_ = nullptr;
  inline static std::shared_ptr<const Specimen> specimen_;
};

TEST_F(Imported, MeasuresByItsProposedLandmarksWhatAGrownToothDoes) {
  for (const char* metric : {"wall_angle_buccal", "wall_angle_distal"}) {
    const Measure own = measured(grown(), metric), file = measured(of_file(proposed()), metric);
    ASSERT_TRUE(own.measured && file.measured) << metric;
    EXPECT_EQ(own.value, file.value) << metric << ": the same voxels, the same sides";
  }
  const Measure own = measured(grown(), "gingival_above_cej"), file = measured(of_file(proposed()), "gingival_above_cej");
  ASSERT_TRUE(own.measured && file.measured);
  EXPECT_NEAR(file.value, own.value, file.uncertainty) << "the proposed CEJ's error is in the uncertainty";
  EXPECT_GT(file.uncertainty, own.uncertainty);
}

TEST_F(Imported, WithoutALandmarkWhatNeedsItIsNotMeasurable) {
  SpecimenLandmarks marks = proposed();
  std::erase_if(marks.marks, [](const Landmark& one) { return one.kind == MarkKind::cej; });
  EXPECT_FALSE(measured(of_file(marks), "gingival_above_cej").measured);
  EXPECT_TRUE(measured(of_file(marks), "wall_angle_buccal").measured);
  EXPECT_FALSE(measured(of_file({}), "gingival_above_cej").measured);
  EXPECT_FALSE(measured(of_file({}), "wall_angle_buccal").measured) << "nobody knows its sides";
}

TEST_F(Imported, ATurnedToothHasNoSides) {
  SpecimenLandmarks marks = proposed();
  for (Landmark& one : marks.marks)
    if (one.kind == MarkKind::mesial_axis) one.points_mm[1] = one.points_mm[0] + Vec3(-1, 0.5, 0);  // 27 degrees
  EXPECT_EQ(mesial_x_of(marks), 0);
  EXPECT_FALSE(measured(of_file(marks), "wall_angle_buccal").measured);
}

TEST_F(Imported, AToothHasSidesUpToTheTurnThatValidateNames) {
  SpecimenLandmarks marks = proposed();
  for (const double turn : {kMostTurnedDeg - 0.01, kMostTurnedDeg + 0.01})
    for (const double side : {-1.0, 1.0}) {
      for (Landmark& one : marks.marks)
        if (one.kind == MarkKind::mesial_axis) one.points_mm[1] = one.points_mm[0] + Vec3(-1.0, side * std::tan(turn * std::numbers::pi / 180.0), 0);
      EXPECT_NEAR(std::fabs(*turn_deg(marks)), turn, 1e-9);
      EXPECT_EQ(mesial_x_of(marks) != 0, turn < kMostTurnedDeg) << turn;
    }
}

TEST_F(Imported, WhatTheAuthorSetIsTakenAsKnown) {
  SpecimenLandmarks marks = proposed();
  for (Landmark& one : marks.marks) one.state = MarkState::set;
  EXPECT_EQ(measured(of_file(marks), "gingival_above_cej").uncertainty, measured(grown(), "gingival_above_cej").uncertainty);
}

ImportedTooth imported(SpecimenLandmarks landmarks) {
  return {"tooth.nrrd", 0.2, {Tissue::enamel, Tissue::dentine, Tissue::cementum, Tissue::pulp}, std::move(landmarks)};
}

TEST_F(Imported, ATemplateFitsItWhereItsLandmarksSuffice) {
  const auto own = fit_template({.key = "class-1-adhesive", .fdi = 46, .seed = 3});
  const auto file = fit_template({.key = "class-1-adhesive", .fdi = 46, .imported = imported(proposed())});
  ASSERT_TRUE(own && file) << (file ? "" : file.error().where);
  EXPECT_EQ(file->specimen.volume, "tooth.nrrd");
  EXPECT_EQ(file->specimen.landmarks.fdi, 46);
  EXPECT_NEAR(file->target.outline.top_mm, own->target.outline.top_mm, proposal_error(MarkKind::pit, 0.2)) << "from the lowest pit";
  EXPECT_EQ(file->target.outline.depth_mm, own->target.outline.depth_mm);
}

TEST_F(Imported, ATemplateStatesTheLeastVoxelSizeForAFilesThirtyTwoBitNumber) {
  ImportedTooth tooth = imported(proposed());
  tooth.voxel_mm = static_cast<double>(0.04f);  // 0.0399999991
  const auto fitted = fit_template({.key = "class-1-adhesive", .fdi = 46, .imported = tooth});
  ASSERT_TRUE(fitted) << fitted.error().where;
  EXPECT_EQ(fitted->specimen.voxel_mm, 0.04);
  tooth.voxel_mm = 0.0399;
  EXPECT_FALSE(fit_template({.key = "class-1-adhesive", .fdi = 46, .imported = tooth})) << "no exercise holds such voxels";
}

TEST_F(Imported, ATemplateNamesWhatIsMissing) {
  const auto failure = [](const char* key, const ImportedTooth& tooth) {
    const auto fitted = fit_template({.key = key, .fdi = 46, .imported = tooth});
    return fitted ? std::string("fits") : std::string(key_of(fitted.error().code)) + " " + fitted.error().where;
  };
  const auto without = [](MarkKind kind, const char* name) {
    SpecimenLandmarks marks = proposed();
    std::erase_if(marks.marks, [&](const Landmark& one) { return one.kind == kind && (*name == '\0' || one.name == name); });
    return imported(marks);
  };
  EXPECT_EQ(failure("class-1-adhesive", without(MarkKind::contact, "mesial")), "missing_landmark contact.mesial.x");
  EXPECT_EQ(failure("class-1-adhesive", without(MarkKind::pit, "")), "missing_landmark fossa.z");
  EXPECT_EQ(failure("class-1-adhesive", without(MarkKind::fissure, "")), "missing_landmark central*");
  EXPECT_EQ(failure("class-1-adhesive", without(MarkKind::mesial_axis, "")), "missing_landmark mesial_axis");
  EXPECT_EQ(failure("class-1-adhesive", without(MarkKind::cej, "")), "fits") << "it asks for none";
  EXPECT_EQ(failure("class-1-adhesive", imported({})), "missing_landmark mesial_axis");
  EXPECT_EQ(failure("class-2-adhesive", imported(proposed())), "missing_tissue neighbours");
  EXPECT_EQ(failure("caries-fissure", imported(proposed())), "missing_tissue carious_dentine");
  SpecimenLandmarks turned = proposed();
  for (Landmark& one : turned.marks)
    if (one.kind == MarkKind::mesial_axis) one.points_mm[1] = one.points_mm[0] + Vec3(0, 1, 0);
  EXPECT_EQ(failure("class-1-adhesive", imported(turned)), "turned_tooth 90");
}

TEST_F(Imported, ATemplateProtectsNoPulpThatAFileDoesNotHold) {
  ImportedTooth shell = imported(proposed());
  std::erase(shell.tissues, Tissue::pulp);
  const auto fitted = fit_template({.key = "class-1-adhesive", .fdi = 46, .imported = shell});
  ASSERT_TRUE(fitted);
  EXPECT_TRUE(fitted->protected_parts.empty());
  EXPECT_TRUE(fitted->rubric.critical.empty());
}

}  // namespace
}  // namespace cusp::test
