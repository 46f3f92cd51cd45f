#include "storage/sqlite/statement.h"

#include <sqlite3.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "storage/base/files.h"

namespace cusp::storage {

int Row::columns() const noexcept { return sqlite3_column_count(statement_); }
bool Row::is_null(int column) const noexcept { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }
std::int64_t Row::integer(int column) const noexcept { return sqlite3_column_int64(statement_, column); }
double Row::real(int column) const noexcept {
  return is_null(column) ? std::numeric_limits<double>::quiet_NaN() : sqlite3_column_double(statement_, column);
}
std::string Row::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return text == nullptr ? std::string{}
                         : std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)));
}
std::span<const std::byte> Row::bytes(int column) const noexcept {
  const auto* data = static_cast<const std::byte*>(sqlite3_column_blob(statement_, column));
  if (data == nullptr) return {};
  return {data, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}
std::vector<std::byte> Row::blob(int column) const {
  const auto view = bytes(column);
  return {view.begin(), view.end()};
}

namespace {
template <std::size_t N>
std::array<std::uint8_t, N> fixed(std::span<const std::byte> from) noexcept {
  std::array<std::uint8_t, N> out{};
  if (from.size() == N)
    std::ranges::transform(from, out.begin(), [](std::byte b) { return std::to_integer<std::uint8_t>(b); });
  return out;
}
}  // namespace

Uuid Row::uuid(int column) const noexcept { return Uuid{fixed<16>(bytes(column))}; }
Hash256 Row::hash(int column) const noexcept { return fixed<32>(bytes(column)); }

bool Row::same_value(int column, const Row& other) const {
  const int type = sqlite3_column_type(statement_, column);
  if (type != sqlite3_column_type(other.statement_, column)) return false;
  if (type == SQLITE_INTEGER) return integer(column) == other.integer(column);
  if (type == SQLITE_FLOAT) return std::bit_cast<std::uint64_t>(real(column)) == std::bit_cast<std::uint64_t>(other.real(column));
  return type == SQLITE_NULL || std::ranges::equal(bytes(column), other.bytes(column));
}

Hash256 Row::content_hash(int first, std::optional<int> end) const {
  Blake2b hash;
  for (int i = first; i < end.value_or(columns()); ++i) {
    const int type = sqlite3_column_type(statement_, i);
    hash.add_u64(static_cast<std::uint64_t>(type));
    switch (type) {
      case SQLITE_INTEGER:
        hash.add_u64(static_cast<std::uint64_t>(integer(i)));
        break;
      case SQLITE_FLOAT:
        hash.add_u64(std::bit_cast<std::uint64_t>(sqlite3_column_double(statement_, i)));
        break;
      case SQLITE_NULL:
        break;
      default:
        hash.add_bytes(bytes(i));
        break;
    }
  }
  return hash.finish();
}

Statement::Statement(sqlite3* database, std::string_view sql) : database_{database} {
  status_ = sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &statement_, nullptr);
}
Statement::~Statement() { sqlite3_finalize(statement_); }
Statement::Statement(Statement&& other) noexcept
    : database_{other.database_}, statement_{std::exchange(other.statement_, nullptr)}, status_{other.status_} {}

