/// Statements that somebody no longer wants the answer of.
#include <gtest/gtest.h>

#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

/// Numbers from 1 on: a statement that runs for as long as it counts.
std::string numbers_to(std::int64_t last) {
  return "WITH RECURSIVE numbers (n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM numbers WHERE n < " + std::to_string(last) + ") ";
}
/// Takes minutes.
constexpr std::int64_t kNoEnd = 1'000'000'000;

struct StatementWatchTest : ::testing::Test {
  Folder folder;
  std::unique_ptr<Store> store = open(folder / "a.db");
  Database& db = store->database();
  int asked = 0;

  Stored<std::optional<std::int64_t>> count_to(std::int64_t last) {
    return db.first(numbers_to(last) + "SELECT count(*) FROM numbers", [](Row row) { return row.integer(0); });
  }
};

TEST_F(StatementWatchTest, ends_one_that_takes_long_at_its_first_refusal) {
  const StatementWatch watch(db, [this] { return ++asked < 3; });
  EXPECT_EQ(code_of(count_to(kNoEnd)), StorageError::stopped);
  EXPECT_EQ(asked, 3);
}

TEST_F(StatementWatchTest, is_asked_no_more_after_its_end) {
  { const StatementWatch watch(db, [] { return false; }); }
  EXPECT_EQ(must(count_to(100'000)), 100'000);
}

TEST_F(StatementWatchTest, that_is_empty_asks_nobody) {
  const StatementWatch watch(db, {});
  EXPECT_EQ(must(count_to(100'000)), 100'000);
}

TEST_F(StatementWatchTest, rolls_back_the_transaction_of_one_that_writes) {
  must(db.run("CREATE TABLE numbers_kept (n INTEGER) STRICT"));
  {
    Transaction transaction(db);
    transaction.run("INSERT INTO numbers_kept VALUES (1)");
    const StatementWatch watch(db, [] { return false; });
    transaction.run("INSERT INTO numbers_kept " + numbers_to(kNoEnd) + "SELECT n FROM numbers");
    EXPECT_EQ(code_of(transaction.commit()), StorageError::stopped);
  }
  EXPECT_EQ(must(db.first("SELECT count(*) FROM numbers_kept", [](Row row) { return row.integer(0); })), 0);
}

}  // namespace
}  // namespace cusp::test
