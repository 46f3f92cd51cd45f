// The volume beside a draft: it stays while a window needs it, and is whole or not there.
#include <gtest/gtest.h>

#include <QPushButton>
#include <QSignalSpy>
#include <filesystem>

#include "scenarios/blocks/blocks.h"
#include "scenarios/import/left_parts.h"
#include "scenarios/import/nrrd.h"
#include "tests/file_limit.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/editor/editor_pages.h"
#include "tests/ui/publish_draft.h"
#include "ui/editor/free_name.h"
#include "ui/editor/specimen_grower.h"
#include "ui/instructor/import_page.h"
#include "ui/instructor/library_page.h"
#include "ui/session/file_bytes.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kRoomBytes = 1000;  // less than the volume has

struct DraftVolumes : EditorPages {
  EditorStart start;
  fs::path volume;

  void SetUp() override {
    EditorPages::SetUp();
    ports.ask = [](QWidget*, const Question&, const std::function<void(bool)>& then) { then(true); };
    const auto made = exercise_on(dexterity_block(0.4), "Found tooth", records.file());
    ASSERT_TRUE(made);
    start = *made;
    volume = fs::path(start.folder) / start.draft.specimen.volume;
  }
  std::size_t drafts() { return records.store().scenarios.drafts(instructor.actor())->size(); }
};

/// Discards the draft of the exercise as another program does that has the library open.
void discard_elsewhere(const DeskRecords& records, const Account& instructor, const Ports& ports, ScenarioId id) {
  auto store = Store::open(records.file());
  ASSERT_TRUE(store);
  LibraryPage library(**store, instructor.actor(), ports, records.file(), records.file().parent_path());
  library.show();
  for (int i = 0; i < library.model().rowCount(); ++i)
    if (library.model().row(i).draft && library.model().row(i).draft->id == id) library.table()->choose_row(i);
  library.discard_draft();
}

TEST_F(DraftVolumes, stay_with_the_window_that_edits_a_draft_which_another_one_discards) {
  const auto window = open(start);
  ASSERT_TRUE(window->keep_before_closing());
  ASSERT_EQ(drafts(), 1u);
  discard_elsewhere(records, instructor, ports, start.draft.id);
  EXPECT_EQ(drafts(), 0u);
  ASSERT_TRUE(fs::exists(volume)) << "the window edits it";
  ASSERT_TRUE(window->model().set_width_mm(1.9));
  ASSERT_TRUE(window->keep_before_closing());
  const auto kept = records.store().scenarios.drafts(instructor.actor());
  ASSERT_EQ(kept->size(), 1u);
  EXPECT_EQ(*bytes_of(drafts_folder(records.file(), kept->front().scenario) / start.draft.specimen.volume), *bytes_of(volume));
}

TEST_F(DraftVolumes, that_are_chosen_in_the_editor_stay_with_the_window_too) {
  EditorStart grown = coarse();
  grown.published.reset();
  grown.draft.id = ScenarioId::make();
  grown.draft.key.clear();
  const fs::path beside = drafts_folder(records.file(), grown.draft.id);
  grown.folder = beside.string();
  const auto window = open(grown);
  ASSERT_FALSE(fs::exists(beside));
  const VoxelVolume chosen = dexterity_block(0.4);
  fs::create_directories(beside);
  ASSERT_TRUE(write_nrrd(chosen, beside / "tooth.nrrd"));
  SpecimenSource source;
  source.volume = "tooth.nrrd";
  source.voxel_mm = chosen.grid.voxel_mm;
  ASSERT_TRUE(window->model().set_specimen(source, usual_tissues(facts_of(chosen).tissues)));
  ASSERT_TRUE(window->keep_before_closing());
  ASSERT_EQ(drafts(), 1u);
  discard_elsewhere(records, instructor, ports, grown.draft.id);
  EXPECT_EQ(drafts(), 0u);
  EXPECT_TRUE(fs::exists(beside / "tooth.nrrd")) << "the window edits it";
}

TEST_F(DraftVolumes, of_one_name_that_two_windows_write_at_once_lie_side_by_side) {
  using Bytes = std::vector<std::byte>;
  const Bytes first(3, std::byte{1}), second(5, std::byte{2});
  std::string of_the_other;
  const auto of_one = write_under_free_name(start.folder, "tooth.nrrd", {nullptr, [&](const fs::path& file) {
    // The other window writes meanwhile, and is done first.
    of_the_other = write_under_free_name(start.folder, "tooth.nrrd", {nullptr, [&](const fs::path& beside) { return write_beside(beside, second); }}).value();
    return write_beside(file, first);
  }});
  ASSERT_TRUE(of_one);
  EXPECT_EQ(*of_one, "tooth-2.nrrd");
  EXPECT_EQ(of_the_other, "tooth.nrrd");
  EXPECT_EQ(*bytes_of(fs::path(start.folder) / *of_one), first);
  EXPECT_EQ(*bytes_of(fs::path(start.folder) / of_the_other), second);
}

TEST_F(DraftVolumes, of_a_window_that_is_killed_while_it_writes_have_taken_no_name) {
  const auto files = [&] { return std::distance(fs::directory_iterator(start.folder), {}); };
  const auto before = files();
  const std::vector<std::byte> bytes(3, std::byte{1});
  const auto name = write_under_free_name(start.folder, "tooth.nrrd", {nullptr, [&](const fs::path& file) {
    EXPECT_FALSE(fs::exists(fs::path(start.folder) / "tooth.nrrd"));
    const auto written = write_beside(file, bytes);
    EXPECT_NE(file.filename().string().find(kPartMark), std::string::npos) << "what is left of it goes a day later";
    EXPECT_FALSE(fs::exists(fs::path(start.folder) / "tooth.nrrd"));
    return written;
  }});
  ASSERT_TRUE(name);
  EXPECT_EQ(*name, "tooth.nrrd");
  EXPECT_EQ(*bytes_of(fs::path(start.folder) / *name), bytes);
  EXPECT_EQ(files(), before + 1) << "the part is left";
}

