#include "tests/storage/statements_seen.h"

#include <sqlite3.h>

#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

std::set<std::string>& texts_seen() {
  static std::set<std::string> texts;
  return texts;
}

int note(unsigned, void*, void* statement, void*) {
  if (const char* sql = sqlite3_sql(static_cast<sqlite3_stmt*>(statement))) texts_seen().insert(sql);
  return 0;
}

/// SQLite calls it for every new connection.
int listen(sqlite3* connection, char**, const void*) { return sqlite3_trace_v2(connection, SQLITE_TRACE_STMT, note, nullptr); }

void (*entry())() { return reinterpret_cast<void (*)()>(&listen); }

}  // namespace

StatementsSeen::StatementsSeen() {
  texts_seen().clear();
  sqlite3_auto_extension(entry());
}
StatementsSeen::~StatementsSeen() { sqlite3_cancel_auto_extension(entry()); }
void StatementsSeen::forget() { texts_seen().clear(); }
const std::set<std::string>& StatementsSeen::texts() { return texts_seen(); }

std::vector<std::string> plan_of(storage::Database& db, const std::string& sql) {
  return must(db.all("EXPLAIN QUERY PLAN " + sql, [](storage::Row row) { return row.text(3); }));
}

}  // namespace cusp::test
