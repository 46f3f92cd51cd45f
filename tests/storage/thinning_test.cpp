/// Recordings of old practice attempts go: what stays, which attempts stay whole, and what every reader answers then.
#include <gtest/gtest.h>

#include "storage/exchange/session_extract.h"
#include "tests/storage/old_attempts.h"
#include "tests/storage/statements_seen.h"

namespace cusp::test {
namespace {

struct ThinningTest : OldAttempts {};

TEST_F(ThinningTest, takes_the_recording_and_leaves_all_else_as_it_was) {
  const SessionId session = attempt(91);
  const auto before = rows_of(session);
  const auto details = must(store->history.details(admin, session));
  const ThinningReport report = thin();
  EXPECT_EQ(report.attempts, 1u);
  EXPECT_GT(report.bytes, 0u);
  EXPECT_TRUE(is_thinned(session));
  EXPECT_EQ(count("trace_chunks"), 0);
  EXPECT_EQ(count("key_states"), 0);
  auto after = rows_of(session);
  EXPECT_NE(after, before);
  for (const char* gone : {"trace_chunks", "key_states"}) after[gone] = before.at(gone);
  EXPECT_EQ(after, before);
  const auto again = must(store->history.details(admin, session));
  EXPECT_EQ(again.row.elapsed_us, details.row.elapsed_us);
  EXPECT_EQ(again.row.score, details.row.score);
  EXPECT_EQ(must(store->traces.final_volume(session))->cuts, volume_after(36).cuts);
  EXPECT_EQ(must(store->metrics.over_time(session)).size(), 3u);
  EXPECT_EQ(findings(), "");
  EXPECT_EQ(must(rebuild_summaries(store->context(), admin)), 0u);
}

TEST_F(ThinningTest, takes_nothing_while_the_clock_is_far_ahead_of_every_record_until_it_is_confirmed) {
  const SessionId session = attempt(0);
  *now = kNow + kLongestPause_us + 1;
  EXPECT_TRUE(thin(ThinningMode::dry_run).doubt);
  EXPECT_EQ(code_of(thin_traces(store->context(), admin, {.mode = ThinningMode::carry_out})), StorageError::clock_ahead);
  EXPECT_FALSE(is_thinned(session));
  must(thin_traces(store->context(), admin, {.mode = ThinningMode::carry_out, .trust = ClockTrust::confirmed}));
  EXPECT_TRUE(is_thinned(session));
}

TEST_F(ThinningTest, leaves_its_length_to_the_report_and_one_code_to_all_who_need_inputs) {
  const SessionId session = attempt(91);
  thin();
  const auto chunks = must(store->traces.chunks(session));
  ASSERT_EQ(chunks.size(), 1u);
  EXPECT_EQ(chunks[0].first_tick + chunks[0].count - 1, 36u);
  EXPECT_EQ(chunks[0].elapsed_us, 3'000'024u) << "three seconds of twelve inputs, 83,334 µs each";
  const auto refused = [](const auto& result) {
    if (result) return std::string("succeeded");
    return result.error().code == StorageError::wrong_state ? result.error().where + ' ' + result.error().detail : std::string("another code");
  };
  const std::string thinned = "thinned " + std::to_string(kNow);
  EXPECT_EQ(refused(store->traces.inputs(session)), thinned);
  EXPECT_EQ(refused(store->traces.inputs(session, 0)), thinned);
  EXPECT_EQ(refused(store->grades.save(session, small_grade(), {})), thinned);
  EXPECT_EQ(refused(extract_session(store->context(), admin, session, StudentNamed::by_name, folder / "pack.db")), thinned);
  EXPECT_FALSE(std::filesystem::exists(folder / "pack.db"));
  EXPECT_FALSE(store->sessions.resume(session, "again"));
  must(store->sessions.close(session, "over"));
  EXPECT_EQ(must(store->sessions.events(session)).back().tick, 36u);
  EXPECT_EQ(findings(), "") << "the chain goes on";
}

TEST_F(ThinningTest, leaves_whole_what_is_young_assessed_unfinished_ungraded_or_stated) {
  const SessionId commented = attempt(91), ungraded = attempt(91, Upto::finished), broken_off = attempt(91, Upto::interrupted),
                  confirmed = attempt(91), overridden = attempt(91), sat = assessment(91), young = attempt(89);
  must(store->statements.comment(instructor, commented, "Look at the wall."));
  must(store->statements.confirm(instructor, confirmed));
  const SignedStatement override_ = must(store->statements.override_points(instructor, overridden, "target_removed", 20, "Worn."));
  must(store->statements.withdraw(instructor, overridden, override_.id, "It was not."));
  const ThinningReport report = thin();
  EXPECT_EQ(report.attempts, 1u);
  EXPECT_TRUE(is_thinned(commented));
  for (const SessionId whole : {young, ungraded, broken_off, confirmed, overridden, sat}) EXPECT_FALSE(is_thinned(whole));
  EXPECT_EQ(kept(report, KeptBecause::assessment), 1u);
  EXPECT_EQ(kept(report, KeptBecause::unfinished), 1u);
  EXPECT_EQ(kept(report, KeptBecause::ungraded), 1u);
  EXPECT_EQ(kept(report, KeptBecause::stated), 2u) << "one of them withdrawn";
  EXPECT_EQ(findings(), "");
  EXPECT_EQ(thin().attempts, 0u) << "once";
}

TEST_F(ThinningTest, leaves_an_attempt_of_yesterday_whole_that_a_clock_seven_years_back_dated) {
  const SessionId old = attempt(92);
  attempt(2);
  const SessionId yesterdays = attempt(7 * 365);
  const ThinningReport report = thin();
  EXPECT_EQ(report.attempts, 1u);
  EXPECT_TRUE(is_thinned(old));
  EXPECT_FALSE(is_thinned(yesterdays));
  EXPECT_EQ(report.kept, KeptTraces{}) << "like every young one";
}

struct ThinningAfterYearsBack : OldAttempts {
  ThinningAfterYearsBack() : OldAttempts(2600) {}
};

TEST_F(ThinningAfterYearsBack, takes_nothing_for_ninety_days_unless_the_dates_are_confirmed) {
  const SessionId first_week = attempt(2600);
  attempt(21);
  attempt(0);
  EXPECT_EQ(code_of(thin_traces(store->context(), admin, {.mode = ThinningMode::carry_out})), StorageError::clock_ahead);
  EXPECT_FALSE(is_thinned(first_week));
  attempt(-90);
  *now = kNow + 90 * kDay_us;
  EXPECT_FALSE(thin(ThinningMode::dry_run).doubt) << "the right clock has run for longer";
}

TEST_F(ThinningTest, leaves_an_attempt_whole_that_was_resumed_and_finished_yesterday_under_a_clock_set_back) {
  const SessionId resumed = attempt(100, Upto::interrupted);
  attempt(2);
  *now = kNow - 95 * kDay_us;
  must(store->sessions.resume(resumed, "student"));
  must(store->traces.append(resumed, second_from(1001)));
  must(store->sessions.finish(resumed, volume_after(1012), "student"));
  must(store->grades.save(resumed, small_grade(), {}));
  *now = kNow;
  EXPECT_EQ(thin().attempts, 0u);
  EXPECT_FALSE(is_thinned(resumed));
}

TEST_F(ThinningTest, names_an_attempt_that_does_not_verify_and_leaves_it) {
  const SessionId changed = attempt(92), resealed = attempt(92), good = attempt(91);
  must(store->database().run("UPDATE grades SET score = 100 WHERE session = ?1", changed));
  // Its last rows and links taken out, as an older copy of the file has it, with the head of that day.
  put_back_before_grade(resealed);
  const ThinningReport report = thin();
  EXPECT_EQ(report.attempts, 1u);
  EXPECT_TRUE(is_thinned(good));
  EXPECT_EQ(kept(report, KeptBecause::broken), 2u);
  ASSERT_EQ(report.broken.size(), 2u);
  EXPECT_EQ(report.broken[0].owner, changed.uuid);
  EXPECT_EQ(report.broken[0].table, "grades");
  EXPECT_EQ(report.broken[1].owner, resealed.uuid);
  EXPECT_EQ(report.broken[1].code, FindingCode::seal_broken);
  EXPECT_EQ(count("trace_chunks"), 6) << "three each";
}

TEST_F(ThinningTest, reads_the_seals_of_an_attempt_along_their_index) {
  const SessionId session = attempt(91);
  Uuid same_moment = session.uuid;
  same_moment.bytes.back() ^= std::uint8_t{1};
  must(store->audit.add({.action = "session_sealed", .subject = same_moment, .detail = "started 2 " + std::string(64, '0')}));
  store.reset();
  const StatementsSeen seen;
  store = open(folder / "a.db", quick(now));
  EXPECT_EQ(thin(ThinningMode::dry_run).attempts, 1u) << "the seal is of another session";
  std::string plans;
  for (const std::string& sql : StatementsSeen::texts()) {
    if (sql.find("FROM audit_log a") == std::string::npos) continue;
    for (const std::string& line : plan_of(store->database(), sql)) plans += line + '\n';
  }
  EXPECT_NE(plans.find("SEARCH a USING INDEX seals_of_session (<expr>=?)"), std::string::npos) << plans;
}

TEST_F(ThinningTest, in_a_dry_run_finds_the_same_and_changes_nothing) {
  attempt(93);
  must(store->database().run("UPDATE grades SET score = 100 WHERE session = ?1", attempt(92)));
  attempt(91);
  const auto before = must(store->database().first("SELECT entries FROM audit_head", [](Row row) { return row.integer(0); }));
  const ThinningReport would = thin(ThinningMode::dry_run);
  EXPECT_EQ(count("trace_chunks"), 9);
  EXPECT_EQ(count("thinned_traces"), 0);
  EXPECT_EQ(must(store->database().first("SELECT entries FROM audit_head", [](Row row) { return row.integer(0); })), before);
  const OldTraces old = must(old_traces(store->context(), admin, 90));
  EXPECT_EQ(old.thinnable.size(), 3u) << "not verified yet";
  const ThinningReport did = thin();
  EXPECT_EQ(would.attempts, 2u);
  EXPECT_EQ(did.attempts, would.attempts);
  EXPECT_EQ(did.bytes, would.bytes);
  EXPECT_EQ(did.kept, would.kept);
}

TEST_F(ThinningTest, is_for_administrators_and_for_a_day_or_more) {
  attempt(91);
  const ThinningOrder order{.mode = ThinningMode::carry_out};
  EXPECT_EQ(code_of(thin_traces(store->context(), instructor, order)), StorageError::not_allowed);
  EXPECT_EQ(code_of(thin_traces(store->context(), student.actor(), {})), StorageError::not_allowed);
  EXPECT_EQ(code_of(old_traces(store->context(), student.actor(), 90)), StorageError::not_allowed);
  EXPECT_EQ(code_of(old_traces(store->context(), admin, 0)), StorageError::bad_value);
  EXPECT_EQ(code_of(old_traces(store->context(), admin, kMostThinAfterDays + 1)), StorageError::bad_value);
  EXPECT_EQ(count("thinned_traces"), 0);
}

TEST_F(ThinningTest, ends_between_two_attempts_when_the_watch_says_so) {
  for (int i = 0; i < 3; ++i) attempt(91);
  const auto report = must(thin_traces(store->context(), admin, {.mode = ThinningMode::carry_out}, [](std::size_t done, std::size_t all) {
    EXPECT_EQ(all, 3u);
    return done < 2;
  }));
  EXPECT_TRUE(report.stopped);
  EXPECT_EQ(report.attempts, 2u);
  EXPECT_EQ(report.left, 1u);
  EXPECT_EQ(count("thinned_traces"), 2);
  EXPECT_EQ(findings(), "");
}

TEST_F(ThinningTest, that_a_write_ends_reports_what_was_thinned_and_why_it_ended) {
  for (int i = 0; i < 3; ++i) attempt(91);
  must(store->database().run("CREATE UNIQUE INDEX one_alone ON thinned_traces (abs(0))"));
  const auto report = must(thin_traces(store->context(), admin, {.mode = ThinningMode::carry_out}));
  EXPECT_EQ(report.attempts, 1u);
  EXPECT_TRUE(report.failed);
  EXPECT_EQ(report.left, 1u) << "one was thinned, one failed";
  EXPECT_EQ(count("thinned_traces"), 1);
  EXPECT_FALSE(thin_traces(store->context(), admin, {.mode = ThinningMode::carry_out})) << "nothing is thinned";
}

TEST_F(ThinningTest, gives_the_pages_back_and_drops_cached_key_states) {
  const SessionId session = attempt(91, Upto::graded, 40);
  must(store->key_states.keep_rebuilt(session, {12, std::vector<std::byte>(5000, std::byte{7}), {}}));
  ASSERT_EQ(store->key_states.ticks(session).size(), 1u);
  const auto pages = [&] { return *must(store->database().first("PRAGMA page_count", [](Row row) { return row.integer(0); })); };
  const std::int64_t before = pages();
  const std::uint64_t bytes = thin().bytes;
  EXPECT_GT(bytes, 100'000u) << "40 seconds of noise";
  EXPECT_LE(pages(), before - static_cast<std::int64_t>(bytes / 8192)) << "pages of 8,192 bytes";
  EXPECT_EQ(*must(store->database().first("PRAGMA freelist_count", [](Row row) { return row.integer(0); })), 0);
  EXPECT_TRUE(store->key_states.ticks(session).empty());
}

TEST_F(ThinningTest, of_a_recording_without_a_row_that_holds_is_found) {
  const SessionId thinned = attempt(92), whole = attempt(91);
  must(thin_traces(store->context(), admin, {.older_than_days = 92, .mode = ThinningMode::carry_out}));
  ASSERT_TRUE(is_thinned(thinned));
  const auto first_of = [&](SessionId session, std::initializer_list<std::string> statements) {
    must(store->database().run("PRAGMA foreign_keys = OFF"));
    must(store->database().run("BEGIN"));
    for (const std::string& sql : statements) must(store->database().run(sql));
    const auto proof = must(verify_session(store->context(), session));
    must(store->database().run("ROLLBACK"));
    if (proof.intact()) return std::string("intact");
    return std::string(key_of(proof.findings[0].code)) + ' ' + proof.findings[0].table;
  };
  const std::string id = "x'" + hex_of(whole) + "'", other = "x'" + hex_of(thinned) + "'";
  EXPECT_EQ(first_of(thinned, {}), "intact");
  EXPECT_EQ(first_of(whole, {"DELETE FROM trace_chunks WHERE session = " + id}), "row_missing trace_chunks");
  EXPECT_EQ(first_of(thinned, {"DELETE FROM thinned_traces"}), "row_missing trace_chunks");
  EXPECT_EQ(first_of(whole, {"DELETE FROM trace_chunks WHERE session = " + id, "DELETE FROM key_states WHERE session = " + id,
                             "UPDATE thinned_traces SET session = " + id}),
            "row_changed thinned_traces") << "the row of another attempt";
  EXPECT_EQ(first_of(whole, {"UPDATE thinned_traces SET session = " + id}), "row_changed thinned_traces");
  EXPECT_EQ(first_of(thinned, {"INSERT INTO trace_chunks SELECT " + other + ", row, first_tick, inputs, elapsed_us, state_hash, trace "
                               "FROM trace_chunks WHERE session = " + id}),
            "row_added thinned_traces") << "a recording slipped in";
  for (const char* column : {"at = at + 1", "author = zeroblob(16)", "station = zeroblob(16)", "links = links - 1", "link = zeroblob(32)",
                             "signature = zeroblob(64)"}) {
    EXPECT_EQ(first_of(thinned, {std::string("UPDATE thinned_traces SET ") + column}), "row_changed thinned_traces") << column;
  }
  EXPECT_EQ(first_of(thinned, {"UPDATE thinned_traces SET key = zeroblob(32)"}), "key_changed thinned_traces");
  EXPECT_EQ(first_of(thinned, {"UPDATE metrics SET force_peak_n = 0 WHERE session = " + other}), "row_changed metrics") << "the rest is covered";
}

}  // namespace
}  // namespace cusp::test