Stored<bool> Statement::step() {
  if (status_ != SQLITE_OK) return std::unexpected(failure_of(database_, status_));
  const int status = sqlite3_step(statement_);
  if (status == SQLITE_ROW) return true;
  if (status == SQLITE_DONE) {
    sqlite3_reset(statement_);
    return false;
  }
  auto failure = failure_of(database_, status);
  sqlite3_reset(statement_);
  return std::unexpected(std::move(failure));
}
void Statement::reset() noexcept {
  if (statement_ == nullptr) return;
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

namespace {
void keep(int& status, int fresh) noexcept {
  if (status == SQLITE_OK) status = fresh;
}
}  // namespace

void Statement::put(int at, std::nullptr_t) {
  if (statement_) keep(status_, sqlite3_bind_null(statement_, at));
}
void Statement::put(int at, std::int64_t value) {
  if (statement_) keep(status_, sqlite3_bind_int64(statement_, at, value));
}
void Statement::put(int at, double value) {
  if (statement_) keep(status_, sqlite3_bind_double(statement_, at, value));
}
void Statement::put(int at, std::string_view value) {
  if (statement_) {
    keep(status_, sqlite3_bind_text64(statement_, at, value.empty() ? "" : value.data(), value.size(), SQLITE_TRANSIENT,
                                      SQLITE_UTF8));
  }
}
void Statement::put(int at, std::span<const std::byte> value) {
  if (!statement_) return;
  if (value.empty()) {
    keep(status_, sqlite3_bind_zeroblob(statement_, at, 0));
  } else {
    keep(status_, sqlite3_bind_blob64(statement_, at, value.data(), value.size(), SQLITE_TRANSIENT));
  }
}

namespace {

/// errno of the newest failed call on the log or the main file. sqlite3_system_errno() is 0 if COMMIT failed.
int errno_of_files(sqlite3* database) noexcept {
  for (const int which : {SQLITE_FCNTL_JOURNAL_POINTER, SQLITE_FCNTL_FILE_POINTER}) {
    sqlite3_file* file = nullptr;
    if (sqlite3_file_control(database, "main", which, &file) != SQLITE_OK) continue;
    if (file == nullptr || file->pMethods == nullptr) continue;
    int error = 0;
    if (file->pMethods->xFileControl(file, SQLITE_FCNTL_LAST_ERRNO, &error) == SQLITE_OK && error != 0) return error;
  }
  return 0;
}

StorageError cause_of_failed_open(int system) noexcept {
  const StorageError cause = error_from_errno(system);
  return cause == StorageError::duplicate ? StorageError::io : cause;
}

StorageError cause_of_failed_io(int extended, int system) noexcept {
  if (extended == SQLITE_IOERR_NOMEM) return StorageError::out_of_memory;
  // A read needs no space and no right to write: its errno may be that of an older call.
  if (extended == SQLITE_IOERR_READ || extended == SQLITE_IOERR_SHORT_READ) return StorageError::io;
  const StorageError cause = error_from_errno(system);
  // These two errnos are left over from an older call, on a file that rightly exists or does not.
  return cause == StorageError::not_found || cause == StorageError::duplicate ? StorageError::io : cause;
}

}  // namespace

StorageFailure failure_of(sqlite3* database, int status, std::string where) {
  std::string detail = database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(status);
  if (where.empty() && database != nullptr) {
    if (const char* file = sqlite3_db_filename(database, "main"); file != nullptr) where = file;
  }
  const int extended = database != nullptr ? sqlite3_extended_errcode(database) : status;
  const int system = database != nullptr ? sqlite3_system_errno(database) : 0;
  StorageError code = StorageError::io;
  switch (status & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_PROTOCOL:  // other connections kept changing the log's index
      code = StorageError::busy;
      break;
    case SQLITE_INTERRUPT:  // StatementWatch
      code = StorageError::stopped;
      break;
    case SQLITE_FULL:
      code = StorageError::disk_full;
      break;
    case SQLITE_READONLY:
    case SQLITE_PERM:
      code = StorageError::read_only;
      break;
    case SQLITE_NOTADB:
      code = StorageError::not_a_database;
      break;
    case SQLITE_CORRUPT:
      code = StorageError::corrupt;
      break;
    case SQLITE_CONSTRAINT:
      code = extended == SQLITE_CONSTRAINT_UNIQUE || extended == SQLITE_CONSTRAINT_PRIMARYKEY ? StorageError::duplicate
             : extended == SQLITE_CONSTRAINT_FOREIGNKEY                                       ? StorageError::not_found
                                                                                              : StorageError::bad_value;
      break;
    case SQLITE_MISMATCH:
    case SQLITE_TOOBIG:
      code = StorageError::bad_value;
      break;
    case SQLITE_NOMEM:
      code = StorageError::out_of_memory;
      break;
    case SQLITE_ERROR:
      code = StorageError::bad_statement;
      break;
    case SQLITE_CANTOPEN:
      code = cause_of_failed_open(system);
      break;
    case SQLITE_IOERR:
      code = cause_of_failed_io(extended, system != 0 || database == nullptr ? system : errno_of_files(database));
      break;
    default:
      break;
  }
  return {code, std::move(where), std::move(detail)};
}

}  // namespace cusp::storage
