#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <fstream>

#include "storage/sqlite/migrate.h"
#include "tests/modules.h"
#include "tests/storage/failing_vfs.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;
using Access = DatabaseOptions::Access;

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
void write(const fs::path& file, const std::string& content) { std::ofstream(file, std::ios::binary) << content; }

std::string pragma(Database& db, const char* name) {
  return must(db.first(std::string("PRAGMA ") + name, [](Row row) { return row.text(0); })).value_or("");
}

TEST(Opening, a_new_file_has_the_settings_that_keep_it_safe) {
  const Folder folder;
  auto db = must(Database::open(folder / "new.db"));
  EXPECT_EQ(pragma(db, "application_id"), std::to_string(kApplicationId));
  EXPECT_EQ(pragma(db, "page_size"), "8192");
  EXPECT_EQ(pragma(db, "journal_mode"), "wal");
  EXPECT_EQ(pragma(db, "synchronous"), "2");  // FULL
  EXPECT_EQ(pragma(db, "foreign_keys"), "1");
  EXPECT_EQ(pragma(db, "secure_delete"), "1");
  EXPECT_EQ(db.schema_version(), static_cast<int>(built_in_migrations().size()));
  EXPECT_EQ(must(db.integrity_check()), "");
}

TEST(Opening, a_new_file_with_its_log_and_index_is_readable_by_its_owner_alone_and_a_file_that_is_there_keeps_its_mode) {
  const Folder folder;
  const Umask usual(022);
  {
    const auto store = open(folder / "a.db");
    make_student(*store);
    for (const char* part : {"", "-wal", "-shm", ".key", ".key-counter"}) EXPECT_EQ(mode_of((folder / "a.db").string() + part), 0600u) << part;
  }
  fs::permissions(folder / "a.db", fs::perms::group_read, fs::perm_options::add);
  write(folder / "empty.db", "");
  fs::permissions(folder / "empty.db", fs::perms{0644});
  const auto again = open(folder / "a.db"), filled = open(folder / "empty.db");
  EXPECT_EQ(mode_of(folder / "a.db"), 0640u);
  EXPECT_EQ(mode_of(folder / "empty.db"), 0644u);
}

TEST(Opening, every_table_is_strict) {
  const Folder folder;
  auto db = must(Database::open(folder / "new.db"));
  const auto not_strict =
      must(db.all("SELECT name FROM pragma_table_list WHERE schema = 'main' AND NOT strict AND name <> 'sqlite_schema'",
                  [](Row row) { return row.text(0); }));
  EXPECT_TRUE(not_strict.empty()) << not_strict.front();
}

TEST(Opening, a_trigger_or_view_of_a_file_is_not_run) {
  const Folder folder;
  const auto name = [](Row row) { return row.text(0); };
  auto db = must(Database::open(folder / "a.db"));
  must(db.run("CREATE TRIGGER more AFTER INSERT ON cohorts BEGIN UPDATE cohorts SET name = 'other'; END"));
  must(db.run("CREATE VIEW names AS SELECT name FROM cohorts"));
  must(db.run("INSERT INTO cohorts VALUES (?1, 'Year 2', 1)", Uuid::v7()));
  EXPECT_EQ(must(db.first("SELECT name FROM cohorts", name)), std::optional<std::string>("Year 2"));
  EXPECT_FALSE(db.first("SELECT name FROM names", name));
}

TEST(Opening, what_was_written_is_there_again) {
  const Folder folder;
  SessionId session;
  {
    const auto store = open(folder / "a.db");
    session = complete_session(*store, make_student(*store), keep(*store));
  }
  const auto store = open(folder / "a.db");
  EXPECT_TRUE(must(verify_session(store->context(), session)).intact());
}

TEST(Opening, a_file_of_a_newer_schema_is_refused_and_left_alone) {
  const Folder folder;
  {
    auto db = must(Database::open(folder / "a.db"));
    must(db.run("PRAGMA user_version = 900"));
  }
  const std::string before = content_of(folder / "a.db");
  EXPECT_EQ(code_of(Database::open(folder / "a.db")), StorageError::newer_schema);
  EXPECT_EQ(content_of(folder / "a.db"), before);
  EXPECT_FALSE(fs::exists((folder / "a.db").string() + "-wal"));
}

TEST(Opening, a_newer_schema_that_stands_only_in_the_log_is_refused_too) {
  const Folder folder;
  auto open_elsewhere = must(Database::open(folder / "a.db"));
  must(open_elsewhere.run("PRAGMA user_version = 900"));
  EXPECT_EQ(code_of(Database::open(folder / "a.db")), StorageError::newer_schema);
}

