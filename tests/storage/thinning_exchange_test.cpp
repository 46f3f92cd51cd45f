/// A thinned attempt at other stations: with the whole recording before or after, late, or cut short.
#include <gtest/gtest.h>

#include "storage/retention/thinning.h"
#include "tests/storage/two_stations.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

struct ThinnedElsewhere : TwoStations {
  std::unique_ptr<Store> third = open(folder / "third.db");
  Actor boss = make_administrator(*third, "boss").actor();
  Account omar = make_student(*station, "20260002", "Omar Haddad");

  void SetUp() override {
    for (const auto& [store, actor] : {std::pair{office.get(), chief}, std::pair{third.get(), boss}}) {
      must(trust(store->context(), actor, key_of_station(*station), KeyRole::station));
    }
  }
  /// The clock of these stores stands, so that the station's thinning looks 100 days ahead.
  void thin_at_station() {
    const auto later = open(folder / "station.db", quick(std::make_shared<std::int64_t>(kNow + 100 * 86'400'000'000)));
    ASSERT_EQ(must(thin_traces(later->context(), keeper, {.mode = ThinningMode::carry_out})).attempts, 1u);
  }
  ReadIn at_office(const fs::path& file) { return must(read_in(office->context(), chief, file)); }
  ReadIn at_third(const fs::path& file) { return must(read_in(third->context(), boss, file)); }
  /// Without accounts: each station has its own administrator.
  static std::map<std::string, std::string> records_of(Store& store) {
    auto records = shared_records(store);
    records.erase("people");
    return records;
  }
  static std::size_t recorded(Store& store, SessionId session) {
    const auto inputs = store.traces.inputs(session);
    return inputs ? inputs->size() : 0;
  }
  static std::string findings(Store& store) {
    std::string out;
    for (const ChainFinding& f : must(verify_store(store.context())).findings) out += std::string(key_of(f.code)) + ' ' + f.table + ' ' + f.what + '\n';
    return out;
  }
  static std::int64_t thinned(Store& store) {
    return *must(store.database().first("SELECT count(*) FROM thinned_traces", [](Row row) { return row.integer(0); }));
  }
};

TEST_F(ThinnedElsewhere, an_attempt_arrives_with_its_row_and_verifies) {
  const SessionId session = complete_session(*station, omar, keep(*station), 62);
  thin_at_station();
  at_office(results());
  EXPECT_EQ(thinned(*office), 1);
  EXPECT_EQ(findings(*office), "");
  EXPECT_EQ(code_of(office->traces.inputs(session)), StorageError::wrong_state);
  const auto here = must(station->history.details(keeper, session)), there = must(office->history.details(chief, session));
  EXPECT_EQ(there.row.score, here.row.score);
  EXPECT_EQ(there.row.elapsed_us, here.row.elapsed_us);
  EXPECT_EQ(must(thin_traces(office->context(), chief, {.mode = ThinningMode::carry_out})).attempts, 0u);
}

TEST_F(ThinnedElsewhere, whole_then_thinned_and_thinned_then_whole_end_with_the_whole) {
  const SessionId session = complete_session(*station, omar, keep(*station), 62);
  const fs::path whole = results();
  thin_at_station();
  const fs::path thin = results();
  at_office(whole);
  at_office(thin);
  at_third(thin);
  EXPECT_EQ(recorded(*third, session), 0u);
  EXPECT_EQ(at_third(whole).outcome, ReadOutcome::late);
  for (Store* store : {office.get(), third.get()}) {
    EXPECT_EQ(recorded(*store, session), 36u);
    EXPECT_EQ(thinned(*store), 0);
    EXPECT_EQ(findings(*store), "");
  }
  EXPECT_EQ(records_of(*office), records_of(*third));
  at_third(thin);
  EXPECT_EQ(recorded(*third, session), 36u) << "read again, it changes nothing";
}

TEST_F(ThinnedElsewhere, a_recording_cut_short_gives_way_in_both_orders) {
  const ScenarioVersion version = keep(*station);
  const SessionId session = must(station->sessions.start(omar.actor(), new_session(omar, version))).id;
  must(station->traces.append(session, second_from(1)));
  must(station->sessions.interrupt(session, "recorder_full"));
  const fs::path early = results();
  must(station->sessions.resume(session, "student"));
  must(station->traces.append(session, second_from(13)));
  must(station->sessions.finish(session, volume_after(24), "student"));
  must(station->grades.save(session, small_grade(62, false), {}));
  thin_at_station();
  const fs::path thin = results();
  at_office(early);
  EXPECT_EQ(recorded(*office, session), 12u);
  at_office(thin);
  at_third(thin);
  at_third(early);
  for (Store* store : {office.get(), third.get()}) {
    EXPECT_EQ(recorded(*store, session), 0u);
    EXPECT_EQ(thinned(*store), 1);
    EXPECT_EQ(findings(*store), "");
  }
  EXPECT_EQ(records_of(*office), records_of(*third));
}

TEST_F(ThinnedElsewhere, a_file_whose_row_does_not_hold_is_refused) {
  complete_session(*station, omar, keep(*station), 62);
  thin_at_station();
  must(station->database().run("UPDATE thinned_traces SET at = at + 1"));
  EXPECT_EQ(code_of(read_in(office->context(), chief, results())), StorageError::differs);
  EXPECT_EQ(thinned(*office), 0);
}

}  // namespace
}  // namespace cusp::test
