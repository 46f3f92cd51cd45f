/// The SQL of every statement that this process runs, and the plan that SQLite makes for it.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "storage/sqlite/database.h"

namespace cusp::test {

/// Collects from construction to destruction, from connections that are opened meanwhile. One at a time.
class StatementsSeen {
 public:
  StatementsSeen();
  ~StatementsSeen();
  StatementsSeen(const StatementsSeen&) = delete;
  StatementsSeen& operator=(const StatementsSeen&) = delete;
  void forget();
  static const std::set<std::string>& texts();
  /// Called with the SQL of each statement before it runs, until the end.
  static void at_each(std::function<void(std::string_view sql)> call);
};

/// Lines of EXPLAIN QUERY PLAN, such as "SEARCH a USING INDEX b (c=?)".
std::vector<std::string> plan_of(storage::Database& db, const std::string& sql);

}  // namespace cusp::test
