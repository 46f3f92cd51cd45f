/// The SQLite file: opening, its settings, transactions. Nothing outside storage/sqlite knows sqlite3.h.
/// Thread: one Database object per thread; several may stand on one file, in one process or in many.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "storage/base/error.h"
#include "storage/sqlite/statement.h"

namespace cusp::storage {

/// In order: the first brings user_version from 0 to 1 (storage/sqlite/migrate.h).
std::span<const std::string_view> built_in_migrations() noexcept;

/// "Cusp" in ASCII, in the file's header.
inline constexpr std::int32_t kApplicationId = 0x43757370;

struct DatabaseOptions {
  enum class Access : std::uint8_t {
    create,     // opens the file, or makes a new one
    existing,   // not_found if the file does not exist
    read_only,  // changes nothing; works on read-only media and on a full disk: see Database::open
  };
  Access access = Access::create;
  int busy_timeout_ms = 5000;
  std::span<const std::string_view> migrations = built_in_migrations();  // fewer: a file of an older schema, for tests
  std::string vfs{};                                                     // SQLite's name of one; empty = the system's
  std::function<bool(const std::filesystem::path&)> on_network_drive{};  // empty = ask the system
  enum class Kind : std::uint8_t {
    records,
    travelling,  // a file between stations, of any size: cut_short if it ends early, and its schema stays the one that it has
  };
  Kind kind = Kind::records;
};

/// For DatabaseOptions::on_network_drive: a file that one process alone has open, as a backup or a file that travels, may lie on a
/// drive that machines share.
inline bool admits_network_drive(const std::filesystem::path&) { return false; }

class Database {
 public:
  /// Checks that the file is Cusp's and not newer, sets WAL, synchronous=FULL and foreign keys, migrates.
  /// Fails with a code of "Opening" or "Any time" in StorageError; a refused file is unchanged. duplicate, detail "log": no file is
  /// made beside the log of one that was moved away, which SQLite would remove. Only SQLite opens the file
  /// (main_file.h): connections of other threads keep their locks.
  /// For reading, if the log's index cannot be created or grown, it opens a copy in memory of file and log as of now
  /// (memory_copy.h). Records of an older schema, too, are read from a copy in memory.
  static Stored<Database> open(const std::filesystem::path& file, const DatabaseOptions& options = {});
  ~Database();
  Database(Database&& other) noexcept;
  Database& operator=(Database&&) = delete;

  const std::filesystem::path& file() const noexcept { return file_; }
  bool read_only() const noexcept { return read_only_; }
  /// Why the file is open for reading alone: what unwritable() then returns.
  void set_unwritable(StorageFailure why) { unwritable_ = std::move(why); }
  /// What a write fails with if read_only(): read_only, unless set_unwritable() has named another cause.
  StorageFailure unwritable() const;
  int schema_version();

  Statement prepare(std::string_view sql) { return Statement{handle_, sql}; }

  /// Runs one statement to its end.
  template <class... Values>
  Stored<void> run(std::string_view sql, const Values&... values) {
    Statement s = prepare(sql);
    s.bind(values...);
    while (true) {
      auto more = s.step();
      if (!more) return std::unexpected(more.error());
      if (!*more) return {};
    }
  }
  /// Every row, read by `read(Row)`.
  template <class Read, class... Values>
  auto all(std::string_view sql, Read&& read, const Values&... values)
      -> Stored<std::vector<std::invoke_result_t<Read, Row>>> {
    std::vector<std::invoke_result_t<Read, Row>> out;
    Statement s = prepare(sql);
    s.bind(values...);
    while (true) {
      auto more = s.step();
      if (!more) return std::unexpected(more.error());
      if (!*more) return out;
      out.push_back(read(s.row()));
    }
  }
  /// The first row, nullopt when there is none.
  template <class Read, class... Values>
  auto first(std::string_view sql, Read&& read, const Values&... values)
      -> Stored<std::optional<std::invoke_result_t<Read, Row>>> {
    Statement s = prepare(sql);
    s.bind(values...);
    auto more = s.step();
    if (!more) return std::unexpected(more.error());
    if (!*more) return std::optional<std::invoke_result_t<Read, Row>>{};
    return std::optional<std::invoke_result_t<Read, Row>>{read(s.row())};
  }
  /// Another file of the same schema, as `source`, to read from: a transaction takes no lock to write in it.
  Stored<void> attach_source(const std::filesystem::path& file);
  void detach_source();
  /// Several statements without parameters: migrations only.
  Stored<void> script(const std::string& sql);
  /// Rows that the last statement changed.
  std::int64_t changes() const noexcept;
  bool in_transaction() const noexcept;
  /// For StatementWatch. nullptr: nothing is asked. `goes_on` stays where it is until the next call.
  void ask_between_steps(std::function<bool()>* goes_on) noexcept;
  /// Empty if SQLite finds the file sound, else its findings, one per line.
  Stored<std::string> integrity_check();

