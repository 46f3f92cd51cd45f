/// The audit log's pages, filters and verification, against a plain reading of all entries.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "tests/storage/sample.h"
#include "tests/storage/statements_seen.h"

namespace cusp::test {
namespace {

struct AuditLogTest : ::testing::Test {
  Folder folder;
  std::shared_ptr<std::int64_t> now = std::make_shared<std::int64_t>(kNow);
  std::unique_ptr<Store> store = open(folder / "a.db", quick(now));
  Account admin = make_administrator(*store), student = make_student(*store);
  void SetUp() override {
    must(store->accounts.disable(admin.actor(), student.id));
    must(store->accounts.enable(admin.actor(), student.id));
    EXPECT_FALSE(store->accounts.sign_in(student.number, "not the password"));
    for (int i = 0; i < 20; ++i, ++*now) must(store->audit.add({.actor = admin.id, .action = "backed_up", .subject = {}, .detail = "0"}));
  }
  std::vector<AuditEntry> all() { return must(store->audit.list(admin.actor(), 1000)); }
  std::vector<std::int64_t> numbers(const AuditFilter& filter, int limit = 1000) {
    std::vector<std::int64_t> out;
    while (true) {
      const auto page = must(store->audit.list(admin.actor(), limit, out.empty() ? INT64_MAX : out.back(), filter));
      EXPECT_LE(page.size(), static_cast<std::size_t>(limit));
      for (const AuditEntry& entry : page) out.push_back(entry.number);
      if (page.empty()) return out;
    }
  }
  template <class Fits>
  std::vector<std::int64_t> fitting(Fits fits) {
    std::vector<std::int64_t> out;
    for (const AuditEntry& entry : all())
      if (fits(entry)) out.push_back(entry.number);
    return out;
  }
};

TEST_F(AuditLogTest, PagesHoldEachEntryOnceNewestFirst) {
  const auto whole = fitting([](const AuditEntry&) { return true; });
  ASSERT_GT(whole.size(), 25u);
  EXPECT_TRUE(std::ranges::is_sorted(whole, std::greater()));
  for (const int limit : {1, 3, 7, 1000}) EXPECT_EQ(numbers({}, limit), whole) << limit;
}

TEST_F(AuditLogTest, EachFilterLeavesWhatFits) {
  const std::vector<std::string> actions = {"account_disabled", "sign_in_failed"};
  const auto of_actions = fitting([&](const AuditEntry& e) { return std::ranges::count(actions, e.action) > 0; });
  EXPECT_EQ(of_actions.size(), 2u);
  EXPECT_EQ(numbers({.actions = actions}), of_actions);
  EXPECT_TRUE(numbers({.actions = {"account"}}).empty()) << "a part of a code is no code";
  const auto of_student = fitting([&](const AuditEntry& e) { return e.actor == student.id || e.subject == student.id.uuid; });
  EXPECT_GE(of_student.size(), 4u);
  EXPECT_EQ(numbers({.person = student.id}, 2), of_student);
  const auto of_program = fitting([](const AuditEntry& e) { return e.actor == UserId{}; });
  EXPECT_EQ(numbers({.person = UserId{}}), of_program);
  const auto entries = all();
  const std::int64_t from = entries[entries.size() / 2].at_utc_us, to = entries[2].at_utc_us;
  EXPECT_EQ(numbers({.from_utc_us = from, .to_utc_us = to}),
            fitting([&](const AuditEntry& e) { return e.at_utc_us >= from && e.at_utc_us < to; }));
}

TEST_F(AuditLogTest, SealsOfSessionsAreListedAmongTheOtherEntriesWhoeverWroteThem) {
  const Account examiner = make_instructor(*store);
  const ScenarioVersion version = keep(*store);
  const SessionId session = complete_session(*store, student, version);
  must(store->grades.save(session, small_grade(70), {}, examiner.actor()));
  *now += 10;
  complete_session(*store, admin, version);
  *now = kNow + 5;
  complete_session(*store, student, version);
  const auto is_seal = [](const AuditEntry& e) { return e.action == "session_sealed"; };
  auto by_time = all();
  std::ranges::stable_sort(by_time, std::greater(), [](const AuditEntry& e) { return std::pair{e.at_utc_us, e.number}; });
  const auto expect = [&](const AuditFilter& filter, std::size_t most, const std::function<bool(const AuditEntry&)>& fits) {
    std::vector<std::int64_t> expected;
    for (const AuditEntry& e : by_time)
      if (fits(e)) expected.push_back(e.number);
    EXPECT_GE(expected.size(), most);
    for (const int limit : {1, 2, 1000}) EXPECT_EQ(numbers(filter, limit), expected) << limit;
  };
  expect({.actions = {"session_sealed"}}, 10, is_seal);
  expect({.actions = {"session_sealed", "backed_up"}}, 30, [&](const AuditEntry& e) { return is_seal(e) || e.action == "backed_up"; });
  expect({.from_utc_us = kNow + 1, .to_utc_us = kNow + 30}, 15, [](const AuditEntry& e) { return e.at_utc_us > kNow && e.at_utc_us < kNow + 30; });
  for (const UserId person : {student.id, examiner.id, admin.id, UserId{}}) {
    const auto concerns = [person](const AuditEntry& e) { return e.actor == person || (person != UserId{} && e.subject == person.uuid); };
    expect({.person = person}, 2, concerns);
    expect({.actions = {"session_sealed"}, .person = person}, 1, [&](const AuditEntry& e) { return is_seal(e) && concerns(e); });
  }
  EXPECT_TRUE(numbers({.actions = {"session_sealed"}, .person = UserId{session.uuid}}).empty()) << "a session is no person";
}

TEST_F(AuditLogTest, APageIsReadAlongAnIndexWithoutSortingWhateverTheFilter) {
  const StatementsSeen seen;
  const auto again = open(folder / "b.db");
  const Account other = make_administrator(*again);
  for (const AuditFilter& filter : {AuditFilter{}, AuditFilter{.actions = {"signed_in"}}, AuditFilter{.person = other.id},
                                    AuditFilter{.person = UserId{}}, AuditFilter{.from_utc_us = kNow}, AuditFilter{.actions = {"signed_in"}, .person = other.id, .to_utc_us = kNow}}) {
    must(again->audit.list(other.actor(), 10, 5, filter));
  }
  std::string plans;
  for (const std::string& sql : StatementsSeen::texts()) {
    if (sql.find("FROM audit_log") == std::string::npos) continue;
    std::string plan;
    for (const std::string& line : plan_of(again->database(), sql)) plan += line + '\n';
    EXPECT_EQ(plan.find("SCAN audit_log\n"), std::string::npos) << sql << '\n' << plan;
    EXPECT_EQ(plan.find("TEMP B-TREE"), std::string::npos) << sql << '\n' << plan;
    plans += plan;
  }
  for (const char* search : {"SEARCH audit_log USING INTEGER PRIMARY KEY (rowid<?)", "audit_by_action (action=? AND at>? AND at<?)",
                             "audit_by_actor (actor=? AND action=? AND at>? AND at<?)", "audit_by_subject (subject=? AND action=? AND at>? AND at<?)",
                             "seals_by_time (at>? AND at<?)", "seals_by_actor (actor=? AND at>? AND at<?)"})
    EXPECT_NE(plans.find(search), std::string::npos) << search << '\n' << plans;
}

TEST_F(AuditLogTest, PagesOfEachFilterHoldEachEntryOnceWhereTheClockWasSetBack) {
  *now = kNow - 5;
  for (int i = 0; i < 6; ++i, ++*now) must(store->audit.add({.actor = admin.id, .action = "signed_in", .subject = student.id.uuid, .detail = {}}));
  const AuditFilter by_admin{.person = admin.id}, by_time{.from_utc_us = kNow - 4, .to_utc_us = kNow + 15}, both{.actions = {"signed_in", "backed_up"}, .person = admin.id};
  for (const AuditFilter& filter : {by_admin, by_time, both}) {
    const auto whole = numbers(filter);
    ASSERT_GT(whole.size(), 10u);
    for (const int limit : {1, 3, 7}) EXPECT_EQ(numbers(filter, limit), whole) << limit;
    EXPECT_EQ(std::set<std::int64_t>(whole.begin(), whole.end()).size(), whole.size());
  }
}

TEST_F(AuditLogTest, TheAdministratorAloneReadsAndVerifies) {
  for (const Role role : {Role::student, Role::instructor}) {
    const Actor other{student.id, role};
    EXPECT_EQ(code_of(store->audit.list(other, 10)), StorageError::not_allowed);
    EXPECT_EQ(code_of(store->audit.verify(other, [](std::int64_t) {})), StorageError::not_allowed);
  }
}

TEST_F(AuditLogTest, VerificationCountsWhatHoldsAndNamesTheEntryThatBreaksTheChain) {
  std::vector<std::int64_t> held;
  const auto each = [&held](std::int64_t number) { held.push_back(number); };
  EXPECT_TRUE(must(store->audit.verify(admin.actor(), each)).intact());
  std::ranges::reverse(held);
  EXPECT_EQ(held, numbers({}));
  must(store->database().run("UPDATE audit_log SET detail = '1' WHERE number = 9"));
  held.clear();
  const auto proof = must(store->audit.verify(admin.actor(), each));
  ASSERT_FALSE(proof.intact());
  EXPECT_EQ(proof.findings.front().code, FindingCode::row_changed);
  EXPECT_EQ(proof.findings.front().row, 9);
  EXPECT_EQ(std::ranges::count(held, 9), 0);
  EXPECT_EQ(held[8], 8);
}

}  // namespace
}  // namespace cusp::test
