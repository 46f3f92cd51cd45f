/// The counter beside the key, the seals of an old file, and what happens when either cannot be written.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>

#include "storage/records/rollback_counter.h"
#include "tests/modules.h"
#include "tests/source_dir.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

class RollbackTest : public ::testing::Test {
 protected:
  fs::path counter() const { return folder / "a.db.key-counter"; }
  static std::vector<FindingCode> codes(Store& store) {
    std::vector<FindingCode> out;
    for (const ChainFinding& f : must(verify_store(store.context())).findings) out.push_back(f.code);
    return out;
  }
  static std::uint64_t counted(const fs::path& file) { return must(read_counter(file))->log.links; }
  static std::uint64_t logged(Store& store) { return must(verify_store(store.context())).entries; }

  Folder folder;
};

TEST_F(RollbackTest, the_counter_follows_each_entry_of_the_log) {
  const auto store = open(folder / "a.db");
  EXPECT_EQ(counted(counter()), logged(*store));
  const Account student = make_student(*store);
  complete_session(*store, student, keep(*store));
  EXPECT_EQ(counted(counter()), logged(*store));
  EXPECT_EQ(fs::status(counter()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_TRUE(codes(*store).empty());
}

TEST_F(RollbackTest, of_two_stores_on_one_file_the_larger_count_stays) {
  const auto one = open(folder / "a.db"), two = open(folder / "a.db");
  const Account student = make_student(*one);
  for (int i = 0; i < 5; ++i) {
    must((i % 2 == 0 ? one : two)->accounts.set_pin({UserId{}, Role::administrator}, student.id, "271828"));
    EXPECT_EQ(counted(counter()), logged(*one));
  }
  EXPECT_TRUE(codes(*two).empty());
}

TEST_F(RollbackTest, a_counter_that_cannot_be_written_fails_no_session_and_catches_up_later) {
  const auto store = open(folder / "a.db");
  const Account student = make_student(*store);
  const ScenarioVersion version = keep(*store);
  const std::uint64_t before = counted(counter());
  fs::create_directory(counter().string() + ".new");  // where the next one would be written
  const SessionId session = complete_session(*store, student, version);
  EXPECT_EQ(must(store->sessions.state(session)), SessionState::graded);
  ASSERT_TRUE(store->context().counter_failure);
  EXPECT_EQ(store->context().counter_failure->where, counter().string());
  EXPECT_EQ(counted(counter()), before);
  const auto lagging = must(verify_store(store->context()));
  EXPECT_TRUE(lagging.intact());
  EXPECT_EQ(lagging.uncounted, 3u);  // started, finished, graded
  fs::remove(counter().string() + ".new");
  must(store->accounts.sign_in("20267314", "battery staple"));
  EXPECT_FALSE(store->context().counter_failure);
  EXPECT_EQ(counted(counter()), logged(*store));
}

TEST_F(RollbackTest, a_pipe_or_a_locked_file_in_the_place_of_the_next_counter_is_replaced_and_stops_no_write) {
  const auto store = open(folder / "a.db");
  const std::string next = counter().string() + ".new";
  ASSERT_EQ(::mkfifo(next.c_str(), 0600), 0);
  make_student(*store);
  EXPECT_FALSE(store->context().counter_failure);
  EXPECT_EQ(counted(counter()), logged(*store));
  std::ofstream(next) << "left by a process that died";
  fs::permissions(next, fs::perms::none);
  make_student(*store, "20260002", "Omar Haddad");
  EXPECT_FALSE(store->context().counter_failure);
  EXPECT_EQ(counted(counter()), logged(*store));
}

TEST_F(RollbackTest, a_process_that_died_between_commit_and_counter_leaves_it_behind_and_never_ahead) {
  std::string early;
  {
    const auto store = open(folder / "a.db");
    std::ifstream in(counter());
    early.assign(std::istreambuf_iterator<char>(in), {});
    complete_session(*store, make_student(*store), keep(*store));
  }
  std::ofstream(counter()) << early;
  const auto store = open(folder / "a.db");
  EXPECT_FALSE(store->context().incident);
  EXPECT_EQ(counted(counter()), logged(*store));
  EXPECT_TRUE(codes(*store).empty());
}

TEST_F(RollbackTest, an_older_file_is_named_at_opening_and_for_good) {
  const fs::path file = folder / "a.db";
  {
    const auto store = open(file);
    make_student(*store);
    must(store->database().run("PRAGMA wal_checkpoint(TRUNCATE)"));
    fs::copy_file(file, folder / "old.db");
    complete_session(*store, must(store->accounts.find_number("20267314")), keep(*store));
  }
  fs::copy_file(folder / "old.db", file, fs::copy_options::overwrite_existing);
  StoreOptions reading = quick();
  reading.database.access = DatabaseOptions::Access::read_only;
  EXPECT_EQ(open(file, reading)->context().incident, "rolled_back");
  EXPECT_EQ(open(file)->context().incident, "rolled_back");
  // Work goes on; the entry stays, however often the file is opened.
  for (int i = 0; i < 3; ++i) {
    const auto store = open(file);
    EXPECT_FALSE(store->context().incident);
    must(store->accounts.sign_in("20267314", "battery staple"));
    EXPECT_EQ(codes(*store), std::vector{FindingCode::rolled_back});
  }
}

TEST_F(RollbackTest, the_counter_is_checked_with_the_key_that_signed_it_after_a_new_key) {
  const fs::path file = folder / "a.db", elsewhere = folder / "stick.key";
  { make_student(*open(file)); }
  fs::remove(folder / "a.db.key");
  EXPECT_TRUE(codes(*open(file)).empty());  // a new key, the old counter
  fs::rename(folder / "a.db.key", elsewhere);
  fs::rename(counter(), elsewhere.string() + "-counter");
  StoreOptions options = quick();
  options.key_file = elsewhere;
  EXPECT_TRUE(codes(*open(file, options)).empty());
  // The key alone was moved: the counter is missed.
  fs::remove(elsewhere.string() + "-counter");
  EXPECT_EQ(codes(*open(file, options)), std::vector{FindingCode::counter_missing});
}

TEST_F(RollbackTest, a_new_database_under_the_name_of_an_old_one_begins_anew) {
  { make_student(*open(folder / "a.db")); }
  for (const char* part : {"", "-wal", "-shm"}) fs::remove(folder / (std::string("a.db") + part));
  EXPECT_TRUE(codes(*open(folder / "a.db")).empty());
}

TEST_F(RollbackTest, a_database_that_lost_every_byte_is_damaged_and_is_not_begun_anew) {
  const fs::path file = folder / "a.db";
  { make_student(*open(file)); }
  const std::uint64_t before = counted(counter());
  fs::resize_file(file, 0);
  EXPECT_EQ(code_of(Store::open(file, quick())), StorageError::corrupt);
  EXPECT_EQ(fs::file_size(file), 0u);
  EXPECT_EQ(counted(counter()), before);
  fs::remove(folder / "a.db.key");  // then the counter is of no station here
  EXPECT_TRUE(codes(*open(file)).empty());
}

/// A file of before seals: what it held is sealed at the first opening for writing, and held against that.
TEST_F(RollbackTest, a_file_of_schema_1_is_sealed_when_it_is_first_opened_for_writing) {
  const fs::path file = folder / "a.db";
  {
    auto db = must(Database::open(file, {.migrations = built_in_migrations().first(1)}));
    std::ifstream in(source_dir() / "tests/storage/fixtures/schema-0001.sql");
    std::ostringstream sql;
    sql << in.rdbuf();
    must(db.script(sql.str()));
  }
  StoreOptions reading = quick();
  reading.database.access = DatabaseOptions::Access::read_only;
  const auto unsealed = must(verify_store(open(file, reading)->context()));
  EXPECT_TRUE(unsealed.intact());
  EXPECT_FALSE(unsealed.sealed_since_utc_us);

  auto store = open(file);
  auto proof = must(verify_store(store->context()));
  EXPECT_TRUE(proof.intact());
  EXPECT_EQ(proof.sealed_since_utc_us, kNow);
  EXPECT_EQ(proof.sealed_later, 8u);  // three accounts, a session, a comment, a cohort, an assignment, a version
  const Account lena = must(store->accounts.find_number("20267314"));
  must(store->database().run("PRAGMA foreign_keys = OFF"));
  must(store->database().run("UPDATE people SET password = '' WHERE id = ?1", lena.id));
  proof = must(verify_store(store->context()));
  ASSERT_EQ(proof.findings.size(), 1u);
  EXPECT_EQ(proof.findings[0].table, "people");
  EXPECT_EQ(proof.findings[0].owner, lena.id.uuid);
  EXPECT_EQ(proof.findings[0].what, "password");
  EXPECT_EQ(proof.findings[0].at_utc_us, kNow);
}

TEST_F(RollbackTest, a_role_set_by_sql_stays_named_after_the_program_has_sealed_the_account_again) {
  const auto store = open(folder / "a.db");
  const Actor admin = make_administrator(*store).actor();
  const Account student = make_student(*store);
  must(store->database().run("UPDATE people SET role = 'administrator', pin = '' WHERE id = ?1", student.id));
  must(store->accounts.disable(admin, student.id));
  must(store->accounts.set_password(admin, student.id, "", "another password"));
  const auto proof = must(verify_store(store->context()));
  ASSERT_EQ(proof.findings.size(), 2u);
  EXPECT_EQ(proof.findings[0].what, "role");
  EXPECT_EQ(proof.findings[1].what, "PIN");
  for (const ChainFinding& f : proof.findings) EXPECT_EQ(f.owner, student.id.uuid);
}

TEST_F(RollbackTest, what_the_program_itself_does_to_an_account_is_no_finding) {
  const auto store = open(folder / "a.db");
  const Actor admin = make_administrator(*store).actor();
  const Account student = make_student(*store);
  must(store->accounts.set_pin(admin, student.id, "271828"));
  must(store->accounts.disable(admin, student.id));
  must(store->accounts.rename(admin, student.id, "4", "Lena Meier"));
  must(store->accounts.enable(admin, student.id));
  must(store->accounts.set_role(admin, student.id, Role::instructor));
  must(store->accounts.set_password(admin, student.id, "", "another password"));
  must(store->accounts.set_role(admin, student.id, Role::student));
  EXPECT_TRUE(codes(*store).empty());
}

TEST_F(RollbackTest, no_name_and_no_number_enters_the_log) {
  const auto store = open(folder / "a.db");
  const Account student = make_student(*store);
  must(store->accounts.rename({UserId{}, Role::administrator}, student.id, "20267315", "Lena Brandt-Meier"));
  const auto details = must(store->database().all("SELECT detail FROM audit_log", [](Row row) { return row.text(0); }));
  for (const std::string& detail : details) {
    for (const char* name : {"Lena", "Brandt", "2026731"}) EXPECT_EQ(detail.find(name), std::string::npos) << detail;
  }
}

}  // namespace
}  // namespace cusp::test
