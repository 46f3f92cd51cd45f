#include "tests/storage/statements_seen.h"

#include <sqlite3.h>

#include <utility>

#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

std::set<std::string>& texts_seen() {
  static std::set<std::string> texts;
  return texts;
}

std::function<void(std::string_view sql)>& call_at_each() {
  static std::function<void(std::string_view sql)> call;
  return call;
}

int note(unsigned, void*, void* statement, void*) {
  const char* sql = sqlite3_sql(static_cast<sqlite3_stmt*>(statement));
  if (sql == nullptr) return 0;
  texts_seen().insert(sql);
  if (call_at_each()) call_at_each()(sql);
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
StatementsSeen::~StatementsSeen() {
  sqlite3_cancel_auto_extension(entry());
  call_at_each() = {};
}
void StatementsSeen::at_each(std::function<void(std::string_view sql)> call) { call_at_each() = std::move(call); }
void StatementsSeen::forget() { texts_seen().clear(); }
const std::set<std::string>& StatementsSeen::texts() { return texts_seen(); }

std::vector<std::string> plan_of(storage::Database& db, const std::string& sql) {
  return must(db.all("EXPLAIN QUERY PLAN " + sql, [](storage::Row row) { return row.text(3); }));
}

}  // namespace cusp::test
