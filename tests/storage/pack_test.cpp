/// Appeal packs: the records of one attempt as a database of their own, and what the station signs about them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <thread>

#include "storage/exchange/exchange.h"
#include "storage/exchange/pack.h"
#include "storage/exchange/session_extract.h"
#include "storage/exchange/unnamed_copies.h"
#include "storage/records/statement_rows.h"
#include "tests/refused_calls.h"
#include "tests/storage/killed.h"
#include "tests/storage/sample.h"
#include "tests/storage/statements_seen.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

struct PackTest : ::testing::Test {
  Folder folder;
  std::unique_ptr<Store> store = open(folder / "a.db");
  Actor administrator = make_administrator(*store).actor();
  Actor instructor = make_instructor(*store).actor();
  Account lena = make_student(*store), omar = make_student(*store, "20260002", "Omar Haddad");
  ScenarioVersion version = keep(*store);
  SessionId session{};
  Assignment exam{};

  void SetUp() override {
    const CohortId cohort = must(store->cohorts.create(instructor, "Year 2")).id;
    must(store->cohorts.add(instructor, cohort, lena.id));
    exam = {.version = version.id, .cohort = cohort, .kind = SessionKind::assessment};
    exam = must(store->assignments.create(instructor, exam, "4711"));
    NewSession wanted = new_session(lena, version);
    wanted.assignment = exam.id;
    wanted.start_code = "4711";
    session = must(store->sessions.start(lena.actor(), wanted)).id;
    must(store->traces.append(session, second_from(1)));
  }
  void hand_in() {
    must(store->sessions.finish(session, volume_after(12), "student"));
    must(store->grades.save(session, small_grade(41, false), {}));
    must(store->statements.assess_own(lena.actor(), session, {{{"target_removed", OwnRating::partly}}}));
    must(store->statements.override_points(instructor, session, "target_removed", 20, "The block was worn."));
    must(store->statements.confirm(instructor, session));
    complete_session(*store, omar, version);
  }
  fs::path file() { return folder / "records.db"; }
  void extract(StudentNamed named = StudentNamed::by_candidate_number) {
    must(extract_session(store->context(), administrator, session, named, file()));
  }
  std::unique_ptr<Store> opened() {
    StoreOptions options = quick();
    options.database.access = DatabaseOptions::Access::read_only;
    return open(file(), options);
  }
  static std::string bytes_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::string bytes() { return bytes_of(file()); }
  fs::path pack() { return folder / "case.cusppack"; }
  Stored<void> give_out_as(const Actor& actor, std::string_view content) { return give_out_pack(store->context(), actor, session, content, pack()); }
  /// Entries about packs, oldest first.
  std::vector<AuditEntry> packed() {
    std::vector<AuditEntry> out;
    for (const AuditEntry& entry : must(log_about(store->context(), administrator, session)))
      if (entry.action == "packed") out.push_back(entry);
    return out;
  }
};

TEST_F(PackTest, an_extract_opens_alone_verifies_and_shows_the_same_result) {
  hand_in();
  extract();
  EXPECT_FALSE(fs::exists(file().string() + "-wal")) << "one file";
  const auto alone = opened();
  EXPECT_FALSE(alone->context().incident);
  EXPECT_EQ(alone->context().station, store->context().station);
  EXPECT_TRUE(must(verify_session(alone->context(), session)).intact());
  EXPECT_TRUE(must(check_statements(alone->database())).empty());
  const auto here = must(store->history.details(instructor, session)), there = must(alone->history.details(instructor, session));
  EXPECT_EQ(there.row.score, here.row.score);
  EXPECT_EQ(there.grade->grade.score, here.grade->grade.score);
  EXPECT_EQ(must(alone->statements.of(instructor, session)).size(), 3u);
  EXPECT_EQ(must(alone->statements.self_assessment(instructor, session)), (SelfAssessment{{{"target_removed", OwnRating::partly}}}));
  EXPECT_EQ(must(alone->traces.inputs(session)).size(), 12u);
  EXPECT_EQ(must(alone->assignments.find(exam.id)).kind, SessionKind::assessment);
}

TEST_F(PackTest, an_extract_holds_nothing_of_anybody_else_no_secret_and_the_name_only_if_asked) {
  hand_in();
  extract();
  const std::string hidden = bytes();
  for (const char* no : {"Omar Haddad", "Lena Brandt", "20267314", "$argon2", "4711"}) EXPECT_EQ(hidden.find(no), std::string::npos) << no;
  const auto alone = opened();
  EXPECT_EQ(must(alone->accounts.find(lena.id)).number, candidate_number(exam.id, lena.id));
  EXPECT_EQ(must(sessions_to_verify(alone->context())).size(), 1u);
  fs::remove(file());
  extract(StudentNamed::by_name);
  EXPECT_EQ(must(opened()->accounts.find(lena.id)).name, "Lena Brandt");
}

