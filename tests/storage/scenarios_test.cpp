#include <gtest/gtest.h>

#include "tests/storage/sample.h"

namespace cusp::test {
namespace {


class ScenariosTest : public ::testing::Test {
 protected:
  Folder folder;
  std::unique_ptr<Store> store = open(folder / "a.db");
  Scenarios& scenarios = store->scenarios;
  Actor instructor = make_instructor(*store).actor();
};

TEST_F(ScenariosTest, a_scenario_from_the_library_is_kept_once) {
  const auto first = keep(*store);
  EXPECT_EQ(keep(*store).id, first.id);
  EXPECT_EQ(first.number, 1);
  EXPECT_EQ(first.key, "channel-1");
  EXPECT_EQ(first.title, small_scenario().title);
  EXPECT_EQ(first.json, "{\"id\":1}");
  EXPECT_TRUE(first.author.is_nil());
}

TEST_F(ScenariosTest, a_file_that_changed_under_the_same_number_becomes_the_next_version) {
  keep(*store);
  const auto changed = keep(*store, small_scenario(), "{\"id\":2}");
  EXPECT_EQ(changed.number, 2);
  EXPECT_EQ(must(scenarios.versions(small_scenario().id)).size(), 2u);
  EXPECT_EQ(must(scenarios.library()).size(), 1u);
  EXPECT_EQ(must(scenarios.library())[0].id, changed.id);
}

TEST_F(ScenariosTest, publishing_makes_the_next_version_and_drops_the_draft) {
  const auto first = keep(*store);
  must(scenarios.save_draft(instructor, first.scenario, "{\"draft\":1}", {}));
  must(scenarios.save_draft(instructor, first.scenario, "{\"draft\":2}", "{\"draft\":1}"));
  EXPECT_EQ(must(scenarios.draft(instructor, first.scenario))->json, "{\"draft\":2}");
  EXPECT_EQ(must(scenarios.drafts(instructor)).size(), 1u);
  EXPECT_TRUE(must(scenarios.has_draft(first.scenario)));
  const auto second =
      must(scenarios.publish(instructor, small_scenario(), "{\"id\":3}", blake2b_256(std::string_view{"3"}), {}, "{\"draft\":2}"));
  EXPECT_EQ(second.number, 2);
  EXPECT_EQ(second.author, instructor.id);
  EXPECT_FALSE(must(scenarios.draft(instructor, first.scenario)));
  EXPECT_FALSE(must(scenarios.has_draft(first.scenario)));
  EXPECT_EQ(code_of(scenarios.publish(instructor, small_scenario(), "{\"id\":3}", blake2b_256(std::string_view{"3"}))),
            StorageError::duplicate);
  EXPECT_EQ(must(scenarios.version(first.id)).json, "{\"id\":1}");
}

TEST_F(ScenariosTest, of_two_stores_on_one_draft_the_second_is_refused_and_nothing_is_lost) {
  const auto first = keep(*store);
  const auto other = open(folder / "a.db");
  Scenarios& theirs = other->scenarios;
  const std::string zero = "{\"draft\":0}", mine = "{\"draft\":1}", their = "{\"draft\":2}";
  EXPECT_EQ(must(scenarios.save_draft(instructor, first.scenario, zero, {})), DraftSave::kept);
  EXPECT_EQ(must(theirs.save_draft(instructor, first.scenario, their, zero)), DraftSave::kept);
  EXPECT_EQ(must(scenarios.save_draft(instructor, first.scenario, mine, zero)), DraftSave::changed_elsewhere);
  EXPECT_EQ(must(scenarios.save_draft(instructor, first.scenario, mine, {})), DraftSave::changed_elsewhere);
  EXPECT_EQ(must(scenarios.drop_draft(instructor, first.scenario, zero)), DraftSave::changed_elsewhere);
  EXPECT_EQ(must(scenarios.draft(instructor, first.scenario))->json, their);
  // Publishing leaves alone what it did not come from.
  must(scenarios.publish(instructor, small_scenario(), "{\"id\":3}", blake2b_256(std::string_view{"3"}), {}, zero));
  EXPECT_EQ(must(scenarios.draft(instructor, first.scenario))->json, their);
  EXPECT_EQ(must(scenarios.save_draft(instructor, first.scenario, their, zero)), DraftSave::kept) << "both came to the same";
  EXPECT_EQ(must(scenarios.save_draft(instructor, first.scenario, mine, their)), DraftSave::kept);
  EXPECT_EQ(must(theirs.drop_draft(instructor, first.scenario, mine)), DraftSave::kept);
  EXPECT_EQ(must(scenarios.save_draft(instructor, first.scenario, zero, mine)), DraftSave::changed_elsewhere) << "it is gone";
  EXPECT_FALSE(must(scenarios.draft(instructor, first.scenario)));
}

TEST_F(ScenariosTest, a_student_publishes_nothing) {
  const Actor student = make_student(*store).actor();
  EXPECT_EQ(code_of(scenarios.publish(student, small_scenario(), "{}", {})), StorageError::not_allowed);
  EXPECT_EQ(code_of(scenarios.save_draft(student, small_scenario().id, "{}", {})), StorageError::not_allowed);
  EXPECT_EQ(code_of(scenarios.drafts(student)), StorageError::not_allowed);
}

TEST_F(ScenariosTest, a_versions_files_are_kept_by_content) {
  const std::vector<std::byte> voxels(100'000, std::byte{3});
  const Hash256 hash = must(store->blobs.put(voxels));
  EXPECT_EQ(must(store->blobs.put(voxels)), hash);
  EXPECT_EQ(hash, blake2b_256(voxels));
  const auto version = must(scenarios.ensure(small_scenario(), "{}", hash, {{"tooth.nrrd", hash}}));
  EXPECT_EQ(must(store->blobs.get(version.files.at("tooth.nrrd"))), voxels);
  EXPECT_EQ(code_of(store->blobs.get(Hash256{})), StorageError::not_found);
  EXPECT_EQ(code_of(scenarios.ensure(small_scenario(), "{}", Hash256{1}, {{"x", Hash256{}}})), StorageError::not_found);
  EXPECT_EQ(must(scenarios.versions(small_scenario().id)).size(), 1u);
}

TEST_F(ScenariosTest, a_damaged_blob_is_refused_and_put_right_by_the_next_who_has_its_bytes) {
  const std::vector<std::byte> voxels(1000, std::byte{3});
  const Hash256 hash = must(store->blobs.put(voxels));
  must(store->database().run("UPDATE blobs SET packed = zeroblob(20) WHERE hash = ?1", hash));
  EXPECT_EQ(code_of(store->blobs.get(hash)), StorageError::corrupt);
  EXPECT_EQ(must(store->blobs.put(voxels)), hash);
  EXPECT_EQ(must(store->blobs.get(hash)), voxels) << "else no attempt at the exercise could be resumed or graded";
}

TEST_F(ScenariosTest, a_withdrawn_version_leaves_the_library_and_stays_in_the_records) {
  const Account student = make_student(*store);
  const auto first = keep(*store);
  const auto second = must(store->scenarios.publish(instructor, small_scenario(), "{\"id\":2}", blake2b_256(std::string_view{"2"})));
  const SessionId session = complete_session(*store, student, second);
  EXPECT_EQ(code_of(store->scenarios.withdraw(student.actor(), second.id)), StorageError::not_allowed);
  must(store->scenarios.withdraw(instructor, second.id));
  EXPECT_EQ(code_of(store->scenarios.withdraw(instructor, second.id)), StorageError::duplicate);
  ASSERT_EQ(must(store->scenarios.library()).size(), 1u);
  EXPECT_EQ(must(store->scenarios.library())[0].id, first.id);
  must(store->scenarios.withdraw(instructor, first.id));
  EXPECT_TRUE(must(store->scenarios.library()).empty());
  EXPECT_TRUE(must(store->scenarios.withdrawn(first.id)));
  EXPECT_EQ(must(store->history.details(student.actor(), session)).row.version_number, 2);
}

TEST_F(ScenariosTest, a_withdrawn_version_is_not_assigned_anew_and_what_was_assigned_stays) {
  const CohortId cohort = must(store->cohorts.create(instructor, "A")).id;
  const auto version = keep(*store);
  const Assignment before = must(store->assignments.create(instructor, {.version = version.id, .cohort = cohort}));
  must(store->scenarios.withdraw(instructor, version.id));
  const auto after = store->assignments.create(instructor, {.version = version.id, .cohort = cohort});
  EXPECT_EQ(code_of(after), StorageError::wrong_state);
  EXPECT_EQ(after.error().where, "version_withdrawn");
  const auto all = must(store->assignments.for_cohort(cohort));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].id, before.id);
}

TEST_F(ScenariosTest, assignments_reach_the_cohorts_students) {
  const Account student = make_student(*store);
  const Cohort cohort = must(store->cohorts.create(instructor, "A"));
  must(store->cohorts.add(instructor, cohort.id, student.id));
  const auto version = keep(*store);
  Assignment wanted{.version = version.id, .cohort = cohort.id, .kind = SessionKind::assessment};
  const Assignment later = must(store->assignments.create(instructor, wanted, "4711"));
  wanted.due_utc_us = kNow + 1;
  wanted.attempts_allowed = 10;
  const Assignment due = must(store->assignments.create(instructor, wanted, "amber"));
  const auto mine = must(store->assignments.for_student(student.id));
  ASSERT_EQ(mine.size(), 2u);
  EXPECT_EQ(mine[0].id, due.id);
  EXPECT_EQ(mine[0].attempts_allowed, 10);
  EXPECT_EQ(mine[1].id, later.id);
  EXPECT_EQ(mine[1].kind, SessionKind::assessment);
  EXPECT_EQ(must(store->assignments.for_cohort(cohort.id)).size(), 2u);
  wanted.opens_utc_us = kNow + 1;
  EXPECT_EQ(code_of(store->assignments.create(instructor, wanted, "4711")), StorageError::bad_value);
  wanted.opens_utc_us.reset();
  EXPECT_EQ(code_of(store->assignments.create(instructor, wanted, "47")), StorageError::bad_value);
  EXPECT_EQ(must(store->assignments.start_code(instructor, due.id)), "amber");
  EXPECT_EQ(code_of(store->assignments.start_code(student.actor(), due.id)), StorageError::not_allowed);
  EXPECT_EQ(must(store->assignments.find(due.id)).attempts_allowed, 10);
  wanted.kind = SessionKind::try_it;
  EXPECT_EQ(code_of(store->assignments.create(instructor, wanted)), StorageError::bad_value);
  EXPECT_EQ(code_of(store->assignments.create(student.actor(), wanted)), StorageError::not_allowed);
}

}  // namespace
}  // namespace cusp::test