TEST(Opening, files_that_are_not_a_database_are_refused_and_left_alone) {
  const Folder folder;
  for (const std::string& content :
       {std::string("hello"), std::string(5000, 'x'), std::string("SQLite format 3\0", 16)}) {
    write(folder / "letter.txt", content);
    EXPECT_EQ(code_of(Database::open(folder / "letter.txt")), StorageError::not_a_database) << content.size();
    EXPECT_EQ(content_of(folder / "letter.txt"), content);
  }
  fs::create_directory(folder / "folder");
  EXPECT_EQ(code_of(Database::open(folder / "folder")), StorageError::not_a_database);
}

TEST(Opening, waits_for_no_pipe_in_the_place_of_a_log_or_journal) {
  const Folder folder;
  must(Database::open(folder / "a.db"));
  for (const char* ending : {"-wal", "-shm", "-journal"}) {
    const std::string pipe = (folder / "a.db").string() + ending;
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    for (const Access access : {Access::existing, Access::read_only})
      EXPECT_EQ(code_of(Database::open(folder / "a.db", {.access = access})), StorageError::io) << ending;
    fs::remove(pipe);
  }
}

TEST(Opening, the_database_of_another_program_is_refused_and_left_alone) {
  const Folder folder;
  {
    auto db = must(Database::open(folder / "other.db"));
    must(db.run("PRAGMA application_id = 252006673"));  // GeoPackage's
  }
  const std::string before = content_of(folder / "other.db");
  EXPECT_EQ(code_of(Database::open(folder / "other.db")), StorageError::not_a_database);
  EXPECT_EQ(code_of(Database::open(folder / "other.db", {.access = Access::read_only})), StorageError::not_a_database);
  EXPECT_EQ(content_of(folder / "other.db"), before);
}

TEST(Opening, an_empty_file_becomes_a_database) {
  const Folder folder;
  write(folder / "empty.db", "");
  EXPECT_TRUE(Database::open(folder / "empty.db"));
}

TEST(Opening, a_file_whose_maker_ended_before_its_first_table_is_named_empty_to_a_reader_and_becomes_a_database) {
  const Folder folder;
  constexpr std::array<std::string_view, 1> fails = {"this is no statement"};
  EXPECT_FALSE(Database::open(folder / "begun.db", {.migrations = fails}));
  ASSERT_GT(fs::file_size(folder / "begun.db"), 0u);
  write(folder / "empty.db", "");
  for (const char* name : {"begun.db", "empty.db"}) {
    for (const Access access : {Access::read_only, Access::existing}) {
      const auto refused = Database::open(folder / name, {.access = access});
      ASSERT_FALSE(refused);
      EXPECT_EQ(refused.error().code, StorageError::not_a_database);
      EXPECT_EQ(refused.error().detail, "empty") << name;
    }
    EXPECT_TRUE(Database::open(folder / name)) << name;
  }
}

TEST(Opening, makes_no_file_beside_the_log_of_records_that_were_moved_away_after_a_crash) {
  const Folder folder;
  const fs::path file = folder / "a.db", log = folder / "a.db-wal", moved = folder / "old.db";
  {
    const auto store = open(folder / "running.db");
    make_administrator(*store);
    for (const char* part : {"", "-wal", ".key", ".key-counter"}) fs::copy_file((folder / "running.db").string() + part, file.string() + part);
  }
  const std::string before = content_of(log);
  ASSERT_GT(before.size(), 8192u) << "what was written last stands there alone";
  fs::rename(file, moved);
  const auto refused = Store::open(file, quick());
  ASSERT_EQ(code_of(refused), StorageError::duplicate);
  EXPECT_EQ(refused.error().where, "a.db-wal");
  EXPECT_FALSE(fs::exists(file));
  EXPECT_EQ(content_of(log), before);
  fs::rename(moved, file);
  EXPECT_TRUE(must(open(file)->accounts.has_administrator()));
}

TEST(Opening, what_is_not_there_is_not_found) {
  const Folder folder;
  EXPECT_EQ(code_of(Database::open(folder / "none.db", {.access = Access::existing})), StorageError::not_found);
  EXPECT_EQ(code_of(Database::open(folder / "none.db", {.access = Access::read_only})), StorageError::not_found);
  EXPECT_EQ(code_of(Database::open(folder / "none" / "a.db")), StorageError::not_found);
  EXPECT_FALSE(fs::exists(folder / "none.db"));
}

TEST(Opening, a_name_without_a_folder_is_made_where_the_program_stands_and_a_link_leads_to_its_file) {
  const Folder folder;
  const fs::path before = fs::current_path();
  fs::current_path((folder / "a.db").parent_path());
  must(Database::open("a.db"));
  EXPECT_TRUE(Database::open("a.db", {.access = Access::existing}));
  EXPECT_TRUE(Database::open(":memory:"));
  EXPECT_TRUE(fs::exists(folder / ":memory:"));
  fs::current_path(before);
  fs::create_directory(folder / "elsewhere");
  fs::create_symlink(folder / "a.db", fs::path(folder / "elsewhere") / "link.db");
  auto first = must(Database::open(folder / "a.db"));
  must(first.run("PRAGMA user_version = 900"));  // in the log alone, which lies beside the file and not beside the link
  EXPECT_EQ(code_of(Database::open(fs::path(folder / "elsewhere") / "link.db")), StorageError::newer_schema);
}

