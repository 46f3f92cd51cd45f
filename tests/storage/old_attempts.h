/// A station whose clock the test sets: attempts that ended so many days ago. Tests make the oldest first: the log has an order too.
#pragma once

#include <map>
#include <random>

#include "storage/records/session_summary.h"
#include "storage/retention/thinning.h"
#include "tests/storage/sample.h"

namespace cusp::test {

inline constexpr std::int64_t kDay_us = 86'400'000'000;

struct OldAttempts : ::testing::Test {
  /// The accounts are of that day. 150 days: before every attempt of these tests, and less than half a year ago, so that the clock is
  /// believed.
  explicit OldAttempts(int opened_days_ago = 150) : now{std::make_shared<std::int64_t>(kNow - opened_days_ago * kDay_us)} { *now = kNow; }

  Folder folder;
  std::shared_ptr<std::int64_t> now;
  std::unique_ptr<Store> store = open(folder / "a.db", quick(now));
  Actor admin = make_administrator(*store).actor(), instructor = make_instructor(*store).actor();
  Account student = make_student(*store);
  ScenarioVersion version = keep(*store);

  enum class Upto : std::uint8_t { interrupted, finished, graded };
  /// `seconds`: 0 is complete_session(); else so many of noise, which does not compress.
  SessionId attempt(int days_ago, Upto upto = Upto::graded, int seconds = 0);
  /// Sat and graded, not released.
  SessionId assessment(int days_ago);
  ThinningReport thin(ThinningMode mode = ThinningMode::carry_out) {
    return must(thin_traces(store->context(), admin, {.mode = mode}));
  }
  bool is_thinned(SessionId session);
  std::int64_t count(const std::string& table);
  static std::uint64_t kept(const ThinningReport& report, KeptBecause why) { return report.kept[static_cast<std::size_t>(why)]; }
  /// A hash of each table's rows of the session.
  std::map<std::string, std::string> rows_of(SessionId session);
  /// Rows, links and head of the session as they stood before its grade.
  void put_back_before_grade(SessionId session);
  std::string findings();
  static std::string hex_of(SessionId session);
};

}  // namespace cusp::test
