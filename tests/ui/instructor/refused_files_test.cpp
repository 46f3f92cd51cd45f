// Exercises that the library's page does not read from a file, and those that it saves although the checks refuse them.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "scenarios/blocks/blocks.h"
#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/instructor/library_files.h"
#include "ui/session/file_bytes.h"

namespace cusp::test {
namespace {

TEST_F(LibraryFiles, AFileWhoseTissueHasAGrownToothsCodeIsRefusedAsAnImportIs) {
  VoxelVolume block = dexterity_block(0.4);
  std::ranges::replace(block.tissue, Tissue::plastic, Tissue{29});
  block.names[29] = "pulp stone";
  ASSERT_TRUE(write_nrrd(block, folder / "block.nrrd"));
  ExerciseFile sent{from.changed(2.2), *bytes_of(folder / "block.nrrd")};
  sent.scenario.specimen = {};
  sent.scenario.specimen.volume = "block.nrrd";
  sent.scenario.specimen.voxel_mm = 0.4;
  ASSERT_TRUE(write_exercise_file(sent, path("stone.cusp").toStdString()));
  to.open_file(path("stone.cusp"));
  EXPECT_TRUE(to.message().contains(QStringLiteral("the tissue pulp stone has the code of a grown tooth"))) << to.message().toStdString();
  EXPECT_TRUE(to.drafts().empty());
  EXPECT_TRUE(to.opened.empty());
}

TEST_F(LibraryFiles, APublishedExerciseThatTheChecksRefuseByNowIsSavedAsItWasPublished) {
  Scenario published = from.changed(2.2);
  published.id = ScenarioId::make();
  published.key.clear();
  published.rubric.criteria.clear();
  ASSERT_TRUE(from.records.store().scenarios.publish(from.instructor.actor(), published, canonical_json(published), content_hash(published).bytes));
  from.show();
  from.choose(published.id);
  from.picked = path("ungraded.cusp");
  from.save_chosen();
  EXPECT_TRUE(from.message().contains(QStringLiteral("is saved as a file"))) << from.message().toStdString();
  EXPECT_TRUE(from.message().contains(QStringLiteral("Nothing is graded yet"))) << from.message().toStdString();
  EXPECT_FALSE(from.message().contains(QStringLiteral("Another station opens it"))) << from.message().toStdString();
  ASSERT_TRUE(std::filesystem::exists(folder / "ungraded.cusp"));
  EXPECT_EQ(read_text(folder / "ungraded.cusp"), *exercise_file_bytes({published, {}}));
  to.open_file(from.picked);
  EXPECT_TRUE(to.message().contains(QStringLiteral("Nothing is graded yet"))) << to.message().toStdString();
  EXPECT_TRUE(to.drafts().empty());
}

TEST_F(LibraryFiles, ADraftThatTheChecksRefuseIsNotSavedAsAFile) {
  Scenario draft = from.changed(2.2);
  draft.id = ScenarioId::make();
  draft.rubric.criteria.clear();
  ASSERT_TRUE(from.records.store().scenarios.save_draft(from.instructor.actor(), draft.id, canonical_json(draft), {}).has_value());
  from.show();
  from.choose(draft.id);
  from.picked = path("empty.cusp");
  from.save_chosen();
  EXPECT_TRUE(from.message().contains(QStringLiteral("Nothing is graded yet"))) << from.message().toStdString();
  EXPECT_FALSE(std::filesystem::exists(folder / "empty.cusp"));
  from.picked = path("no/such/folder/x.cusp");
  from.choose(load_builtin("channel-1")->id);
  from.save_chosen();
  EXPECT_TRUE(from.message().contains(QStringLiteral("Choose another folder"))) << from.message().toStdString();
}

TEST_F(LibraryFiles, WhatIsNoExerciseIsRefusedWithItsCauseAndChangesNothing) {
  write_text(folder / "notes.cusp", "not an exercise");
  const std::string good = *exercise_file_bytes({from.changed(2.2), {}});
  write_text(folder / "cut.cusp", good.substr(0, 3000));
  std::string wrong = good;
  wrong[wrong.find("\"depth_mm\":2.2") + 13] = '4';
  write_text(folder / "changed.cusp", wrong);
  const std::pair<const char*, const char*> cases[] = {{"none.cusp", "cannot be opened"},
                                                       {"notes.cusp", "not an exercise that Cusp saved"},
                                                       {"cut.cusp", "breaks off"},
                                                       {"changed.cusp", "damaged or changed"}};
  for (const auto& [name, cause] : cases) {
    to.open_file(path(name));
    EXPECT_TRUE(to.message().contains(QLatin1String(cause))) << name << ": " << to.message().toStdString();
  }
  EXPECT_TRUE(to.drafts().empty());
  EXPECT_TRUE(to.opened.empty());
}

}  // namespace
}  // namespace cusp::test