TEST(Opening, a_place_where_no_file_can_be_made_is_refused_as_such) {
  if (!fs::is_directory("/proc")) GTEST_SKIP() << "no folder here admits no file to everybody";
  const auto refused = Database::open("/proc/cusp.db");  // "no such file" to SQLite, for root as for all others
  EXPECT_EQ(code_of(refused), StorageError::read_only);
  EXPECT_EQ(refused.error().detail, "new file");
  EXPECT_EQ(refused.error().where, "/proc/cusp.db");
}

TEST(Opening, a_network_drive_is_refused_before_anything_is_made) {
  const Folder folder;
  DatabaseOptions options;
  options.on_network_drive = [](const fs::path&) { return true; };
  EXPECT_EQ(code_of(Database::open(folder / "a.db", options)), StorageError::network_drive);
  EXPECT_FALSE(fs::exists(folder / "a.db"));
}

TEST(Opening, a_read_only_disk_and_a_full_one_give_different_failures) {
  const Folder folder;
  {
    must(Database::open(folder / "a.db"));
  }
  DatabaseOptions options;
  options.vfs = failing_vfs();
  fail_from(Failing::read_only, 0);
  EXPECT_EQ(code_of(Database::open(folder / "a.db", options)), StorageError::read_only);
  fail_from(Failing::disk_full, 1);
  EXPECT_EQ(code_of(Database::open(folder / "new.db", options)), StorageError::disk_full);
  EXPECT_FALSE(fs::exists(folder / "new.db"));
  fail_from(Failing::nothing, 0);
}

/// Gives up root's leave to write anywhere, where the test has it.
class AsNobody {
 public:
  AsNobody() : root_{geteuid() == 0} {
    if (root_ && seteuid(65534) != 0) root_ = false;
  }
  ~AsNobody() {
    if (root_ && seteuid(0) != 0) std::abort();
  }

 private:
  bool root_;
};

TEST(Opening, a_read_only_file_or_folder_is_refused_for_writing_and_read_all_the_same) {
  const Folder folder;
  SessionId session;
  {
    const auto store = open(folder / "a.db");
    session = complete_session(*store, make_student(*store), keep(*store));
  }
  const fs::path path = (folder / "a.db").parent_path();
  fs::permissions(folder / "a.db", fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read);
  // The group's too: nobody is still of root's group.
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::group_read | fs::perms::group_exec |
                            fs::perms::others_read | fs::perms::others_exec);
  {
    const AsNobody nobody;
    EXPECT_EQ(code_of(Store::open(folder / "a.db", quick())), StorageError::read_only);
    EXPECT_EQ(code_of(Store::open(folder / "new.db", quick())), StorageError::read_only);
    StoreOptions reading = quick();
    reading.database.access = Access::read_only;
    const auto store = open(folder / "a.db", reading);
    EXPECT_TRUE(must(verify_session(store->context(), session)).intact());
    EXPECT_EQ(code_of(store->sessions.close(session, "")), StorageError::read_only);
  }
  fs::permissions(path, fs::perms::owner_all);
}

TEST(Opening, a_write_to_a_file_that_is_open_for_reading_alone_fails_with_what_kept_it_so) {
  const Folder folder;
  {
    must(Database::open(folder / "a.db"));
  }
  auto db = must(Database::open(folder / "a.db", {.access = Access::read_only}));
  const auto failing_write = [&db] {
    Transaction transaction(db);
    transaction.run("DELETE FROM people");
    return code_of(transaction.commit());
  };
  EXPECT_EQ(failing_write(), StorageError::read_only);
  db.set_unwritable({StorageError::disk_full, "a.db"});
  EXPECT_EQ(failing_write(), StorageError::disk_full);
}

TEST(Opening, two_may_stand_on_one_file_and_see_each_others_work) {
  const Folder folder;
  const auto one = open(folder / "a.db");
  const auto two = open(folder / "a.db");
  const Account student = make_student(*one);
  EXPECT_EQ(must(two->accounts.find(student.id)).number, student.number);
  EXPECT_EQ(one->context().station, two->context().station);
  EXPECT_EQ(one->context().key->public_key, two->context().key->public_key);
}

