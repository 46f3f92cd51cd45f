/// Files between stations that report how far they are, and those that somebody stops.
#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/storage/two_stations.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// The station has ended three attempts, the office has four accounts.
struct StoppedExchange : TwoStations {
  using Steps = std::pair<std::size_t, std::size_t>;  // done, all
  std::vector<Steps> reported;

  void SetUp() override {
    trust_each_other();
    const Account omar = make_student(*station, "2", "Omar");
    for (int i = 0; i < 3; ++i) attempt(omar);
    for (const char* number : {"3", "4", "5"}) make_student(*office, number, "Ada Novak");
  }
  WorkWatch watch() {
    reported.clear();
    return [this](std::size_t done, std::size_t all) {
      if (all > 0 && (reported.empty() || reported.back() != Steps{done, all})) reported.emplace_back(done, all);
      return true;
    };
  }
  /// Stops as soon as so many steps are done, of those that are counted.
  static WorkWatch until(std::size_t steps) {
    return [steps](std::size_t done, std::size_t all) { return all == 0 || done < steps; };
  }
  static WorkWatch at_once() {
    return [](std::size_t, std::size_t) { return false; };
  }
  std::set<std::string> names() {
    std::set<std::string> out;
    for (const auto& entry : fs::directory_iterator((folder / "office.db").parent_path())) out.insert(entry.path().filename().string());
    return out;
  }
  static std::int64_t rows(Store& store, const std::string& table) {
    return must(store.database().first("SELECT count(*) FROM " + table, [](Row row) { return row.integer(0); })).value_or(-1);
  }
};

TEST_F(StoppedExchange, that_nobody_stops_ends_at_all_sessions_of_a_results_file) {
  const fs::path file = next_file();
  must(give_out(station->context(), keeper, ExchangeKind::results, file, watch()));
  EXPECT_EQ(reported, (std::vector<Steps>{{0, 3}, {1, 3}, {2, 3}, {3, 3}}));
  must(look_into(office->context(), chief, file, watch()));
  ASSERT_FALSE(reported.empty());
  EXPECT_EQ(reported.back(), (Steps{3, 3}));
  must(read_in(office->context(), chief, file, watch()));
  EXPECT_EQ(reported, (std::vector<Steps>{{0, 3}, {1, 3}, {2, 3}, {3, 3}}));
}

TEST_F(StoppedExchange, that_nobody_stops_ends_at_all_accounts_of_an_office_file) {
  const fs::path file = next_file();
  must(give_out(office->context(), chief, ExchangeKind::office, file, watch()));
  ASSERT_FALSE(reported.empty());
  EXPECT_EQ(reported.back(), (Steps{4, 4}));
  must(look_into(station->context(), keeper, file, watch()));
  ASSERT_FALSE(reported.empty());
  EXPECT_EQ(reported.back(), (Steps{4, 4}));
  must(read_in(station->context(), keeper, file, watch()));
  EXPECT_EQ(reported, (std::vector<Steps>{{0, 4}, {1, 4}, {2, 4}, {3, 4}, {4, 4}}));
}

TEST_F(StoppedExchange, gives_out_no_file_and_logs_none) {
  const fs::path file = next_file();
  const auto before = names();
  const auto logged = rows(*station, "audit_log");
  for (const WorkWatch& stop : {at_once(), until(1), until(3)}) {
    const auto given = give_out(station->context(), keeper, ExchangeKind::results, file, stop);
    ASSERT_EQ(code_of(given), StorageError::stopped);
    EXPECT_EQ(given.error().where, file.string());
    EXPECT_EQ(names(), before);
    EXPECT_EQ(rows(*station, "audit_log"), logged) << "the log names no file that is not there";
  }
  EXPECT_EQ(must(give_out(station->context(), keeper, ExchangeKind::results, file)).description.number(), 1u);
}

TEST_F(StoppedExchange, looks_into_no_file) {
  const fs::path file = results();
  for (const WorkWatch& stop : {at_once(), until(3)}) EXPECT_EQ(code_of(look_into(office->context(), chief, file, stop)), StorageError::stopped);
  EXPECT_EQ(must(look_into(office->context(), chief, file)).counts.sessions, 3u);
}

TEST_F(StoppedExchange, reads_nothing_of_a_results_file) {
  const fs::path file = results();
  const auto before = names();
  const auto logged = rows(*office, "audit_log");
  for (const WorkWatch& stop : {at_once(), until(1), until(3)}) {
    ASSERT_EQ(code_of(read_in(office->context(), chief, file, stop)), StorageError::stopped);
    EXPECT_EQ(rows(*office, "sessions"), 0);
    EXPECT_EQ(rows(*office, "audit_log"), logged);
    EXPECT_EQ(names(), before);
    EXPECT_EQ(whole(*office), "");
  }
  EXPECT_EQ(at_office(file).counts.sessions, 3u);
  EXPECT_EQ(whole(*office), "");
}

TEST_F(StoppedExchange, gives_the_disk_back_what_the_log_took_of_the_file) {
  const fs::path file = results(), log = folder / "office.db-wal";
  ASSERT_GT(fs::file_size(log), 0u);
  ASSERT_EQ(code_of(read_in(office->context(), chief, file, until(3))), StorageError::stopped);
  EXPECT_EQ(fs::file_size(log), 0u);
}

TEST_F(StoppedExchange, reads_nothing_of_an_office_file) {
  const fs::path file = office_file();
  const auto people = rows(*station, "people");
  const auto logged = rows(*station, "audit_log");
  for (const WorkWatch& stop : {at_once(), until(1), until(4)}) {
    ASSERT_EQ(code_of(read_in(station->context(), keeper, file, stop)), StorageError::stopped);
    EXPECT_EQ(rows(*station, "people"), people);
    EXPECT_EQ(rows(*station, "audit_log"), logged);
  }
  EXPECT_EQ(at_station(file).counts.accounts, 4u);
  EXPECT_EQ(whole(*station), "");
}

}  // namespace
}  // namespace cusp::test
