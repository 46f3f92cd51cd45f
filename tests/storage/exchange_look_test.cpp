/// What of a file or a key is seen before it changes anything.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "storage/exchange/exchange_file.h"
#include "tests/storage/failing_vfs.h"
#include "tests/storage/two_stations.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

using LookTest = TwoStations;

TEST_F(LookTest, a_look_says_whose_a_file_is_and_what_it_carries_and_changes_nothing) {
  must(trust(office->context(), chief, must(public_key_from(must(own_key(station->context(), keeper)))), KeyRole::station));
  complete_session(*station, make_student(*station, "2", "Omar"), keep(*station), 81.5);
  const fs::path early = results(), file = results();
  const auto before = shared_records(*office);
  const ExchangeLook look = must(look_into(office->context(), chief, file));
  EXPECT_EQ(look.role, KeyRole::station);
  EXPECT_EQ(key_id(look.signer.bytes), station->context().key->id());
  EXPECT_EQ(look.counts.sessions, 1u);
  EXPECT_EQ(look.counts.accounts, 0u) << "known by reference alone";
  EXPECT_EQ(look.newest_read, 0u);
  EXPECT_EQ(shared_records(*office), before);
  must(read_in(office->context(), chief, file));
  EXPECT_EQ(must(look_into(office->context(), chief, early)).newest_read, 2u);
  const auto read = must(files_read_in(office->context(), chief));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read.front().number, 2u);
  const auto stranger = open(folder / "stranger.db");
  EXPECT_EQ(must(look_into(stranger->context(), make_administrator(*stranger, "x").actor(), file)).role, std::nullopt);
  EXPECT_EQ(code_of(look_into(station->context(), keeper, file)), StorageError::not_allowed) << "its own";
}

/// The file after `sql`, signed anew by its station.
void sign_after(const char* sql, const fs::path& file, StorageContext& context) {
  auto db = must(Database::open(file));
  must(db.run(sql));
  ExchangeDescription description = must(read_description(db)).description;
  must(db.run("DROP TABLE exchange_description"));
  WorkSteps unwatched{WorkWatch{}};
  description.tables = must(table_hashes(db, unwatched));
  must(add_description(db, sign_exchange(*context.key, description)));
  must(db.run("PRAGMA journal_mode = DELETE"));
}

TEST_F(LookTest, a_file_that_was_cut_off_is_no_damage_of_the_records) {
  must(trust(office->context(), chief, key_of_station(*station), KeyRole::station));
  complete_session(*station, make_student(*station, "2", "Omar"), keep(*station), 81.5);
  const fs::path file = results();
  const auto size = fs::file_size(file);
  for (const auto left : {size - 1, size / 2, size / 4, std::uintmax_t{5000}, std::uintmax_t{100}}) {
    fs::resize_file(file, left);
    const auto look = look_into(office->context(), chief, file);
    ASSERT_EQ(code_of(look), StorageError::cut_short) << left;
    EXPECT_EQ(look.error().detail, std::to_string(left) + ' ' + std::to_string(size));
    EXPECT_EQ(code_of(read_in(office->context(), chief, file)), StorageError::cut_short) << left;
  }
}

/// The header alone decides: the disk need not hold the rest.
TEST_F(LookTest, a_file_above_4_gb_that_was_cut_off_there_is_refused_by_its_header) {
  const fs::path file = results();
  constexpr std::uint32_t kPages = 700'000;  // of 8,192 bytes: 5.7 GB
  {
    std::fstream bytes(file, std::ios::binary | std::ios::in | std::ios::out);
    bytes.seekp(28);
    for (int shift = 24; shift >= 0; shift -= 8) bytes.put(static_cast<char>(kPages >> shift & 0xFF));
  }
  constexpr std::uintmax_t kMostOfFat32 = 0xFFFFFFFF;
  fs::resize_file(file, kMostOfFat32);  // the file system keeps a hole
  const auto look = look_into(office->context(), chief, file);
  ASSERT_EQ(code_of(look), StorageError::cut_short);
  EXPECT_EQ(look.error().detail, "4294967295 5734400000");
}

TEST_F(LookTest, a_file_of_an_older_program_is_read_where_it_lies_and_not_from_a_copy_in_memory) {
  const fs::path file = results();
  sign_after("PRAGMA user_version = 17", file, station->context());
  EXPECT_EQ(must(open_exchange(file)).schema_version(), 17);
  EXPECT_EQ(must(Database::open(file, {.access = DatabaseOptions::Access::read_only})).schema_version(), 18) << "as of records";
}