TEST(StationKeys, the_secret_half_is_readable_by_its_owner_alone_and_not_in_the_database) {
  const Folder folder;
  std::string secret;
  {
    const auto store = open(folder / "a.db");
    const auto& key = store->context().key->secret_key;
    secret.assign(key.begin(), key.begin() + 32);  // the seed; the second half is the public key
  }
  const auto mode = fs::status(folder / "a.db.key").permissions();
  EXPECT_EQ(mode & (fs::perms::group_all | fs::perms::others_all), fs::perms::none);
  EXPECT_EQ(content_of(folder / "a.db").find(secret), std::string::npos);
}

TEST(StationKeys, where_the_key_is_lost_a_new_one_is_made_and_old_signatures_still_hold) {
  const Folder folder;
  SessionId old, fresh;
  {
    const auto store = open(folder / "a.db");
    old = complete_session(*store, make_student(*store), keep(*store));
  }
  fs::remove(folder / "a.db.key");
  const auto store = open(folder / "a.db");
  fresh = complete_session(*store, must(store->accounts.find_number("20267314")), keep(*store));
  EXPECT_TRUE(must(verify_session(store->context(), old)).intact());
  EXPECT_TRUE(must(verify_session(store->context(), fresh)).intact());
  EXPECT_TRUE(must(verify_audit_log(store->context())).intact());
}

TEST(StationKeys, a_link_to_a_database_leads_to_the_key_beside_the_file_itself) {
  const Folder folder;
  fs::create_directory(folder / "elsewhere");
  const fs::path file = folder / "a.db", link = fs::path(folder / "elsewhere") / "link.db";
  fs::create_symlink(file, link);
  Hash256 key{};
  {
    const auto store = open(link);  // makes the file that the link names
    key = store->context().key->id();
    make_student(*store);
  }
  for (const fs::path& name : {file, link}) {
    const auto store = open(name);
    EXPECT_EQ(store->context().key->id(), key) << name;
    EXPECT_FALSE(store->context().incident) << name;
    EXPECT_EQ(store->context().lock_file(), fs::canonical(file).string() + ".running");
    EXPECT_TRUE(must(verify_audit_log(store->context())).intact()) << name;
  }
  EXPECT_TRUE(fs::exists(folder / "a.db.key"));
  EXPECT_FALSE(fs::exists(link.string() + ".key"));
  EXPECT_FALSE(fs::exists(link.string() + ".key-counter"));
}

TEST(StationKeys, a_damaged_key_file_is_refused_and_not_replaced) {
  const Folder folder;
  {
    open(folder / "a.db");
  }
  std::string key = content_of(folder / "a.db.key");
  key[3] = static_cast<char>(key[3] ^ 1);
  write(folder / "a.db.key", key);
  EXPECT_EQ(code_of(Store::open(folder / "a.db", quick())), StorageError::corrupt);
  write(folder / "a.db.key", "short");
  EXPECT_EQ(Store::open(folder / "a.db", quick()).error().detail, "key");
  EXPECT_EQ(content_of(folder / "a.db.key"), "short");
}

TEST(Clocks, a_time_is_written_as_iso_8601) {
  // date -u -d @1795166043 +%FT%TZ
  EXPECT_EQ(iso_utc(kNow), "2026-11-20T09:14:03Z");
  EXPECT_EQ(iso_utc(-1), "1969-12-31T23:59:59Z");
}

TEST(Clocks, iso_8601_names_a_day_or_a_second) {
  constexpr std::int64_t kSecond = 1'000'000, kDay = 86'400 * kSecond;
  const auto second = utc_span_of("2026-11-20T09:14:03Z");
  ASSERT_TRUE(second);
  EXPECT_EQ(second->begin_utc_us, kNow);
  EXPECT_EQ(second->end_utc_us, kNow + kSecond);
  const auto day = utc_span_of("2026-11-20");
  ASSERT_TRUE(day);
  EXPECT_EQ(iso_utc(day->begin_utc_us), "2026-11-20T00:00:00Z");
  EXPECT_EQ(day->end_utc_us, day->begin_utc_us + kDay);
  EXPECT_EQ(utc_span_of("1970-01-01")->begin_utc_us, 0);
  EXPECT_EQ(utc_span_of("1969-12-31T23:59:59Z")->end_utc_us, 0);
  EXPECT_TRUE(utc_span_of("2028-02-29")) << "a leap year";
  for (const char* wrong : {"", "yesterday", "2026", "2026-11", "20.11.2026", "2026-11-20 ", "2026-11-20T09:14:03", "2026-11-20T09:14:03+01:00",
                            "2026-11-20T24:00:00Z", "2026-11-20T09:60:00Z", "2026-11-20T09:14:60Z", "2026-02-29", "2026-13-01", "2026-00-10",
                            "2026-11-31", "2026-11-00", "-026-11-20", "+026-11-20", "2026-11-2O"}) {
    EXPECT_FALSE(utc_span_of(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace cusp::test