TEST_F(PackTest, a_byte_changed_in_an_extract_is_found) {
  hand_in();
  extract();
  {
    auto changed = must(Database::open(file()));
    must(changed.run("UPDATE grades SET score = 95"));
    must(changed.run("UPDATE statements SET points = 21 WHERE kind = 'override_points'"));
  }
  const auto alone = opened();
  EXPECT_FALSE(must(verify_session(alone->context(), session)).intact());
  EXPECT_EQ(must(check_statements(alone->database())).size(), 1u);
}

TEST_F(PackTest, an_extract_needs_the_right_an_ended_session_and_a_new_file) {
  EXPECT_EQ(code_of(extract_session(store->context(), administrator, session, StudentNamed::by_name, file())), StorageError::wrong_state);
  hand_in();
  EXPECT_EQ(code_of(extract_session(store->context(), lena.actor(), session, StudentNamed::by_name, file())), StorageError::not_allowed);
  EXPECT_EQ(code_of(extract_session(store->context(), administrator, SessionId{Uuid::v7()}, StudentNamed::by_name, file())), StorageError::not_found);
  EXPECT_EQ(code_of(extract_session(store->context(), administrator, session, StudentNamed::by_name, folder / "none" / "r.db")), StorageError::not_found);
  EXPECT_FALSE(fs::exists(file()));
  extract();
  const std::string before = bytes();
  EXPECT_EQ(code_of(extract_session(store->context(), administrator, session, StudentNamed::by_name, file())), StorageError::duplicate);
  EXPECT_EQ(bytes(), before);
}

