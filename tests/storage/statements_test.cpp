/// Statements about a session: what each changes of the result that counts, who may make it, and that all stay.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <numeric>
#include <random>

#include "storage/records/session_summary.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

struct StatementsTest : ::testing::Test {
  Folder folder;
  std::unique_ptr<Store> store = open(folder / "a.db");
  Actor administrator = make_administrator(*store).actor();
  Actor instructor = make_instructor(*store).actor();
  Account lena = make_student(*store);
  ScenarioVersion version = keep(*store);

  Statements& statements() { return store->statements; }
  HistoryRow row_of(SessionId session) { return must(store->history.details(instructor, session)).row; }
  EffectiveGrade counts(SessionId session) { return *must(store->history.details(instructor, session)).grade; }
  void expect_whole() {
    const auto whole = must(verify_store(store->context()));
    EXPECT_TRUE(whole.intact()) << (whole.findings.empty() ? "" : whole.findings[0].table + " " + whole.findings[0].what);
  }
};

TEST_F(StatementsTest, a_comment_has_a_moment_and_a_place_and_stays_outside_the_chain) {
  const SessionId id = complete_session(*store, lena, version);
  must(statements().comment(instructor, id, "From here you finish the floor well.", {.tick = 24, .place_mm = Vec3(1, 2, 3)}));
  must(statements().comment(instructor, id, "Better."));
  EXPECT_EQ(code_of(statements().comment(lena.actor(), id, "x")), StorageError::not_allowed);
  EXPECT_EQ(code_of(statements().comment(administrator, id, "x")), StorageError::not_allowed);
  EXPECT_EQ(code_of(statements().comment(instructor, id, "")), StorageError::bad_value);
  EXPECT_EQ(code_of(statements().comment(instructor, id, std::string(kMostStatementText + 1, 'x'))), StorageError::bad_value);
  std::string longest;
  for (std::size_t i = 0; i < kMostStatementText; ++i) longest += "\xC3\xBC";
  EXPECT_EQ(code_of(statements().comment(instructor, id, longest + '.')), StorageError::bad_value);
  must(statements().comment(instructor, id, longest));
  const auto comments = must(store->comments.of(id));
  ASSERT_EQ(comments.size(), 3u);
  EXPECT_EQ(comments[0].tick, 24u);
  EXPECT_EQ(comments[0].place_mm, Vec3(1, 2, 3));
  EXPECT_FALSE(comments[1].tick);
  expect_whole();
}

TEST_F(StatementsTest, a_comment_of_an_older_program_stands_before_the_new_ones) {
  const SessionId id = complete_session(*store, lena, version);
  must(statements().comment(instructor, id, "New."));
  add_comment_row(*store, instructor, id, "Old.");
  const auto comments = must(store->comments.of(id));
  ASSERT_EQ(comments.size(), 2u);
  EXPECT_EQ(comments[0].text, "Old.");
  EXPECT_EQ(comments[0].tick, 12u);
}

TEST_F(StatementsTest, nobody_decides_about_an_own_attempt_after_a_change_of_role) {
  const SessionId id = complete_session(*store, lena, version, 68);
  const Uuid changed = must(statements().override_points(instructor, id, "target_removed", 5, "Not cut.")).id;
  must(store->accounts.set_role(administrator, lena.id, Role::instructor));
  const Actor own{lena.id, Role::instructor};
  for (const auto& refused : {statements().override_points(own, id, "target_removed", 20, "Worn."), statements().confirm(own, id),
                              statements().release(own, id), statements().withdraw(own, id, changed, "Unfair.")}) {
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().where, "own_attempt");
  }
  must(statements().comment(own, id, "I slipped here."));
  must(statements().withdraw(instructor, id, changed, "Looked again."));
  expect_whole();
}

TEST_F(StatementsTest, an_override_counts_in_grade_list_and_figures_and_the_stored_grade_stays) {
  const SessionId id = complete_session(*store, lena, version, 68);
  must(statements().override_points(instructor, id, "target_removed", 20, "The block was worn."));
  const EffectiveGrade now = counts(id);
  EXPECT_EQ(now.grade.score, 70);
  EXPECT_TRUE(now.grade.passed);
  EXPECT_EQ(now.grade.criteria[0].points, 20);
  EXPECT_EQ(now.stored.grade.score, 68);
  ASSERT_EQ(now.overrides.size(), 1u);
  EXPECT_EQ(now.overrides[0].text, "The block was worn.");
  EXPECT_EQ(row_of(id).score, 70);
  EXPECT_EQ(row_of(id).passed, true);
  EXPECT_EQ(must(store->history.figures(instructor)).median_score, 70);
  expect_whole();
}