TEST_F(LookTest, a_file_of_an_older_program_is_called_by_that_name) {
  must(trust(office->context(), chief, key_of_station(*station), KeyRole::office));
  const Actor instructor = make_instructor(*station).actor();
  Assignment task{.version = keep(*station).id, .cohort = must(station->cohorts.create(instructor, "Year 2")).id};
  must(station->assignments.create(instructor, task));
  const fs::path file = next_file();
  must(give_out(station->context(), keeper, ExchangeKind::office, file));
  sign_after("PRAGMA user_version = 17", file, station->context());  // what a program of the schema before would have given out
  EXPECT_EQ(code_of(look_into(office->context(), chief, file)), StorageError::older_schema);
  EXPECT_EQ(code_of(read_in(office->context(), chief, file)), StorageError::older_schema);
}

TEST_F(LookTest, a_file_that_is_replaced_after_its_check_changes_nothing) {
  StoreOptions options = quick();
  options.database.vfs = failing_vfs();
  fail_from(Failing::nothing, 0);
  const auto desk = open(folder / "desk.db", options);
  const Actor boss = make_administrator(*desk, "boss").actor();
  must(trust(desk->context(), boss, key_of_station(*station), KeyRole::station));
  complete_session(*station, make_student(*station, "2", "Omar"), keep(*station), 81.5);
  const fs::path file = results(), changed = folder / "changed";
  fs::copy_file(file, changed);
  {
    auto db = must(Database::open(changed));
    must(db.run("UPDATE grades SET score = 100"));
    must(db.run("PRAGMA journal_mode = DELETE"));
  }
  int opened = 0;  // by the records: for the schema, then for what they read
  at_opening([&](std::string_view path) {
    if (path.ends_with('/' + file.filename().string()) && ++opened == 2) fs::rename(changed, file);
  });
  const auto read = read_in(desk->context(), boss, file);
  at_opening({});
  EXPECT_EQ(opened, 2);
  EXPECT_EQ(code_of(read), StorageError::not_exchange);
  EXPECT_EQ(must(desk->database().first("SELECT count(*) FROM sessions", [](Row row) { return row.integer(0); })), 0);
}