TEST_F(PackTest, an_attempt_that_is_taken_up_again_meanwhile_gives_no_extract) {
  must(store->sessions.interrupt(session, "process_gone"));
  const StatementsSeen seen;
  std::optional<Stored<void>> resumed;
  StatementsSeen::at_each([&](std::string_view sql) {
    if (sql.starts_with("ATTACH") && !resumed) resumed = store->sessions.resume(session, "student");
  });
  const auto extracted = extract_session(store->context(), administrator, session, StudentNamed::by_name, file());
  ASSERT_TRUE(resumed) << "between the question and the copy";
  must(*resumed);
  ASSERT_EQ(code_of(extracted), StorageError::wrong_state);
  EXPECT_EQ(extracted.error().where, "session");
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(PackTest, records_that_cannot_be_written_give_no_extract_for_they_sign_none) {
  hand_in();
  store.reset();
  StoreOptions options = quick();
  options.database.access = DatabaseOptions::Access::read_only;
  store = open(folder / "a.db", options);
  store->database().set_unwritable({StorageError::disk_full, "a.db"});
  EXPECT_EQ(code_of(extract_session(store->context(), administrator, session, StudentNamed::by_name, file())), StorageError::disk_full);
  EXPECT_FALSE(fs::exists(file()));
}

TEST_F(PackTest, the_log_about_an_attempt_names_who_assigned_stated_and_packed_it) {
  hand_in();
  EXPECT_EQ(code_of(log_about(store->context(), lena.actor(), session)), StorageError::not_allowed);
  must(give_out_as(administrator, "a pack"));
  const auto entries = must(log_about(store->context(), administrator, session));
  const auto has = [&](std::string_view action) { return std::ranges::any_of(entries, [&](const AuditEntry& e) { return e.action == action; }); };
  for (const char* action : {"version_kept", "assigned", "session_sealed", "stated", "packed"}) EXPECT_TRUE(has(action)) << action;
  EXPECT_FALSE(has("account_created"));
  EXPECT_EQ(std::ranges::count(entries, "session_sealed", &AuditEntry::action), 3);
  EXPECT_TRUE(std::ranges::is_sorted(entries, {}, &AuditEntry::number));
}

TEST_F(PackTest, the_log_about_an_attempt_is_read_along_indexes_and_leaves_out_one_of_the_same_moment) {
  hand_in();
  Uuid same_moment = session.uuid;
  same_moment.bytes.back() ^= std::uint8_t{1};
  must(store->audit.add({.action = "session_sealed", .subject = same_moment, .detail = "started 2"}));
  const StatementsSeen seen;
  const auto again = open(folder / "a.db");
  const auto entries = must(log_about(again->context(), administrator, session));
  EXPECT_EQ(std::ranges::count(entries, "session_sealed", &AuditEntry::action), 3);
  std::string plans;
  for (const std::string& sql : StatementsSeen::texts()) {
    if (sql.find("INDEXED BY seals_of_session") == std::string::npos) continue;
    for (const std::string& line : plan_of(again->database(), sql)) plans += line + '\n';
  }
  for (const char* search : {"audit_by_subject (subject=?)", "seals_of_session (<expr>=?)"}) EXPECT_NE(plans.find(search), std::string::npos) << plans;
  EXPECT_EQ(plans.find("SCAN audit_log"), std::string::npos) << plans;
}

TEST_F(PackTest, a_signature_holds_for_the_description_it_was_made_for_alone) {
  hand_in();
  const std::vector<PackFile> files = {{"records.db", blake2b_256("one")}, {"report.pdf", blake2b_256("two")}};
  EXPECT_EQ(code_of(sign_pack(store->context(), lena.actor(), session, files)), StorageError::not_allowed);
  const SignedPack signed_pack = must(sign_pack(store->context(), administrator, session, files));
  const CheckedPack checked = must(check_pack(signed_pack));
  EXPECT_TRUE(checked.signature_holds);
  EXPECT_EQ(checked.description.session, session);
  EXPECT_EQ(checked.description.maker, administrator.id);
  ASSERT_EQ(checked.description.files.size(), 2u);
  EXPECT_EQ(checked.description.files[1].hash, files[1].hash);
  EXPECT_EQ(must(signer_of(store->context(), checked)), PackSigner::this_station);
  const auto other = open(folder / "b.db");
  EXPECT_EQ(must(signer_of(other->context(), checked)), PackSigner::other_station);
  for (std::size_t i = 0; i < signed_pack.description.size(); ++i) {
    SignedPack changed = signed_pack;
    changed.description[i] ^= 1;
    const auto result = check_pack(changed);
    EXPECT_FALSE(result && result->signature_holds) << i;
  }
}

TEST_F(PackTest, who_was_switched_off_at_another_window_since_signing_in_signs_none) {
  hand_in();
  must(open(folder / "a.db")->accounts.disable(administrator, instructor.id));
  const std::int64_t newest = must(store->audit.list(administrator, 1)).at(0).number;
  EXPECT_EQ(code_of(sign_pack(store->context(), instructor, session, {})), StorageError::disabled);
  EXPECT_EQ(code_of(give_out_as(instructor, "a pack")), StorageError::disabled);
  EXPECT_EQ(must(store->audit.list(administrator, 1)).at(0).number, newest) << "and no entry says so";
  must(store->accounts.enable(administrator, instructor.id));
  must(sign_pack(store->context(), instructor, session, {}));
  must(open(folder / "a.db")->accounts.set_role(administrator, instructor.id, Role::student));
  EXPECT_EQ(code_of(sign_pack(store->context(), instructor, session, {})), StorageError::not_allowed);
  EXPECT_EQ(code_of(give_out_as(instructor, "a pack")), StorageError::not_allowed);
  EXPECT_FALSE(fs::exists(pack()));
}

TEST_F(PackTest, a_signature_alone_enters_no_log_for_its_file_may_never_be_written) {
  hand_in();
  const std::int64_t newest = must(store->audit.list(administrator, 1)).at(0).number;
  must(sign_pack(store->context(), administrator, session, {}));
  EXPECT_EQ(must(store->audit.list(administrator, 1)).at(0).number, newest);
  EXPECT_EQ(code_of(give_out_as(lena.actor(), "a pack")), StorageError::not_allowed);
  EXPECT_EQ(must(store->audit.list(administrator, 1)).at(0).number, newest);
}

TEST_F(PackTest, a_pack_is_a_new_file_that_the_log_names_by_its_hash) {
  hand_in();
  must(give_out_as(administrator, "a pack"));
  EXPECT_EQ(bytes_of(pack()), "a pack");
  ASSERT_EQ(packed().size(), 1u);
  EXPECT_EQ(packed()[0].actor, administrator.id);
  EXPECT_EQ(packed()[0].subject, session.uuid);
  EXPECT_EQ(packed()[0].detail, hex(blake2b_256("a pack")));
  std::ofstream(folder / "any other");
  EXPECT_EQ(mode_of(pack()), mode_of(folder / "any other")) << "whoever receives it may read it";
  const auto again = give_out_as(administrator, "a later pack");
  ASSERT_EQ(code_of(again), StorageError::duplicate);
  EXPECT_EQ(again.error().detail, "");
  EXPECT_EQ(bytes_of(pack()), "a pack");
  EXPECT_EQ(packed().size(), 1u);
}

TEST_F(PackTest, a_pack_that_the_disk_has_no_room_for_is_not_logged) {
  hand_in();
  Stored<void> done;
  bool refused = false;
  std::thread([&] {
    refused = refuse_calls({{SYS_fsync, ENOSPC}});
    if (refused) done = give_out_as(administrator, "a pack");
  }).join();
  if (!refused) GTEST_SKIP() << "the kernel admits no filter of system calls";
  ASSERT_EQ(code_of(done), StorageError::disk_full);
  EXPECT_EQ(done.error().where, pack().string());
  EXPECT_EQ(done.error().detail, std::strerror(ENOSPC));
  EXPECT_FALSE(fs::exists(pack()));
  EXPECT_TRUE(packed().empty());
}

/// A program that is killed after it has logged a pack and before the file has its name.
struct PackingKilled : PackTest {
  /// False where the kernel admits no filter.
  bool is_killed() {
    hand_in();
    store.reset();
    const Killed killed = kill_after(2, 0, [&](const std::function<bool()>& step) {
      store = open(folder / "a.db");
      refuse_calls(links_refused(kKills));
      static_cast<void>(give_out_as(administrator, "the killed pack"));
      static_cast<void>(step());
    });
    store = open(folder / "a.db");
    return killed.by_signal && killed.steps == 0;
  }
  /// Folders in which a file is made.
  std::vector<fs::path> copies() {
    std::vector<fs::path> out;
    for (const fs::directory_entry& entry : fs::directory_iterator(pack().parent_path()))
      if (entry.path().filename().string().starts_with(kCopying)) out.push_back(entry.path());
    return out;
  }
};

TEST_F(PackingKilled, is_finished_by_the_next_pack_of_that_name_which_names_that) {
  if (!is_killed()) GTEST_SKIP() << "the kernel admits no filter of system calls";
  ASSERT_FALSE(fs::exists(pack()));
  ASSERT_EQ(packed().size(), 1u);
  const auto again = give_out_as(administrator, "a later pack");
  ASSERT_EQ(code_of(again), StorageError::duplicate);
  EXPECT_EQ(again.error().detail, "finished");
  EXPECT_EQ(again.error().where, "case.cusppack");
  EXPECT_EQ(bytes_of(pack()), "the killed pack");
  EXPECT_EQ(packed().size(), 1u) << "the log names each file once";
  EXPECT_TRUE(copies().empty());
}

TEST_F(PackingKilled, is_finished_by_the_next_file_for_other_stations_in_its_folder) {
  if (!is_killed()) GTEST_SKIP() << "the kernel admits no filter of system calls";
  must(give_out(store->context(), administrator, ExchangeKind::results, folder / "results"));
  EXPECT_EQ(bytes_of(pack()), "the killed pack");
  EXPECT_TRUE(copies().empty());
}

TEST_F(PackingKilled, is_read_by_nobody_under_a_second_name_for_that_may_be_a_database) {
  if (!is_killed()) GTEST_SKIP() << "the kernel admits no filter of system calls";
  ASSERT_EQ(copies().size(), 1u);
  fs::create_hard_link(copies()[0] / kCopied, folder / "second");
  must(give_out(store->context(), administrator, ExchangeKind::results, folder / "results"));
  EXPECT_FALSE(fs::exists(pack()));
  fs::remove(folder / "second");
  EXPECT_EQ(code_of(give_out_as(administrator, "a later pack")), StorageError::duplicate);
  EXPECT_EQ(bytes_of(pack()), "the killed pack");
}

TEST_F(PackingKilled, is_named_by_nobody_once_its_bytes_were_changed) {
  if (!is_killed()) GTEST_SKIP() << "the kernel admits no filter of system calls";
  ASSERT_EQ(copies().size(), 1u);
  std::ofstream(copies()[0] / kCopied, std::ios::app) << "x";
  must(give_out(store->context(), administrator, ExchangeKind::results, folder / "results"));
  EXPECT_FALSE(fs::exists(pack()));
}

TEST_F(PackTest, texts_that_are_no_description_or_signature_are_refused) {
  const SignedPack good = must(sign_pack(store->context(), administrator, session, {{"a", blake2b_256("a")}}));
  for (const char* text : {"", "{}", "[]", "null", "{\"cusp_pack\":1}", "{\"cusp_pack\":2}"}) EXPECT_EQ(code_of(check_pack({text, good.signature})), StorageError::bad_value) << text;
  for (const std::string& text : {std::string(), std::string("key x"), good.signature + "x", std::string(good.signature.size(), '0')})
    EXPECT_EQ(code_of(check_pack({good.description, text})), StorageError::bad_value) << text;
  for (std::size_t cut = 0; cut < good.description.size(); cut += 7) {
    SignedPack half = good;
    half.description.resize(cut);
    EXPECT_EQ(code_of(check_pack(half)), StorageError::bad_value) << cut;
  }
}

}  // namespace
}  // namespace cusp::test