/// Greatest points of seven criteria, of 100, and the points of each in tenths, drawn so that they sum to `sum`.
constexpr std::array<int, 7> kMost = {14, 14, 14, 14, 14, 15, 15};
std::vector<int> tenths_that_sum_to(int sum, std::mt19937& random) {
  while (true) {
    std::vector<int> out;
    for (const int most : kMost) out.push_back(std::uniform_int_distribution<int>(0, 10 * most)(random));
    const int missing = sum - std::accumulate(out.begin(), out.end() - 1, 0);
    if (missing < 0 || missing > 10 * kMost.back()) continue;
    out.back() = missing;
    return out;
  }
}

/// As the grader leaves it: the criteria sum to the score.
Grade seven_criteria(std::mt19937& random) {
  Grade grade;
  for (std::size_t i = 0; i < kMost.size(); ++i) {
    CriterionGrade c;
    c.id = c.measure.metric = "width_" + std::to_string(i);
    c.points_max = kMost[i];
    c.points = c.points_max * std::uniform_real_distribution<double>(0.0, 1.0)(random);
    c.reason_code = "too_little";
    grade.score += c.points;
    grade.criteria.push_back(c);
  }
  return grade;
}

TEST(EffectiveGrades, overrides_that_sum_to_the_mark_pass_in_every_order_and_a_tenth_less_fails) {
  std::mt19937 random(20261120);
  for (int round = 0; round < 2000; ++round) {
    const int sum = round % 2 == 0 ? 700 : 699;
    const std::vector<int> tenths = tenths_that_sum_to(sum, random);
    StoredGrade stored;
    stored.grade = seven_criteria(random);
    std::vector<std::size_t> order(kMost.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::shuffle(order, random);
    std::vector<SignedStatement> statements;
    for (const std::size_t i : order) {
      SignedStatement s{.sequence = static_cast<std::int64_t>(statements.size()), .kind = StatementKind::override_points};
      s.grade = stored.number;
      s.criterion = stored.grade.criteria[i].id;
      s.points = tenths[i] / 10.0;
      statements.push_back(s);
    }
    const auto counts = effective_grade({stored}, statements);
    ASSERT_TRUE(counts);
    EXPECT_EQ(counts->grade.passed, sum == 700) << "round " << round << ", score " << counts->grade.score;
    EXPECT_NEAR(counts->grade.score, sum / 10.0, 1e-12) << "measured: 1.5e-14";
  }
}

TEST_F(StatementsTest, seven_overrides_that_sum_to_the_mark_pass_in_grade_and_list) {
  std::mt19937 random(7);
  const SessionId id = complete_session(*store, lena, version, 68);
  Grade stored = seven_criteria(random);
  // Adding the seven changes one by one gives 69.99999999999999.
  constexpr std::array kBefore = {10.3, 11.2, 8.3, 6.6, 12.9, 2.7, 12.2};
  for (std::size_t i = 0; i < kBefore.size(); ++i) stored.criteria[i].points = kBefore[i];
  stored.score = std::accumulate(kBefore.begin(), kBefore.end(), 0.0);
  must(store->grades.save(id, stored, {}, instructor));
  for (const auto& [criterion, points] : std::vector<std::pair<int, double>>{{3, 9.7}, {0, 10.1}, {6, 11.3}, {1, 8.9}, {5, 12.6}, {2, 7.3}, {4, 10.1}}) {
    must(statements().override_points(instructor, id, "width_" + std::to_string(criterion), points, "Seen on the tooth."));
  }
  EXPECT_TRUE(counts(id).grade.passed) << counts(id).grade.score;
  EXPECT_NEAR(*row_of(id).score, 70, 1e-12);
  EXPECT_EQ(row_of(id).passed, true);
  expect_whole();
}

TEST(EffectiveGrades, an_override_of_a_weight_moves_the_score_by_its_share) {
  StoredGrade stored;
  stored.grade.evaluator = "2";
  for (const auto& [id, points] : {std::pair{"width_0", 0.5}, std::pair{"width_1", 1.0}, std::pair{"width_2", 0.5}, std::pair{"width_3", 0.4}}) {
    CriterionGrade c;
    c.id = id;
    c.points = points;
    c.points_max = 1;
    stored.grade.criteria.push_back(c);
  }
  stored.grade.score = 60;  // 2.4 of 4
  SignedStatement s{.kind = StatementKind::override_points};
  s.grade = stored.number;
  s.criterion = "width_0";
  s.points = 1;
  const auto counts = effective_grade({stored}, {s});
  ASSERT_TRUE(counts);
  EXPECT_NEAR(counts->grade.score, 72.5, 1e-12) << "2.9 of 4";
  EXPECT_TRUE(counts->grade.passed);
  for (CriterionGrade& c : stored.grade.criteria) c.points = 0;
  stored.grade.score = 0;
  EXPECT_NEAR(effective_grade({stored}, {s})->grade.score, 25, 1e-12) << "from nothing";
}

TEST_F(StatementsTest, of_two_overrides_of_a_criterion_the_later_counts_and_a_withdrawal_brings_back_the_earlier) {
  const SessionId id = complete_session(*store, lena, version, 68);
  must(statements().override_points(instructor, id, "target_removed", 20, "Worn."));
  const SignedStatement second = must(statements().override_points(instructor, id, "target_removed", 10, "Looked again."));
  EXPECT_EQ(row_of(id).score, 60);
  must(statements().withdraw(instructor, id, second.id, "The first was right."));
  EXPECT_EQ(row_of(id).score, 70);
  EXPECT_EQ(code_of(statements().withdraw(instructor, id, second.id, "Twice.")), StorageError::not_found);
  EXPECT_EQ(must(statements().of(instructor, id)).size(), 3u);
  expect_whole();
}

TEST_F(StatementsTest, a_critical_event_that_does_not_count_lets_the_points_decide) {
  const SessionId id = complete_session(*store, lena, version, 80, false);
  EXPECT_EQ(row_of(id).passed, false);
  must(statements().override_critical(instructor, id, "pulp_exposure", "It was open before."));
  EXPECT_EQ(row_of(id).passed, true);
  EXPECT_TRUE(row_of(id).critical.empty());
  EXPECT_EQ(code_of(statements().override_critical(instructor, id, "pulp_exposure", "Again.")), StorageError::bad_value);
  expect_whole();
}

TEST_F(StatementsTest, an_override_needs_a_right_a_reason_a_criterion_of_the_grade_and_points_within_it) {
  const SessionId id = complete_session(*store, lena, version);
  const auto code = [&](const Actor& actor, const char* criterion, double points, const char* reason) {
    return code_of(statements().override_points(actor, id, criterion, points, reason));
  };
  EXPECT_EQ(code(lena.actor(), "target_removed", 1, "x"), StorageError::not_allowed);
  EXPECT_EQ(code(administrator, "target_removed", 1, "x"), StorageError::not_allowed);
  EXPECT_EQ(code(instructor, "target_removed", 1, ""), StorageError::bad_value);
  EXPECT_EQ(code(instructor, "colour", 1, "x"), StorageError::bad_value);
  EXPECT_EQ(code(instructor, "target_removed", 20.5, "x"), StorageError::bad_value);
  EXPECT_EQ(code(instructor, "target_removed", -1, "x"), StorageError::bad_value);
  EXPECT_EQ(code(instructor, "target_removed", std::nan(""), "x"), StorageError::bad_value);
  EXPECT_TRUE(must(statements().of(instructor, id)).empty());
}

TEST_F(StatementsTest, a_newer_grade_ends_the_overrides_of_the_one_before) {
  const SessionId id = complete_session(*store, lena, version, 68);
  must(statements().override_points(instructor, id, "target_removed", 20, "Worn."));
  must(store->grades.save(id, small_grade(62, false), {}, instructor));
  EXPECT_EQ(row_of(id).score, 62);
  EXPECT_TRUE(counts(id).overrides.empty());
  expect_whole();
}

TEST_F(StatementsTest, a_confirmation_covers_the_result_as_it_stood) {
  const SessionId id = complete_session(*store, lena, version, 50, false);
  EXPECT_TRUE(counts(id).needs_confirmation());
  must(statements().confirm(instructor, id));
  EXPECT_FALSE(counts(id).needs_confirmation());
  const SignedStatement fewer = must(statements().override_points(instructor, id, "target_removed", 0, "Not cut."));
  EXPECT_TRUE(counts(id).needs_confirmation());
  must(statements().confirm(instructor, id));
  EXPECT_FALSE(counts(id).needs_confirmation());
  must(statements().withdraw(instructor, id, fewer.id, "It was."));
  EXPECT_TRUE(counts(id).needs_confirmation());
}

TEST_F(StatementsTest, a_result_that_another_desk_changed_after_it_was_read_is_not_confirmed) {
  const SessionId id = complete_session(*store, lena, version, 50, false);
  const Hash256 read = shown_hash(counts(id).grade);
  must(open(folder / "a.db")->statements.override_points(instructor, id, "target_removed", 0, "Not cut."));
  const auto late = statements().confirm(instructor, id, read);
  ASSERT_EQ(code_of(late), StorageError::wrong_state);
  EXPECT_EQ(late.error().where, "changed");
  EXPECT_TRUE(counts(id).needs_confirmation());
  must(statements().confirm(instructor, id, shown_hash(counts(id).grade)));
  EXPECT_FALSE(counts(id).needs_confirmation());
}

TEST_F(StatementsTest, a_change_of_a_result_that_another_desk_changed_after_it_was_read_is_refused) {
  const SessionId id = complete_session(*store, lena, version, 80, false);
  const Hash256 read = shown_hash(counts(id).grade);
  must(open(folder / "a.db")->statements.override_points(instructor, id, "target_removed", 5, "Not cut."));
  const auto points = statements().override_points(instructor, id, "target_removed", 20, "Worn.", read);
  const auto event = statements().override_critical(instructor, id, "pulp_exposure", "It was open before.", read);
  for (const auto& late : {points, event}) {
    ASSERT_EQ(code_of(late), StorageError::wrong_state);
    EXPECT_EQ(late.error().where, "changed");
  }
  EXPECT_EQ(must(statements().of(instructor, id)).size(), 1u) << "that of the other desk counts";
  must(statements().override_critical(instructor, id, "pulp_exposure", "It was open before.", shown_hash(counts(id).grade)));
  must(statements().override_points(instructor, id, "target_removed", 20, "Worn.", shown_hash(counts(id).grade)));
  EXPECT_TRUE(counts(id).grade.passed);
}

TEST_F(StatementsTest, a_confirmation_is_of_the_result_that_it_kept_and_that_of_an_older_program_of_its_score) {
  StoredGrade stored;
  stored.grade = small_grade(50, false);
  SignedStatement made;
  made.id = Uuid::v7();
  made.kind = StatementKind::confirmation;
  made.grade = stored.number;
  made.points = 50;
  const auto counts_for = [&] { return effective_grade({stored}, {made})->confirmation.has_value(); };
  EXPECT_TRUE(counts_for());
  made.shown = shown_hash(small_grade(50, true));
  EXPECT_FALSE(counts_for());
  made.shown = shown_hash(stored.grade);
  EXPECT_TRUE(counts_for());
  stored.grade.criteria.front().points -= 1;
  EXPECT_FALSE(counts_for());
}

TEST_F(StatementsTest, nothing_is_stated_of_a_running_or_unknown_session_nor_of_a_missing_grade) {
  const SessionId running = must(store->sessions.start(lena.actor(), new_session(lena, version))).id;
  EXPECT_EQ(code_of(statements().comment(instructor, running, "x")), StorageError::wrong_state);
  must(store->traces.append(running, second_from(1)));
  must(store->sessions.finish(running, volume_after(12), "student"));
  must(statements().comment(instructor, running, "x"));
  EXPECT_EQ(code_of(statements().confirm(instructor, running)), StorageError::wrong_state);
  EXPECT_EQ(code_of(statements().comment(instructor, SessionId::make(), "x")), StorageError::not_found);
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(StatementsTest, erasing_a_student_leaves_no_name_and_no_text_in_the_file_and_all_records_whole) {
  const Account gone = must(store->accounts.create(administrator, {.number = "X-4711-X", .name = "Quentin Zaphod", .pin = "271828"}));
  const Cohort cohort = must(store->cohorts.create(instructor, "Year 2"));
  must(store->cohorts.add(instructor, cohort.id, gone.id));
  const SessionId id = complete_session(*store, gone, version, 68);
  must(statements().override_points(instructor, id, "target_removed", 20, "Quentin said it was worn."));
  add_comment_row(*store, instructor, id, "Quentin, well done.");
  EXPECT_EQ(code_of(store->accounts.erase(instructor, gone.id)), StorageError::not_allowed);
  EXPECT_EQ(store->accounts.erase(administrator, administrator.id).error().where, "own_account");
  const SessionId running = must(store->sessions.start(gone.actor(), new_session(gone, version))).id;
  EXPECT_EQ(store->accounts.erase(administrator, gone.id).error().where, "running");
  must(store->sessions.interrupt(running, "left"));

  must(store->accounts.erase(administrator, gone.id));
  expect_whole();
  EXPECT_EQ(row_of(id).score, 70) << "the result stays, with its override";
  EXPECT_TRUE(must(store->cohorts.students(cohort.id)).empty());
  EXPECT_TRUE(must(statements().of(instructor, id)).front().text.empty());
  EXPECT_EQ(code_of(store->accounts.sign_in_with_pin("X-4711-X", "271828")), StorageError::wrong_password);
  store.reset();
  for (const char* trace : {"Quentin", "Zaphod", "X-4711-X"}) {
    EXPECT_EQ(bytes_of(folder / "a.db").find(trace), std::string::npos) << trace;
    EXPECT_EQ(bytes_of(folder / "a.db-wal").find(trace), std::string::npos) << trace;
  }
}

TEST_F(StatementsTest, who_was_erased_at_another_window_while_the_attempt_is_marked_gets_no_text) {
  const SessionId id = complete_session(*store, lena, version, 68);
  const SignedStatement worn = must(statements().override_points(instructor, id, "target_removed", 20, "Worn."));
  must(open(folder / "a.db")->accounts.erase(administrator, lena.id));
  EXPECT_EQ(statements().comment(instructor, id, "Lena did well.").error().where, "people");
  EXPECT_EQ(code_of(statements().override_points(instructor, id, "target_removed", 19, "Lena was late.")), StorageError::not_found);
  EXPECT_EQ(code_of(statements().withdraw(instructor, id, worn.id, "It was Lena's.")), StorageError::not_found);
  must(statements().confirm(instructor, id));
  EXPECT_EQ(*must(store->database().first("SELECT count(*) FROM statement_texts", [](Row row) { return row.integer(0); })), 0);
  EXPECT_EQ(row_of(id).score, 70);
  expect_whole();
}

TEST_F(StatementsTest, a_text_that_is_taken_out_by_hand_is_no_erasure) {
  const SessionId id = complete_session(*store, lena, version);
  must(statements().comment(instructor, id, "Well done."));
  must(store->database().run("DELETE FROM statement_texts"));
  EXPECT_FALSE(must(verify_store(store->context())).intact());
}

/// Each change by hand is named, whichever column it touches.
TEST_F(StatementsTest, a_changed_statement_text_or_key_is_found) {
  const SessionId id = complete_session(*store, lena, version);
  must(statements().comment(instructor, id, "Well done."));
  struct Change {
    const char* sql;
    const char* table;
    FindingCode code;
  };
  for (const Change& change :
       {Change{"UPDATE statements SET kind = 'confirmation'", "statements", FindingCode::row_changed},
        Change{"UPDATE statements SET key = zeroblob(32)", "statements", FindingCode::key_changed},
        Change{"UPDATE statements SET points = 3", "statements", FindingCode::row_changed},
        Change{"UPDATE statement_texts SET text = 'Badly done.'", "statement_texts", FindingCode::row_changed},
        Change{"DELETE FROM statement_texts", "statement_texts", FindingCode::row_missing}}) {
    must(store->database().run("PRAGMA foreign_keys = OFF"));
    must(store->database().run("SAVEPOINT trial"));
    must(store->database().run(change.sql));
    const auto findings = must(check_statements(store->database()));
    ASSERT_FALSE(findings.empty()) << change.sql;
    EXPECT_EQ(findings[0].code, change.code) << change.sql;
    EXPECT_EQ(findings[0].table, change.table) << change.sql;
    EXPECT_EQ(findings[0].owner, id.uuid);
    must(store->database().run("ROLLBACK TO trial"));
    must(store->database().run("RELEASE trial"));
  }
  expect_whole();
}

}  // namespace
}  // namespace cusp::test
