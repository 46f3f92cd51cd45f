#include <gtest/gtest.h>

#include <limits>

#include "tests/storage/sample.h"

namespace cusp::test {
namespace {


class SessionsTest : public ::testing::Test {
 protected:
  Folder folder;
  std::unique_ptr<Store> store = open(folder / "a.db");
  Account student = make_student(*store);
  ScenarioVersion version = keep(*store);

  SessionId start() { return must(store->sessions.start(student.actor(), new_session(student, version))).id; }
};

TEST_F(SessionsTest, the_header_comes_back_to_the_bit) {
  NewSession wanted = new_session(student, version);
  wanted.header.device.max_force_n = 0.1 + 0.2;
  wanted.header.device.rotation_axes = 3;
  wanted.header.device.has_own_clock = true;
  wanted.header.guard.slew_n_per_ms = 1.0 / 3.0;
  wanted.header.calibration = "2026-11-20 ä";
  wanted.header.specimen_hash = UINT64_MAX;
  wanted.header.scene = "{\"burs\":[1.0]}";
  const Session session = must(store->sessions.start(student.actor(), wanted));
  EXPECT_EQ(session.header.device.max_force_n, 0.1 + 0.2);
  EXPECT_EQ(session.header.device.rotation_axes, 3);
  EXPECT_TRUE(session.header.device.has_own_clock);
  EXPECT_EQ(session.header.guard.slew_n_per_ms, 1.0 / 3.0);
  EXPECT_EQ(session.header.calibration, "2026-11-20 ä");
  EXPECT_EQ(session.header.specimen_hash, UINT64_MAX);
  EXPECT_EQ(session.header.scene, "{\"burs\":[1.0]}");
  EXPECT_EQ(session.header.engine_version, kEngineVersion);
  EXPECT_EQ(session.version_hash, version.content_hash);
  EXPECT_EQ(session.started_utc_us, kNow);
}

TEST_F(SessionsTest, a_session_goes_from_running_to_finished_to_graded) {
  const SessionId id = start();
  EXPECT_EQ(must(store->sessions.state(id)), SessionState::running);
  must(store->traces.append(id, second_from(1)));
  EXPECT_EQ(code_of(store->grades.save(id, small_grade(), {})), StorageError::wrong_state);
  EXPECT_EQ(code_of(store->sessions.close(id, "")), StorageError::wrong_state);
  must(store->sessions.finish(id, volume_after(12), "student"));
  EXPECT_EQ(must(store->sessions.state(id)), SessionState::finished);
  EXPECT_EQ(code_of(store->sessions.finish(id, volume_after(12), "student")), StorageError::wrong_state);
  EXPECT_EQ(code_of(store->traces.append(id, second_from(13))), StorageError::wrong_state);
  EXPECT_EQ(code_of(store->sessions.resume(id, "")), StorageError::wrong_state);
  must(store->grades.save(id, small_grade(), {}));
  must(store->sessions.close(id, "done"));
  EXPECT_EQ(must(store->sessions.state(id)), SessionState::graded);
  const auto events = must(store->sessions.events(id));
  ASSERT_EQ(events.size(), 4u);
  EXPECT_EQ(events[1].kind, EventKind::finished);
  EXPECT_EQ(events[1].reason, "student");
  EXPECT_EQ(events[1].tick, 12u);
  for (std::size_t i = 1; i < events.size(); ++i) EXPECT_GT(events[i].sequence, events[i - 1].sequence);
}

TEST_F(SessionsTest, the_trace_comes_back_second_by_second) {
  const SessionId id = complete_session(*store, student, version);
  std::vector<StepInput> all;
  for (const std::uint64_t first : {1, 13, 25}) {
    const auto inputs = second_from(first).inputs;
    all.insert(all.end(), inputs.begin(), inputs.end());
  }
  EXPECT_EQ(must(store->traces.inputs(id)), all);
  EXPECT_EQ(must(store->traces.inputs(id, 1)), second_from(13).inputs);
  EXPECT_EQ(code_of(store->traces.inputs(id, 3)), StorageError::not_found);
  const auto chunks = must(store->traces.chunks(id));
  ASSERT_EQ(chunks.size(), 3u);
  EXPECT_EQ(chunks[2].first_tick, 25u);
  EXPECT_EQ(chunks[2].count, 12u);
  EXPECT_EQ(chunks[2].elapsed_us, 36u * 83'334u);
  EXPECT_EQ(chunks[2].state_hash, second_from(25).state_hash);
  const auto volume = must(store->traces.final_volume(id));
  EXPECT_EQ(volume->cuts, volume_after(36).cuts);
  EXPECT_EQ(volume->hash, volume_after(36).hash);
}

TEST_F(SessionsTest, key_states_are_found_at_or_before_a_tick) {
  const SessionId id = complete_session(*store, student, version);
  EXPECT_EQ(must(store->traces.key_state_ticks(id)), std::vector<std::uint64_t>{24});
  EXPECT_FALSE(must(store->traces.key_state_before(id, 23)));
  EXPECT_EQ(must(store->traces.key_state_before(id, 24))->tick, 24u);
  EXPECT_EQ(must(store->traces.key_state_before(id, 999))->state, std::vector<std::byte>(30, std::byte{7}));
}

TEST_F(SessionsTest, a_second_that_does_not_follow_the_last_is_refused_whole) {
  const SessionId id = start();
  EXPECT_EQ(code_of(store->traces.append(id, second_from(2))), StorageError::wrong_state);
  must(store->traces.append(id, second_from(1)));
  EXPECT_EQ(code_of(store->traces.append(id, second_from(1))), StorageError::wrong_state);
  EXPECT_EQ(code_of(store->traces.append(id, second_from(14))), StorageError::wrong_state);
  RecordedSecond none = second_from(13);
  none.inputs.clear();
  EXPECT_EQ(code_of(store->traces.append(id, none)), StorageError::bad_value);
  RecordedSecond unknown_tissue = second_from(13);
  unknown_tissue.metrics.removed[0].tissue = static_cast<Tissue>(77);
  EXPECT_EQ(code_of(store->traces.append(id, unknown_tissue)), StorageError::bad_value);
  EXPECT_EQ(must(store->traces.chunks(id)).size(), 1u);
  EXPECT_TRUE(must(verify_session(store->context(), id)).intact());
  EXPECT_EQ(code_of(store->sessions.finish(id, volume_after(11), "student")), StorageError::wrong_state);
}

TEST_F(SessionsTest, removed_tissue_is_listed_over_time_and_in_the_end) {
  const SessionId id = start();
  RecordedSecond second = second_from(1);
  second.metrics.removed = {{Tissue::enamel, 5, 0.5}};
  must(store->traces.append(id, second));
  second = second_from(13);
  second.metrics.removed = {{Tissue::enamel, 5, 0.5}, {Tissue::dentine, 2, 0.25}};
  must(store->traces.append(id, second));
  second = second_from(25);
  second.metrics.removed = {{Tissue::enamel, 9, 0.75}};
  must(store->traces.append(id, second));
  const auto rows = must(store->metrics.over_time(id));
  ASSERT_EQ(rows.size(), 3u);
  ASSERT_EQ(rows[0].metrics.removed.size(), 1u);
  EXPECT_EQ(rows[0].metrics.force_peak_n, 2.1);
  ASSERT_EQ(rows[1].metrics.removed.size(), 2u);
  EXPECT_EQ(rows[1].metrics.removed[1].tissue, Tissue::dentine);
  ASSERT_EQ(rows[2].metrics.removed.size(), 2u);
  EXPECT_EQ(rows[2].metrics.removed[0].voxels, 9u);
  const auto total = must(store->metrics.removed(id));
  ASSERT_EQ(total.size(), 2u);
  EXPECT_EQ(total[0].mm3, 0.75);
  EXPECT_EQ(total[1].voxels, 2u);
}

TEST_F(SessionsTest, a_grade_comes_back_to_the_bit_and_an_older_one_stays) {
  const SessionId id = complete_session(*store, student, version);
  const Actor instructor = make_instructor(*store).actor();
  EXPECT_EQ(code_of(store->grades.save(id, small_grade(), {}, student.actor())), StorageError::not_allowed);
  Grade second = small_grade(1.0 / 3.0, false);
  second.criteria[0].measure.measured = false;
  must(store->grades.save(id, second, Hash256{9}, instructor));
  const auto grades = must(store->grades.all(id));
  ASSERT_EQ(grades.size(), 2u);
  EXPECT_TRUE(grades[0].grader.is_nil());
  EXPECT_EQ(grades[0].grade.score, 81.5);
  const StoredGrade newest = *must(store->grades.newest(id));
  EXPECT_EQ(newest.grader, instructor.id);
  EXPECT_EQ(newest.number, 1);
  EXPECT_EQ(newest.rubric_hash, Hash256{9});
  EXPECT_EQ(newest.engine_version, kEngineVersion);
  EXPECT_EQ(newest.grade.score, 1.0 / 3.0);
  EXPECT_FALSE(newest.grade.passed);
  EXPECT_EQ(newest.grade.critical, std::vector<std::string>{"pulp_exposure"});
  ASSERT_EQ(newest.grade.criteria.size(), 2u);
  const CriterionGrade& depth = newest.grade.criteria[1];
  EXPECT_EQ(depth.id, "floor_depth_max");
  EXPECT_EQ(depth.measure.value, 2.41);
  EXPECT_EQ(depth.measure.uncertainty, 0.03);
  EXPECT_EQ(depth.measure.unit, "mm");
  EXPECT_EQ(depth.measure.where_mm, Vec3(1.5, -0.25, 3.0));
  EXPECT_EQ(depth.reason_code, "too_deep");
  EXPECT_EQ(depth.reason_args, small_grade().criteria[1].reason_args);
  EXPECT_FALSE(newest.grade.criteria[0].measure.measured);
  EXPECT_FALSE(newest.grade.criteria[0].measure.where_mm);
  EXPECT_TRUE(must(verify_session(store->context(), id)).intact());
}

TEST_F(SessionsTest, a_grade_of_format_1_is_read_by_the_present_names_of_its_metrics_and_its_rows_stay) {
  const SessionId id = complete_session(*store, student, version);
  Grade old = small_grade();
  old.criteria[0].id = old.criteria[0].measure.metric = "undercut";
  must(store->grades.save(id, old, {}, make_instructor(*store).actor()));
  add_old_grade(*store, id, old);
  const auto grades = must(store->grades.all(id));
  ASSERT_EQ(grades.size(), 3u);
  for (const StoredGrade& read : {grades[1], grades[2]}) {
    EXPECT_EQ(read.grade.criteria[0].id, "uncut_remainder");
    EXPECT_EQ(read.grade.criteria[0].measure.metric, "uncut_remainder");
    EXPECT_EQ(read.grade.criteria[1].id, old.criteria[1].id);
    EXPECT_EQ(read.grade.criteria[1].reason_args.at("limit"), 2.0);
  }
  EXPECT_EQ(*must(store->database().first("SELECT count(*) FROM criteria WHERE id = 'undercut'", [](Row row) { return row.integer(0); })), 1);
}

TEST_F(SessionsTest, put_a_damaged_header_right_at_the_next_start) {
  const SessionId first = must(store->sessions.start(student.actor(), new_session(student, version))).id;
  must(store->database().run("UPDATE blobs SET packed = x'00'"));
  EXPECT_EQ(code_of(store->sessions.find(first)), StorageError::corrupt);
  must(store->sessions.start(student.actor(), new_session(student, version)));
  EXPECT_TRUE(store->sessions.find(first));
}

TEST_F(SessionsTest, keep_a_header_once_and_each_reads_its_own) {
  NewSession wanted = new_session(student, version);
  const SessionId first = must(store->sessions.start(student.actor(), wanted)).id, second = must(store->sessions.start(student.actor(), wanted)).id;
  wanted.header.calibration = "2026-11-20";
  const SessionId other = must(store->sessions.start(student.actor(), wanted)).id;
  EXPECT_EQ(*must(store->database().first("SELECT count(*) FROM blobs", [](Row row) { return row.integer(0); })), 2);
  EXPECT_EQ(must(store->sessions.find(first)).header.calibration, "");
  EXPECT_EQ(must(store->sessions.find(second)).header.guard.limit_n, wanted.header.guard.limit_n);
  EXPECT_EQ(must(store->sessions.find(other)).header.calibration, "2026-11-20");
}

TEST_F(SessionsTest, an_interrupted_session_is_resumed_or_graded_as_it_stands) {
  const SessionId id = start();
  must(store->traces.append(id, second_from(1)));
  must(store->sessions.interrupt(id, "recorder_full"));
  EXPECT_EQ(must(store->sessions.state(id)), SessionState::interrupted);
  EXPECT_EQ(code_of(store->traces.append(id, second_from(13))), StorageError::wrong_state);
  must(store->sessions.resume(id, "student"));
  must(store->traces.append(id, second_from(13)));
  must(store->sessions.interrupt(id, "recorder_full"));
  const FinalVolume volume = volume_after(24);
  must(store->grades.save(id, small_grade(), {}, std::nullopt, &volume));
  must(store->grades.save(id, small_grade(), {}, std::nullopt, &volume));
  EXPECT_EQ(must(store->traces.final_volume(id))->tick, 24u);
  EXPECT_EQ(must(store->sessions.state(id)), SessionState::graded);
  EXPECT_TRUE(must(verify_session(store->context(), id)).intact());
}

TEST_F(SessionsTest, a_tooth_that_was_drilled_on_while_it_was_measured_gets_no_grade) {
  const SessionId id = start();
  must(store->traces.append(id, second_from(1)));
  must(store->sessions.interrupt(id, "recorder_full"));
  const FinalVolume measured = volume_after(12);  // at another desk, which takes seconds
  must(store->sessions.resume(id, "student"));
  must(store->traces.append(id, second_from(13)));
  must(store->sessions.finish(id, volume_after(24), "student"));
  const auto late = store->grades.save(id, small_grade(20, false), {}, std::nullopt, &measured);
  ASSERT_EQ(code_of(late), StorageError::wrong_state);
  EXPECT_EQ(late.error().where, "final_volumes");
  EXPECT_FALSE(must(store->grades.newest(id))) << "it would stand for the finished tooth";
  const FinalVolume finished = volume_after(24);
  must(store->grades.save(id, small_grade(), {}, std::nullopt, &finished));
  EXPECT_TRUE(must(verify_session(store->context(), id)).intact());
}

TEST_F(SessionsTest, two_desks_that_grade_one_attempt_keep_one_grade_and_what_was_stated_about_it) {
  const Actor instructor = make_instructor(*store).actor();
  const SessionId id = start();
  must(store->traces.append(id, second_from(1)));
  must(store->sessions.interrupt(id, "recorder_full"));
  const FinalVolume volume = volume_after(12);
  must(store->grades.save(id, small_grade(), {}, std::nullopt, &volume, 0));
  must(store->statements.override_points(instructor, id, "target_removed", 20, "The block was worn."));
  const auto second = store->grades.save(id, small_grade(), {}, std::nullopt, &volume, 0);
  ASSERT_EQ(code_of(second), StorageError::wrong_state);
  EXPECT_EQ(second.error().where, "graded");
  EXPECT_EQ(must(store->grades.all(id)).size(), 1u);
  EXPECT_EQ(must(store->history.details(instructor, id)).grade->overrides.size(), 1u);
  must(store->grades.save(id, small_grade(50), {}, instructor, nullptr, 1));
  EXPECT_EQ(must(store->grades.newest(id))->number, 1) << "graded anew by somebody who has seen the first one";
}

TEST_F(SessionsTest, an_interrupted_attempt_whose_grade_was_not_kept_is_resumed_and_finished) {
  const SessionId id = start();
  must(store->traces.append(id, second_from(1)));
  must(store->sessions.interrupt(id, "recorder_full"));
  const FinalVolume volume = volume_after(12);
  must(store->database().run("CREATE TEMP TRIGGER disk_full BEFORE INSERT ON main.grades BEGIN SELECT RAISE(ABORT, 'full'); END"));
  EXPECT_FALSE(store->grades.save(id, small_grade(), {}, std::nullopt, &volume));
  must(store->database().run("DROP TRIGGER disk_full"));
  EXPECT_FALSE(must(store->traces.final_volume(id)));
  must(store->sessions.resume(id, "student"));
  must(store->traces.append(id, second_from(13)));
  must(store->sessions.finish(id, volume_after(24), "student"));
}

TEST_F(SessionsTest, an_interrupted_attempt_that_keeps_a_volume_is_graded_and_not_resumed) {
  const SessionId id = start();
  must(store->traces.append(id, second_from(1)));
  must(store->sessions.interrupt(id, "recorder_full"));
  keep_volume_row(*store, id, volume_after(12));
  EXPECT_TRUE(must(store->traces.keeps_volume(id)));
  const auto resumed = store->sessions.resume(id, "student");
  ASSERT_EQ(code_of(resumed), StorageError::wrong_state);
  EXPECT_EQ(resumed.error().where, "volume_kept");
  EXPECT_EQ(must(store->sessions.state(id)), SessionState::interrupted);
  const FinalVolume volume = volume_after(12);
  must(store->grades.save(id, small_grade(), {}, std::nullopt, &volume));
  EXPECT_EQ(must(store->traces.final_volume(id))->tick, 12u);
  EXPECT_TRUE(must(verify_session(store->context(), id)).intact());
}

TEST_F(SessionsTest, a_volume_that_the_recording_goes_beyond_is_not_the_final_one) {
  const SessionId id = start();
  must(store->traces.append(id, second_from(1)));
  must(store->sessions.interrupt(id, "recorder_full"));
  must(store->sessions.resume(id, "student"));
  must(store->traces.append(id, second_from(13)));
  must(store->sessions.interrupt(id, "process_gone"));
  keep_volume_row(*store, id, volume_after(12));
  EXPECT_FALSE(must(store->traces.final_volume(id)));
  const FinalVolume volume = volume_after(24);
  must(store->grades.save(id, small_grade(), {}, std::nullopt, &volume));
  EXPECT_EQ(must(store->sessions.state(id)), SessionState::graded);
  EXPECT_TRUE(must(verify_session(store->context(), id)).intact());
}

TEST_F(SessionsTest, one_starts_only_ones_own_and_only_what_is_there) {
  const Account other = make_student(*store, "2", "B");
  EXPECT_EQ(code_of(store->sessions.start(other.actor(), new_session(student, version))), StorageError::not_allowed);
  NewSession unknown = new_session(student, version);
  unknown.version = VersionId::make();
  EXPECT_EQ(code_of(store->sessions.start(student.actor(), unknown)), StorageError::not_found);
  NewSession endless = new_session(student, version);
  endless.header.device.max_force_n = std::numeric_limits<double>::infinity();
  EXPECT_EQ(code_of(store->sessions.start(student.actor(), endless)), StorageError::bad_value);
  EXPECT_EQ(code_of(store->sessions.find(SessionId::make())), StorageError::not_found);
  EXPECT_EQ(code_of(store->sessions.state(SessionId::make())), StorageError::not_found);
  EXPECT_EQ(code_of(store->traces.append(SessionId::make(), second_from(1))), StorageError::not_found);
  EXPECT_EQ(code_of(verify_session(store->context(), SessionId::make())), StorageError::not_found);
}

TEST_F(SessionsTest, a_session_of_this_process_is_not_taken_for_an_interrupted_one) {
  const SessionId id = start();
  EXPECT_TRUE(must(store->sessions.mark_interrupted()).empty());
  const auto second = open(folder / "a.db");
  EXPECT_EQ(must(second->sessions.state(id)), SessionState::running);
}

}  // namespace
}  // namespace cusp::test