 private:
  /// Makes the program's SQL functions known to the connection, and its file's triggers and views dead. Pre: a handle of
  /// sqlite3_open_v2().
  Database(sqlite3* handle, std::filesystem::path file, DatabaseOptions::Access access) noexcept;
  /// Opens the file and checks its header. Runs no statement.
  static Stored<Database> connect(const std::filesystem::path& file, int flags, const DatabaseOptions& options);
  static Stored<Database> open_for_writing(const std::filesystem::path& file, const DatabaseOptions& options);
  static Stored<void> prepare_for_writing(Database& database, const DatabaseOptions& options);
  static Stored<Database> open_for_reading(const std::filesystem::path& file, const DatabaseOptions& options);
  static Stored<Database> read_in_place(const std::filesystem::path& file, const DatabaseOptions& options);
  static Stored<Database> copy_in_memory(const std::filesystem::path& file, const DatabaseOptions& options);
  /// The database, or, of records whose schema is older, a copy in memory that is migrated. The file stays as it is.
  static Stored<Database> current(Database database, const DatabaseOptions& options);
  /// Removes the file that a failed open() created, if it is empty and unused.
  static void remove_if_empty(const std::filesystem::path& file, const DatabaseOptions& options);

  sqlite3* handle_;
  std::filesystem::path file_;
  bool read_only_;
  std::optional<StorageFailure> unwritable_{};
};

/// While it lives, all reads see the database as of the first read. Inside another Snapshot or a Transaction it does
/// nothing. Pre: its owner writes nothing meanwhile.
class Snapshot {
 public:
  explicit Snapshot(Database& database);
  ~Snapshot();
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

 private:
  Database& database_;
  bool open_ = false;
};

/// While it lives, a statement of the database that takes long asks `goes_on` again and again; false ends it with `stopped`. One that
/// writes within a Transaction then rolls that back. An empty `goes_on` is never asked. One at a time on a database, which outlives it.
/// `goes_on` throws nothing and runs no statement there.
class StatementWatch {
 public:
  StatementWatch(Database& database, std::function<bool()> goes_on);
  ~StatementWatch();
  StatementWatch(const StatementWatch&) = delete;
  StatementWatch& operator=(const StatementWatch&) = delete;

 private:
  Database& database_;
  std::function<bool()> goes_on_;
};

/// BEGIN IMMEDIATE to COMMIT. After the first failure it skips further statements; commit() then rolls back and returns
/// that failure. A rollback by SQLite itself, as after a failed read, is such a failure: what followed would commit alone.
/// The destructor rolls back if commit() was not called.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  Database& database() noexcept { return database_; }
  /// False after a failure, and after SQLite has rolled back.
  bool ok();
  /// Makes the transaction fail, unless it has failed already.
  void refuse(StorageFailure failure) {
    if (!failure_) failure_ = std::move(failure);
  }
  template <class... Values>
  Transaction& run(std::string_view sql, const Values&... values) {
    if (ok()) {
      if (auto done = database_.run(sql, values...); !done) refuse(std::move(done.error()));
    }
    return *this;
  }
  /// First row, or nullopt: none, or the transaction has failed.
  template <class Read, class... Values>
  auto first(std::string_view sql, Read&& read, const Values&... values)
      -> std::optional<std::invoke_result_t<Read, Row>> {
    if (!ok()) return std::nullopt;
    auto found = database_.first(sql, std::forward<Read>(read), values...);
    if (!found) {
      refuse(std::move(found.error()));
      return std::nullopt;
    }
    return std::move(*found);
  }
  Stored<void> commit();

 private:
  Database& database_;
  std::optional<StorageFailure> failure_;
  bool open_ = false;
};

}  // namespace cusp::storage
