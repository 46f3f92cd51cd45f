// The editor's records: drafts, publishing, versions that never change, volumes beside a draft.

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <filesystem>

#include "scenarios/blocks/blocks.h"
#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/publish_draft.h"
#include "ui/editor/editor_records.h"
#include "ui/instructor/import_page.h"
#include "ui/instructor/library_model.h"
#include "ui/student/exercise_groups.h"

namespace cusp::test {
namespace {

struct EditorRecords : ::testing::Test {
  test::DeskRecords records;
  QTemporaryDir cache;
  Account instructor;
  std::optional<std::string> kept_json;  // of the one window that a test is about
  void SetUp() override {
    const auto made = records.store().accounts.create(records.administrator().actor(),
                                                    {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
    ASSERT_TRUE(made.has_value());
    instructor = *made;
  }
  std::filesystem::path cache_folder() const { return cache.path().toStdString(); }
  Exercise exercise(const std::string& key) {
    const auto list = load_exercises(records.store());
    for (const Exercise& e : list->exercises) {
      if (e.scenario.key == key) return e;
    }
    return {};
  }
  EditorStart open(const Exercise& e) {
    return *open_for_editing(records.store(), instructor.actor(), e, records.file(), cache_folder());
  }
};

/// The block of channel-1: 20 x 20 x 10 mm below z = 0 (scenarios/blocks).
SpecimenFacts facts_of_block() { return {{-10, -10, -10}, {10, 10, 0}, 0.1, {Tissue::plastic}}; }

TEST_F(EditorRecords, a_changed_builtin_is_published_as_its_next_version_and_opens_equal) {
  EditorModel model(open(exercise("channel-1")));
  EXPECT_TRUE(model.unchanged());
  ASSERT_TRUE(model.set_depth_mm(2.4));
  model.set_facts(facts_of_block());
  const Scenario draft = model.scenario();
  const int builtin = load_builtin("channel-1")->version;
  const auto version = publish_draft(records.store(), instructor.actor(), model, kept_json);
  ASSERT_TRUE(version.has_value());
  EXPECT_EQ(version->number, builtin + 1);
  EXPECT_EQ(version->author, instructor.id);
  EXPECT_TRUE(model.unchanged());
  EXPECT_FALSE(model.stack().canUndo());
  const auto versions = records.store().scenarios.versions(draft.id);
  ASSERT_EQ(versions->size(), 2u);
  EXPECT_TRUE(*read_scenario(versions->front().json) == *load_builtin("channel-1"));  // the first stays what it was

  const Exercise reopened = exercise("channel-1");
  EXPECT_TRUE(reopened.scenario == draft);
  EditorModel again(open(reopened));
  EXPECT_TRUE(again.unchanged());
  EXPECT_EQ(again.scenario().version, builtin + 2);
}

TEST_F(EditorRecords, publishing_is_refused_while_a_check_fails_or_nothing_changed) {
  EditorModel model(open(exercise("channel-1")));
  model.set_facts(facts_of_block());
  EXPECT_EQ(publish_draft(records.store(), instructor.actor(), model, kept_json).error().code, StorageError::bad_value);
  ASSERT_TRUE(model.set_top_mm(5));  // floor 3 mm above the block
  const Scenario before = model.scenario();
  EXPECT_EQ(publish_draft(records.store(), instructor.actor(), model, kept_json).error().code, StorageError::bad_value);
  EXPECT_TRUE(model.scenario() == before);
  EXPECT_TRUE(records.store().scenarios.library()->empty());
}

TEST_F(EditorRecords, a_student_may_not_publish_and_nothing_is_kept) {
  const Account lena = records.student("1", "Lena Brandt");
  EditorModel model(open(exercise("channel-1")));
  model.set_depth_mm(2.4);
  model.set_facts(facts_of_block());
  EXPECT_EQ(publish_draft(records.store(), lena.actor(), model, kept_json).error().code, StorageError::not_allowed);
  EXPECT_EQ(keep_draft(records.store(), lena.actor(), model, kept_json).error().code, StorageError::not_allowed);
  EXPECT_TRUE(records.store().scenarios.library()->empty());
}

TEST_F(EditorRecords, a_draft_is_found_again_and_goes_when_everything_is_undone) {
  EditorModel model(open(exercise("channel-1")));
  ASSERT_TRUE(model.set_width_mm(1.9));
  ASSERT_TRUE(keep_draft(records.store(), instructor.actor(), model, kept_json).has_value());
  const auto library = load_library(records.store(), instructor.actor());
  ASSERT_TRUE(library.has_value());
  int drafts = 0;
  for (const LibraryRow& row : library->rows) drafts += row.draft.has_value();
  EXPECT_EQ(drafts, 1);
  EXPECT_TRUE(library->rows.front().draft) << "what the instructor works at comes first";
  EditorModel again(open(exercise("channel-1")));
  EXPECT_TRUE(again.scenario() == model.scenario());
  EXPECT_FALSE(again.unchanged());
  model.stack().undo();
  ASSERT_TRUE(keep_draft(records.store(), instructor.actor(), model, kept_json).has_value());
  EXPECT_TRUE(records.store().scenarios.drafts(instructor.actor())->empty());
}

TEST_F(EditorRecords, a_draft_that_cannot_be_read_is_neither_dropped_nor_replaced) {
  const Exercise e = exercise("channel-1");
  const std::string later = R"({"format": 99})";  // of a newer program
  ASSERT_TRUE(records.store().scenarios.save_draft(instructor.actor(), e.scenario.id, later, std::nullopt).has_value());
  const EditorStart start = open(e);
  EditorModel model(start);
  kept_json = start.kept;
  EXPECT_EQ(keep_draft(records.store(), instructor.actor(), model, kept_json).value(), DraftSave::kept) << "there is nothing to save";
  ASSERT_TRUE(model.set_width_mm(1.9));
  EXPECT_EQ(keep_draft(records.store(), instructor.actor(), model, kept_json).value(), DraftSave::changed_elsewhere);
  const auto draft = records.store().scenarios.draft(instructor.actor(), e.scenario.id);
  ASSERT_TRUE(draft.has_value() && draft->has_value());
  EXPECT_EQ((*draft)->json, later);
}

TEST_F(EditorRecords, the_library_lists_teeth_in_the_students_groups_before_blocks) {
  const auto library = load_library(records.store(), instructor.actor());
  ASSERT_TRUE(library.has_value());
  std::vector<ExerciseGroup> groups;
  for (const LibraryRow& row : library->rows) groups.push_back(group_of(row.shown()));
  EXPECT_EQ(groups.front(), ExerciseGroup::class_1);
  EXPECT_EQ(groups.back(), ExerciseGroup::block);
  EXPECT_TRUE(std::ranges::is_sorted(groups));
}

TEST_F(EditorRecords, a_copy_has_an_identity_of_its_own_and_begins_at_version_one) {
  const Exercise pattern = exercise("class-1-36");
  const auto start = copy_exercise(records.store(), pattern, {{"en", "Mine"}}, records.file(), cache_folder());
  ASSERT_TRUE(start.has_value());
  EXPECT_NE(start->draft.id, pattern.scenario.id);
  EXPECT_TRUE(start->draft.key.empty());
  EXPECT_EQ(start->draft.version, 1);
  EditorModel model(*start);
  EXPECT_FALSE(model.unchanged());  // nothing is published yet
}

TEST_F(EditorRecords, an_exercise_on_an_imported_volume_is_published_with_its_volume) {
  SpecimenSource block;
  block.generator = "block";
  block.voxel_mm = 0.4;  // coarse: the test is of the file
  const auto volume = make_specimen(block, {});
  ASSERT_TRUE(volume.has_value());
  const auto start = exercise_on(*volume, "Found tooth", records.file());
  ASSERT_TRUE(start.has_value());
  EditorModel model(*start);
  const auto back = make_specimen(model.scenario().specimen, model.folder());
  ASSERT_TRUE(back.has_value());
  model.set_facts(facts_of(*back));
  ASSERT_TRUE(model.publishable()) << (model.findings().empty() ? "" : model.findings().front().code);
  EXPECT_EQ(model.scenario().briefing, load_builtin("channel-1")->briefing) << "it is as deep as the pattern";
  const auto version = publish_draft(records.store(), instructor.actor(), model, kept_json);
  ASSERT_TRUE(version.has_value());
  EXPECT_EQ(version->number, 1);
  ASSERT_EQ(version->files.size(), 1u);
  const auto list = load_exercises(records.store());
  const Exercise* kept = list->find(model.scenario().id);
  ASSERT_NE(kept, nullptr);
  const auto folder = exercise_folder(records.store(), *kept, cache_folder());
  ASSERT_TRUE(folder.has_value());
  const auto unpacked = make_specimen(kept->scenario.specimen, *folder);
  ASSERT_TRUE(unpacked.has_value());
  EXPECT_EQ(unpacked->s, volume->s);
  EXPECT_EQ(unpacked->tissue, volume->tissue);
}

TEST_F(EditorRecords, an_exercise_on_a_thin_volume_is_as_deep_as_it_allows_with_bands_that_fit) {
  VoxelVolume plate(Grid{IVec3(50, 50, 23), 0.2, Vec3(-4.9, -4.9, -2.1)});  // 8.4 × 8.4 × 3 mm
  for (int z = 4; z < 19; ++z)
    for (int y = 4; y < 46; ++y)
      for (int x = 4; x < 46; ++x) {
        plate.s[plate.grid.index({x, y, z})] = kSolid;
        plate.tissue[plate.grid.index({x, y, z})] = Tissue::plastic;
      }
  const auto start = exercise_on(plate, "Plate", records.file());
  ASSERT_TRUE(start.has_value());
  const Scenario &made = start->draft, pattern = *load_builtin("channel-1");
  EXPECT_DOUBLE_EQ(made.target.outline.depth_mm, 1.0) << "a third of its height";
  EXPECT_NE(made.briefing.at("en").find("to its floor, 1.0 mm deep"), std::string::npos) << made.briefing.at("en");
  EXPECT_NE(made.briefing.at("de").find("bis zu ihrem Boden, 1,0 mm tief"), std::string::npos) << made.briefing.at("de");
  EXPECT_EQ(made.title, (LocalText{{"de", "Plate"}, {"en", "Plate"}})) << "a title for each briefing";
  for (std::size_t i = 0; i < made.rubric.criteria.size(); ++i) {
    const Criterion &here = made.rubric.criteria[i], &there = pattern.rubric.criteria[i];
    SCOPED_TRACE(here.metric);
    if (here.metric.starts_with("depth_")) EXPECT_NEAR(here.bands.ideal_hi, there.bands.ideal_hi - 1.0, 1e-9);
    // A channel of 2.8 mm has 0.56 of the floor of one of 6 mm, and, half as deep, 0.31 of its wall.
    if (here.metric.starts_with("overcut_")) EXPECT_NEAR(here.bands.fail_hi, (here.metric.ends_with("_floor") ? 0.56 : 0.31) * there.bands.fail_hi, 0.2);
  }
  EditorModel model(*start);
  model.set_facts(facts_of(plate));
  EXPECT_TRUE(model.publishable());
  for (const Finding& f : model.findings()) EXPECT_TRUE(f.code != "target_scores_less" && f.code != "text_figure") << f.path << " " << f.code;
}

TEST_F(EditorRecords, a_published_volume_is_opened_though_another_of_its_name_lies_beside_a_draft) {
  SpecimenSource block;
  block.generator = "block";
  block.voxel_mm = 0.4;
  const auto volume = make_specimen(block, {});
  block.voxel_mm = 0.5;
  const auto drafted = make_specimen(block, {});
  EditorModel model(*exercise_on(*volume, "Found tooth", records.file()));
  model.set_facts(facts_of(*volume));
  ASSERT_TRUE(publish_draft(records.store(), instructor.actor(), model, kept_json).has_value());
  const std::filesystem::path beside = std::filesystem::path(model.folder()) / model.scenario().specimen.volume;
  ASSERT_TRUE(write_nrrd(*drafted, beside));  // a draft here; the version came from another station
  const auto list = load_exercises(records.store());
  for (int i = 0; i < 2; ++i) {
    const EditorStart start = open(*list->find(model.scenario().id));
    const auto opened = make_specimen(start.draft.specimen, start.folder);
    ASSERT_TRUE(opened.has_value());
    EXPECT_EQ(opened->s, volume->s);
    EXPECT_TRUE(EditorModel(start).unchanged());
  }
  EXPECT_EQ(read_nrrd(beside)->s, drafted->s) << "the draft keeps its own";
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(beside.parent_path()), {}), 2);
}

TEST_F(EditorRecords, a_draft_in_which_everything_is_undone_stays_if_the_version_is_withdrawn_by_now) {
  SpecimenSource block;
  block.generator = "block";
  block.voxel_mm = 0.4;
  const auto volume = make_specimen(block, {});
  EditorModel first(*exercise_on(*volume, "Found tooth", records.file()));
  first.set_facts(facts_of(*volume));
  const auto version = publish_draft(records.store(), instructor.actor(), first, kept_json);
  ASSERT_TRUE(version.has_value());
  const auto list = load_exercises(records.store());
  EditorModel model(open(*list->find(first.scenario().id)));
  ASSERT_TRUE(model.set_width_mm(1.9));
  ASSERT_FALSE(model.unchanged());
  ASSERT_EQ(keep_draft(records.store(), instructor.actor(), model, kept_json), DraftSave::kept);
  ASSERT_TRUE(records.store().scenarios.withdraw(instructor.actor(), version->id));
  model.stack().undo();
  ASSERT_TRUE(model.unchanged());
  EXPECT_EQ(keep_draft(records.store(), instructor.actor(), model, kept_json), DraftSave::kept);
  const auto drafts = records.store().scenarios.drafts(instructor.actor());
  ASSERT_EQ(drafts->size(), 1u) << "else no list would have the exercise";
  EXPECT_TRUE(*read_scenario(drafts->front().json) == model.scenario());
}

TEST_F(EditorRecords, a_missing_volume_is_reported_and_nothing_is_published) {
  SpecimenSource block;
  block.generator = "block";
  block.voxel_mm = 0.4;
  const auto volume = make_specimen(block, {});
  const auto start = exercise_on(*volume, "Found tooth", records.file());
  EditorModel model(*start);
  model.set_facts(facts_of(*volume));
  std::filesystem::remove(std::filesystem::path(model.folder()) / model.scenario().specimen.volume);
  EXPECT_EQ(publish_draft(records.store(), instructor.actor(), model, kept_json).error().code, StorageError::not_found);
  EXPECT_TRUE(records.store().scenarios.library()->empty());
}

}  // namespace
}  // namespace cusp::test
