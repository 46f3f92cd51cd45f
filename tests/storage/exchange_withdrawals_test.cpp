/// What an office withdrew is withdrawn at its stations too, also where a station withdrew the same itself.
#include <gtest/gtest.h>

#include "tests/storage/two_stations.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

struct ExchangeWithdrawalsTest : TwoStations {
  Actor instructor = make_instructor(*office).actor();
  Account lena = make_student(*office);
  ScenarioVersion version = keep(*office);
  Assignment practice;

  void SetUp() override {
    trust_each_other();
    const CohortId cohort = must(office->cohorts.create(chief, "Year 2")).id;
    must(office->cohorts.add(chief, cohort, lena.id));
    practice = must(office->assignments.create(instructor, {.version = version.id, .cohort = cohort}));
  }
  void carry() {
    const fs::path file = next_file();
    must(give_out(office->context(), chief, ExchangeKind::office, file));
    must(read_in(station->context(), keeper, file));
  }
  Stored<Session> begin() {
    NewSession wanted = new_session(lena, version);
    wanted.assignment = practice.id;
    return station->sessions.start(lena.actor(), wanted);
  }
};

TEST_F(ExchangeWithdrawalsTest, an_assignment_withdrawn_at_the_office_admits_nobody_at_the_station) {
  carry();
  EXPECT_TRUE(begin());
  must(office->assignments.withdraw(instructor, practice.id));
  carry();
  EXPECT_EQ(begin().error().where, "withdrawn");
  EXPECT_TRUE(must(verify_store(station->context())).intact());
}

TEST_F(ExchangeWithdrawalsTest, what_office_and_station_both_withdrew_refuses_no_file) {
  carry();
  for (Store* store : {office.get(), station.get()}) {
    must(store->assignments.withdraw(instructor, practice.id));
    must(store->scenarios.withdraw(instructor, version.id));
  }
  carry();
  EXPECT_TRUE(must(verify_store(station->context())).intact());
}

}  // namespace
}  // namespace cusp::test
