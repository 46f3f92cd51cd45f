/// The main file of a connection, through SQLite's own handle. Any close() of the file outside SQLite drops the locks of
/// all connections of this process ("How To Corrupt An SQLite Database File", 2.2).
/// Thread: the connection's. Pre: the connection outlives it.
#pragma once

#include <sqlite3.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace cusp::storage {

/// Reads all of `to` from `at` on. SQLITE_OK, SQLITE_IOERR_SHORT_READ past the end (the rest is zeros), or an error.
int read_at(sqlite3_file* file, std::span<std::byte> to, std::int64_t at) noexcept;
/// nullopt if the file system gives no answer.
std::optional<std::int64_t> size_of(sqlite3_file* file) noexcept;

class MainFile {
 public:
  explicit MainFile(sqlite3* database) noexcept;
  ~MainFile() { unlock(); }
  MainFile(const MainFile&) = delete;
  MainFile& operator=(const MainFile&) = delete;

  sqlite3_file* handle() const noexcept { return file_; }
  /// SQLite's status. While the lock is held, no connection writes the main file or closes as the log's last.
  /// Pre: the connection has run no statement.
  int lock_shared() noexcept;
  /// SQLITE_OK: no connection of any process uses the file. SQLITE_BUSY: one does, or is about to.
  /// Pre: lock_shared() held; the file is open for writing.
  int lock_exclusive() noexcept;
  void unlock() noexcept;

 private:
  sqlite3_file* file_ = nullptr;
  bool locked_ = false;
};

}  // namespace cusp::storage