TEST_F(LookTest, a_file_after_a_hundred_thousand_others_has_its_number) {
  const fs::path file = results();
  auto db = must(Database::open(file));
  ExchangeDescription description = must(read_description(db)).description;
  ASSERT_TRUE(description.earlier.empty());
  for (int n = 0; n < 100'000; ++n) description.earlier.push_back(blake2b_256(std::string_view(std::to_string(n))));
  must(db.run("DROP TABLE exchange_description"));
  must(add_description(db, sign_exchange(*station->context().key, description)));
  const CheckedExchange read = must(read_description(db));
  EXPECT_EQ(read.description.number(), 100'001u);
  EXPECT_EQ(read.description.earlier, description.earlier);
  EXPECT_EQ(read.description.log.link, description.log.link);
}

TEST_F(LookTest, a_description_that_nests_four_million_deep_is_refused) {
  for (const char* key : {"log", "tables"}) {
    const fs::path file = results();
    const std::string deep = std::string("{\"") + key + "\":" + std::string(4'000'000, '[') + std::string(4'000'000, ']') + '}';
    {
      auto db = must(Database::open(file));
      must(db.run("UPDATE exchange_description SET description = ?1", deep));
      must(db.run("PRAGMA journal_mode = DELETE"));
    }
    EXPECT_EQ(code_of(look_into(office->context(), chief, file)), StorageError::not_exchange) << key;
  }
}

TEST_F(LookTest, a_table_column_or_index_that_the_records_lack_is_refused_though_it_is_signed) {
  must(trust(office->context(), chief, key_of_station(*station), KeyRole::station));
  complete_session(*station, make_student(*station, "2", "Omar"), keep(*station), 81.5);
  // Read as "SELECT * FROM NAME", the first is a query of its own.
  for (const char* sql : {"CREATE TABLE \"(SELECT 1)\" (a)", "CREATE TABLE more (a)",
                          "ALTER TABLE people ADD COLUMN more TEXT AS (hex(name))", "CREATE INDEX more ON people (hex(name))"}) {
    const fs::path file = results();
    sign_after(sql, file, station->context());
    EXPECT_EQ(code_of(look_into(office->context(), chief, file)), StorageError::not_exchange) << sql;
    EXPECT_EQ(code_of(read_in(office->context(), chief, file)), StorageError::not_exchange) << sql;
  }
  must(read_in(office->context(), chief, results()));
}

TEST_F(LookTest, a_results_file_brings_no_account_version_or_withdrawal_though_it_is_signed) {
  must(trust(office->context(), chief, key_of_station(*station), KeyRole::station));
  complete_session(*station, make_student(*station, "2", "Omar"), keep(*station), 81.5);
  for (const char* sql : {"DELETE FROM referred WHERE id IN (SELECT id FROM people)", "DELETE FROM referred WHERE id IN (SELECT id FROM scenario_versions)",
                          "INSERT INTO version_withdrawals SELECT id, author, published_at, 1 FROM scenario_versions"}) {
    const fs::path file = results();
    sign_after(sql, file, station->context());
    const auto look = look_into(office->context(), chief, file);
    const auto read = read_in(office->context(), chief, file);
    ASSERT_EQ(code_of(look), StorageError::not_allowed) << sql;
    ASSERT_EQ(code_of(read), StorageError::not_allowed) << sql;
    EXPECT_EQ(read.error().where, "office_file");
  }
  EXPECT_FALSE(office->accounts.find_number("2"));
  must(read_in(office->context(), chief, results()));
}

TEST_F(LookTest, an_erased_account_of_a_results_file_signs_nobody_in_whatever_the_file_says_of_it) {
  must(trust(office->context(), chief, key_of_station(*station), KeyRole::station));
  const Account nora = make_student(*station, "3001", "Nora Lind");
  complete_session(*station, nora, keep(*station), 81.5);
  must(read_in(office->context(), chief, results()));
  must(station->accounts.erase(keeper, nora.id));
  const fs::path file = results();
  sign_after("UPDATE people SET name = 'Nora Lind', role = 'administrator', password = 'x', disabled = 0 WHERE number LIKE 'erased %'", file, station->context());
  must(read_in(office->context(), chief, file));
  const Account here = must(office->accounts.find(nora.id));
  EXPECT_EQ(here.name, "–");
  EXPECT_FALSE(here.has_password);
  EXPECT_TRUE(here.disabled);
  EXPECT_EQ(whole(*office), "");
}

TEST_F(LookTest, a_station_erases_nobody_of_whom_another_one_has_records_though_it_signs_so) {
  const auto other = open(folder / "other.db");
  const Actor stranger = make_administrator(*other, "x").actor();
  for (Store* store : {station.get(), other.get()}) must(trust(office->context(), chief, key_of_station(*store), KeyRole::station));
  const Account nora = make_student(*station, "3001", "Nora Lind");
  const SessionId session = complete_session(*station, nora, keep(*station), 81.5);
  must(read_in(office->context(), chief, results()));
  must(office->statements.comment(make_instructor(*office).actor(), session, "Nora, well done."));
  const fs::path file = next_file();
  must(give_out(other->context(), stranger, ExchangeKind::results, file));
  std::string id = nora.id.text();
  std::erase(id, '-');
  const std::string person = "INSERT INTO people VALUES (X'" + id + "', 'erased " + nora.id.text() + "', '–', 'student', '', '', 1, 0, 0, 0, 0)";
  const std::string reference = "INSERT INTO referred (id, here) VALUES (X'" + id + "', 0)";
  for (const std::string& sql : {person, reference}) sign_after(sql.c_str(), file, other->context());
  must(read_in(office->context(), chief, file));
  EXPECT_EQ(must(office->accounts.find(nora.id)).name, "Nora Lind");
  EXPECT_EQ(must(office->statements.of(chief, session)).front().text, "Nora, well done.");
  must(station->accounts.erase(keeper, nora.id));
  must(read_in(office->context(), chief, results()));
  EXPECT_EQ(must(office->accounts.find(nora.id)).name, "–") << "her own station";
  EXPECT_EQ(whole(*office), "");
}

TEST_F(LookTest, a_number_that_leaves_none_for_this_station_is_refused) {
  must(trust(office->context(), chief, key_of_station(*station), KeyRole::station));
  complete_session(*station, make_student(*station, "2", "Omar"), keep(*station), 81.5);
  const fs::path file = results();
  sign_after("UPDATE scenario_versions SET sequence = 9223372036854775000", file, station->context());
  EXPECT_EQ(code_of(read_in(office->context(), chief, file)), StorageError::differs);
  must(office->accounts.sign_in("admin", "correct horse"));
  must(read_in(office->context(), chief, results()));
}

TEST_F(LookTest, a_key_file_holds_the_key_whole_or_is_refused) {
  const SignedText key = must(own_key(station->context(), keeper));
  const auto written = [&](const std::string& text) {
    const fs::path file = next_file();
    std::ofstream(file) << text;
    return file;
  };
  EXPECT_EQ(must(public_key_in(written(key_file_of(key)))).bytes, must(public_key_from(key)).bytes);
  EXPECT_EQ(code_of(public_key_in(written("no key"))), StorageError::bad_value);
  EXPECT_EQ(code_of(public_key_in(written(key_file_of(key).substr(1)))), StorageError::bad_value);
  EXPECT_EQ(code_of(public_key_in(folder / "nothing")), StorageError::not_found);
  const fs::path pipe = next_file();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(code_of(public_key_in(pipe)), StorageError::bad_value) << "it waits for nobody";
  EXPECT_EQ(code_of(public_key_in(pipe.parent_path())), StorageError::bad_value);
}

}  // namespace
}  // namespace cusp::test
