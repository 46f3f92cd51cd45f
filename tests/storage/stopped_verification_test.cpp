/// Verification of all records: the progress that it reports, and its result once somebody stops it.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

using Reported = std::vector<std::pair<std::size_t, std::size_t>>;  // done, all

struct StoppedVerification : ::testing::Test {
  Folder folder;
  std::unique_ptr<Store> store = open(folder / "a.db");
  Account lena = make_student(*store);
  ScenarioVersion version = keep(*store);

  void SetUp() override {
    for (int i = 0; i < 3; ++i) complete_session(*store, lena, version);
  }
  StoreVerification stopped_after(std::size_t sessions) {
    return must(verify_store(store->context(), [sessions](std::size_t done, std::size_t all) { return all == 0 || done < sessions; }));
  }
};

TEST_F(StoppedVerification, that_nobody_stops_reports_each_session_and_ends_at_all_of_them) {
  Reported reported;
  const auto proof = must(verify_store(store->context(), [&](std::size_t done, std::size_t all) {
    if (all > 0 && (reported.empty() || reported.back().first != done)) reported.emplace_back(done, all);
    return true;
  }));
  EXPECT_TRUE(proof.intact());
  EXPECT_FALSE(proof.stopped);
  EXPECT_EQ(proof.sessions, 3u);
  EXPECT_EQ(reported, (Reported{{0, 3}, {1, 3}, {2, 3}, {3, 3}}));
}

TEST_F(StoppedVerification, finds_nothing_in_what_it_did_not_verify_and_is_not_intact) {
  for (const std::size_t sessions : {0u, 1u, 3u}) {
    const StoreVerification proof = stopped_after(sessions);
    EXPECT_TRUE(proof.stopped) << sessions;
    EXPECT_FALSE(proof.intact()) << sessions;
    EXPECT_EQ(proof.sessions, sessions);
    EXPECT_TRUE(proof.findings.empty()) << key_of(proof.findings.front().code) << ' ' << proof.findings.front().table;
  }
}

TEST_F(StoppedVerification, keeps_what_it_has_found) {
  must(store->database().run("UPDATE grades SET score = 100"));
  const StoreVerification proof = stopped_after(1);
  EXPECT_TRUE(proof.stopped);
  ASSERT_FALSE(proof.findings.empty());
  EXPECT_EQ(proof.findings.front().table, "grades");
  for (const ChainFinding& finding : proof.findings) EXPECT_EQ(finding.owner, proof.findings.front().owner) << "of the one that was verified";
}

}  // namespace
}  // namespace cusp::test