TEST_F(DraftVolumes, that_another_window_has_written_meanwhile_are_not_written_twice) {
  const auto files = [&] { return std::distance(fs::directory_iterator(start.folder), {}); };
  const auto before = files();
  const std::vector<std::byte> bytes(3, std::byte{1});
  const auto is_it = [&](const fs::path& there) { return *bytes_of(there) == bytes; };
  const auto name = write_under_free_name(start.folder, "tooth.nrrd", {is_it, [&](const fs::path& file) {
    EXPECT_TRUE(write_beside(fs::path(start.folder) / "tooth.nrrd", bytes));
    return write_beside(file, bytes);
  }});
  ASSERT_TRUE(name);
  EXPECT_EQ(*name, "tooth.nrrd");
  EXPECT_EQ(files(), before + 1);
}

TEST_F(DraftVolumes, whose_source_cannot_be_read_name_the_source) {
  const auto name = write_under_free_name(start.folder, "tooth.nrrd", {nullptr, [](const fs::path&) -> Stored<void> {
    return std::unexpected(StorageFailure{StorageError::io, "cache/tooth.nrrd", {}});
  }});
  ASSERT_FALSE(name);
  EXPECT_EQ(name.error().where, "cache/tooth.nrrd");
}

TEST_F(DraftVolumes, that_cannot_be_written_leave_their_name_to_the_next_one) {
  const auto name = write_under_free_name(start.folder, "tooth.nrrd", {nullptr, [](const fs::path& file) -> Stored<void> {
    return std::unexpected(StorageFailure{StorageError::disk_full, file.string(), {}});
  }});
  ASSERT_FALSE(name);
  EXPECT_EQ(name.error().code, StorageError::disk_full);
  EXPECT_EQ(fs::path(name.error().where).filename(), "tooth.nrrd");
  EXPECT_FALSE(fs::exists(fs::path(start.folder) / "tooth.nrrd"));
}

TEST_F(DraftVolumes, go_with_a_draft_that_was_never_published_once_no_window_edits_it) {
  auto window = open(start);
  ASSERT_TRUE(window->keep_before_closing());
  window.reset();
  discard_elsewhere(records, instructor, ports, start.draft.id);
  EXPECT_EQ(drafts(), 0u);
  EXPECT_FALSE(fs::exists(start.folder));
}

TEST_F(DraftVolumes, that_the_disk_does_not_give_are_reported_and_nothing_is_published) {
  EditorModel model(start);
  model.set_facts(facts_of(dexterity_block(0.4)));
  ASSERT_TRUE(model.publishable());
  fs::remove(volume);
  fs::create_directory(volume);  // opens as a file does; each read of it fails
  EXPECT_EQ(bytes_of(volume).error().code, StorageError::io);
  std::optional<std::string> kept;
  EXPECT_EQ(publish_draft(records.store(), instructor.actor(), model, kept).error().code, StorageError::io);
  EXPECT_TRUE(records.store().scenarios.library()->empty());
}

TEST_F(DraftVolumes, that_the_disk_takes_half_of_into_a_copy_leave_nothing_behind) {
  const EditorModel model(start);
  ASSERT_GT(fs::file_size(volume), kRoomBytes);
  const auto copy = [&] { return keep_as_copy(records.store(), instructor.actor(), model, {{"en", "Mine"}}); };
  const auto refused = with_files_up_to(kRoomBytes, copy);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, StorageError::file_too_large);
  EXPECT_EQ(fs::path(refused.error().where).filename(), volume.filename()) << "not the records, which come after it";
  const fs::path all = fs::path(start.folder).parent_path();
  EXPECT_EQ(std::distance(fs::directory_iterator(all), {}), 1) << "the folder of a copy is left";
  EXPECT_EQ(drafts(), 0u);
  const auto made = copy();
  ASSERT_TRUE(made);
  EXPECT_EQ(*bytes_of(fs::path(made->folder) / volume.filename()), *bytes_of(volume));
}

TEST_F(DraftVolumes, that_the_disk_takes_half_of_beside_a_draft_keep_their_name_for_the_next_time) {
  EditorModel model(start);
  model.set_facts(facts_of(dexterity_block(0.4)));
  std::optional<std::string> kept;
  ASSERT_TRUE(publish_draft(records.store(), instructor.actor(), model, kept));
  const auto whole = *bytes_of(volume);
  ASSERT_GT(whole.size(), kRoomBytes);
  const auto list = load_exercises(records.store());
  ASSERT_TRUE(list);
  const Exercise* published = list->find(start.draft.id);
  ASSERT_NE(published, nullptr);
  const fs::path cache = folder.path().toStdString();
  ASSERT_TRUE(exercise_folder(records.store(), *published, cache)) << "it lies in the cache: the limit is for the copy alone";
  fs::remove_all(start.folder);
  const auto open_it = [&] { return open_for_editing(records.store(), instructor.actor(), *published, records.file(), cache); };
  const auto refused = with_files_up_to(kRoomBytes, open_it);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, StorageError::file_too_large);
  EXPECT_TRUE(fs::is_empty(start.folder)) << "a half volume is left";
  const auto opened = open_it();
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->draft.specimen.volume, start.draft.specimen.volume);
  EXPECT_EQ(*bytes_of(volume), whole);
}

}  // namespace
}  // namespace cusp::test
