#include "scenarios/specimens/specimens.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "scenarios/blocks/blocks.h"
#include "scenarios/format/read.h"
#include "scenarios/format/validate.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/specimens/taken_codes.h"
#include "scenarios/teeth/own_tissues.h"
#include "tests/modules.h"
#include "tests/scenarios/import/mesh_files.h"
#include "tests/source_dir.h"

namespace cusp::test {
namespace {

using test::TempFolder;

SpecimenSource generator(const std::string& name, double voxel_mm = 0.1, int fdi = 0) {
  SpecimenSource source;
  source.generator = name;
  source.voxel_mm = voxel_mm;
  source.fdi = fdi;
  return source;
}

void expect_refused(const SpecimenSource& source, ImportError code, const std::string& where) {
  const TempFolder folder;
  const auto r = make_specimen(source, folder.path());
  ASSERT_FALSE(r);
  EXPECT_EQ(key_of(r.error().code), key_of(code));
  EXPECT_EQ(r.error().where, where);
}

TEST(MakeSpecimen, AToothAndTheRestOfItsJawCanBeCancelled) {
  const std::atomic<bool> stop{true};
  SpecimenSource tooth = generator("tooth", 0.1, 36);
  tooth.around = {"jaw"};
  const auto specimen = make_specimen(tooth, {}, &stop);
  ASSERT_FALSE(specimen);
  EXPECT_EQ(specimen.error().code, ImportError::cancelled);
  const auto scenery = make_scenery(tooth, &stop);
  ASSERT_FALSE(scenery);
  EXPECT_EQ(scenery.error().code, ImportError::cancelled);
}

TEST(MakeSpecimen, TheBlocksComeFromTheirGenerators) {
  const auto paper = make_specimen(generator("paper-block"), {});
  ASSERT_TRUE(paper);
  EXPECT_EQ(paper->grid, paper_block().grid);
  const auto block = make_specimen(generator("block", 0.25), {});
  ASSERT_TRUE(block);
  EXPECT_TRUE(block->s == dexterity_block(0.25).s);
}

TEST(MakeSpecimen, AToothComesFromItsGenerator) {
  const auto tooth = make_specimen(generator("tooth", 0.3, 36), {});
  ASSERT_TRUE(tooth) << key_of(tooth.error().code) << tooth.error().where;
  EXPECT_TRUE(std::ranges::find(tooth->tissue, Tissue::enamel) != tooth->tissue.end());
  EXPECT_TRUE(std::ranges::find(tooth->tissue, Tissue::pulp) != tooth->tissue.end());
}

TEST(TissuesOf, AreThoseThatTheGrownToothHolds) {
  SpecimenSource natural = generator("tooth", 0.25, 36);
  natural.around = {"neighbours", "gingiva", "bone"};
  natural.lesions = {{"fissure", "central", 0.9, 1.2, 0.6}, {"proximal", "mesial", 1.1, 1.0, 0.6}};
  SpecimenSource plastic = generator("tooth", 0.3, 14);
  plastic.typodont = true;
  plastic.around = {"neighbours"};
  for (const SpecimenSource& source : {natural, plastic}) {
    const auto grown = make_specimen(source, {});
    ASSERT_TRUE(grown);
    EXPECT_EQ(tissues_of(source), facts_of(*grown).tissues) << source.fdi;
  }
  EXPECT_TRUE(tissues_of(generator("block")).empty());
}

TEST(FullLowerJaw, IsAnExerciseThatDescribesEveryTissueThatItHolds) {
  std::ifstream file(source_dir() / "scenarios/library/class-1-36-jaw/scenario.json");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const auto scenario = read_scenario(text);
  ASSERT_TRUE(scenario) << scenario.error().where;
  EXPECT_EQ(scenario->specimen.around, (std::vector<std::string>{"neighbours", "gingiva", "bone", "jaw"}));
  std::vector<Tissue> described;
  for (const ScenarioTissue& t : scenario->tissues) described.push_back(t.tissue);
  std::ranges::sort(described);
  EXPECT_EQ(described, tissues_of(scenario->specimen));
  EXPECT_FALSE(has_error(validate_text(text)));
}

TEST(MakeSpecimen, AVolumeIsReadBesideTheScenario) {
  const TempFolder folder;
  const VoxelVolume block = dexterity_block(1.0);
  ASSERT_TRUE(write_nrrd(block, folder / "block.nrrd"));
  SpecimenSource source;
  source.volume = "block.nrrd";
  const auto read = make_specimen(source, folder.path());
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->s == block.s);
}

TEST(MakeSpecimen, AVolumeOutsideTheScenariosFolderIsNotRead) {
  for (const char* name : {"../block.nrrd", "/etc/passwd", "", "..", ".", "a/b.nrrd", "a\\b.nrrd"}) {
    SpecimenSource source;
    source.volume = name;
    expect_refused(source, ImportError::bad_option, "volume");
  }
  SpecimenSource source;
  source.volume = "none.nrrd";
  expect_refused(source, ImportError::missing_file, "none.nrrd");
}

TEST(TakenCodes, AreRefusedUnlessTheyMeanWhatAGrownToothMeansByThem) {
  VoxelVolume volume = dexterity_block(1.0);
  EXPECT_FALSE(refuse_taken_codes(volume, "block.nrrd"));
  std::ranges::replace(volume.tissue, Tissue::plastic, Tissue{28});
  volume.names[28] = "pulp stone";
  EXPECT_FALSE(refuse_taken_codes(volume, "block.nrrd"));
  for (const auto& [code, grown] : own_tissue_names()) {
    SCOPED_TRACE(grown);
    volume.names.clear();
    for (Tissue& tissue : volume.tissue)
      if (tissue != Tissue::empty) tissue = Tissue{code};
    ASSERT_TRUE(refuse_taken_codes(volume, "block.nrrd")) << "a label without a name";
    EXPECT_EQ(refuse_taken_codes(volume, "block.nrrd")->detail, std::to_string(code));
    volume.names[code] = "pulp stone";
    const auto refused = refuse_taken_codes(volume, "block.nrrd");
    ASSERT_TRUE(refused);
    EXPECT_EQ(key_of(refused->code), "code_taken");
    EXPECT_EQ(refused->where, "block.nrrd");
    EXPECT_EQ(refused->detail, "pulp stone");
    volume.names[code] = grown;
    EXPECT_FALSE(refuse_taken_codes(volume, "block.nrrd")) << "as Cusp writes them";
  }
}

TEST(MakeSpecimen, WhatNoGeneratorMakesIsRefusedByKey) {
  expect_refused(generator("cube"), ImportError::unknown_generator, "cube");
  expect_refused(generator("block", 0.001), ImportError::bad_option, "voxel_mm");
  expect_refused(generator("block", std::nan("")), ImportError::bad_option, "voxel_mm");
  expect_refused(generator("tooth", 0.1, 19), ImportError::bad_option, "fdi");
  expect_refused(generator("tooth", 3.0, 36), ImportError::bad_option, "voxel_mm");
}

}  // namespace
}  // namespace cusp::test
