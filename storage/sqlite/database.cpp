#include "storage/sqlite/database.h"

#include <sqlite3.h>

#include <array>

#include "storage/sqlite/packed_attempt.h"

namespace cusp::storage {
namespace {

/// Instructions of SQLite's virtual machine between two questions: VACUUM INTO asks some 60 times while it copies 19 MB in 24,000 rows.
constexpr int kStepsBetweenQuestions = 2000;

int is_to_end(void* goes_on) { return (*static_cast<std::function<bool()>*>(goes_on))() ? 0 : 1; }

}  // namespace

Database::Database(sqlite3* handle, std::filesystem::path file, DatabaseOptions::Access access) noexcept
    : handle_{handle}, file_{std::move(file)}, read_only_{access == DatabaseOptions::Access::read_only} {
  if (handle_ == nullptr) return;
  add_pack_attempts(handle_);
  // Whoever wrote the file chose what they run; the program has none. Those of the connection itself (TEMP) stay.
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
}
Database::~Database() { sqlite3_close_v2(handle_); }
Database::Database(Database&& other) noexcept
    : handle_{std::exchange(other.handle_, nullptr)}, file_{std::move(other.file_)}, read_only_{other.read_only_}, unwritable_{std::move(other.unwritable_)} {}

StorageFailure Database::unwritable() const { return unwritable_.value_or(StorageFailure{StorageError::read_only, file_.string()}); }

int Database::schema_version() {
  const auto version = first("PRAGMA user_version", [](Row row) { return static_cast<int>(row.integer(0)); });
  return version && *version ? **version : 0;
}

Stored<void> Database::script(const std::string& sql) {
  if (const int status = sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr); status != SQLITE_OK) {
    return std::unexpected(failure_of(handle_, status));
  }
  return {};
}

std::int64_t Database::changes() const noexcept { return sqlite3_changes64(handle_); }
bool Database::in_transaction() const noexcept { return sqlite3_get_autocommit(handle_) == 0; }

Stored<std::string> Database::integrity_check() {
  const auto lines = all("PRAGMA integrity_check", [](Row row) { return row.text(0); });
  if (!lines) return std::unexpected(lines.error());
  std::string out;
  for (const std::string& line : *lines) {
    if (line != "ok") out += line + "\n";
  }
  return out;
}

void Database::ask_between_steps(std::function<bool()>* goes_on) noexcept {
  sqlite3_progress_handler(handle_, kStepsBetweenQuestions, goes_on != nullptr ? is_to_end : nullptr, goes_on);
}

StatementWatch::StatementWatch(Database& database, std::function<bool()> goes_on) : database_{database}, goes_on_{std::move(goes_on)} {
  if (goes_on_) database_.ask_between_steps(&goes_on_);
}

StatementWatch::~StatementWatch() { database_.ask_between_steps(nullptr); }

Snapshot::Snapshot(Database& database) : database_{database} {
  // BEGIN fails only without memory; each statement then reads the newest state.
  if (!database_.in_transaction()) open_ = database_.run("BEGIN").has_value();
}

Snapshot::~Snapshot() {
  if (open_ && database_.in_transaction()) static_cast<void>(database_.run("ROLLBACK"));
}

Transaction::Transaction(Database& database) : database_{database} {
  if (auto begun = database_.run("BEGIN IMMEDIATE"); begun) {
    open_ = true;
  } else {
    refuse(std::move(begun.error()));
  }
}

Transaction::~Transaction() {
  // ROLLBACK fails only if SQLite has rolled back already.
  if (open_ && database_.in_transaction()) static_cast<void>(database_.run("ROLLBACK"));
}

bool Transaction::ok() {
  if (open_ && !failure_ && !database_.in_transaction()) refuse({StorageError::io, database_.file().string(), "rolled back"});
  return !failure_;
}

Stored<void> Database::attach_source(const std::filesystem::path& file) {
  std::error_code ignored;
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(file, ignored).string()) {
    constexpr std::string_view special = "%?#";
    constexpr std::array<const char*, 3> escaped = {"%25", "%3f", "%23"};
    const auto at = special.find(c);
    if (at == std::string_view::npos) {
      uri += c;
    } else {
      uri += escaped[at];
    }
  }
  return run("ATTACH ?1 AS source", uri + "?mode=ro");
}

void Database::detach_source() { static_cast<void>(run("DETACH source")); }

Stored<void> Transaction::commit() {
  if (ok()) {
    if (auto done = database_.run("COMMIT"); !done) refuse(std::move(done.error()));
  }
  if (failure_) {
    if (failure_->code == StorageError::read_only && database_.read_only()) failure_ = database_.unwritable();
    if (open_ && database_.in_transaction()) static_cast<void>(database_.run("ROLLBACK"));
    open_ = false;
    return std::unexpected(*failure_);
  }
  open_ = false;
  return {};
}

}  // namespace cusp::storage
