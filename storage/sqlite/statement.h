/// One prepared statement. Values are bound, never pasted into SQL; the destructor finalises it.
/// Thread: the database's own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/ids.h"
#include "storage/base/error.h"
#include "storage/base/hash.h"

struct sqlite3;
struct sqlite3_stmt;

namespace cusp::storage {

/// The current row of a statement. Columns count from 0; valid until the next step().
class Row {
 public:
  explicit Row(sqlite3_stmt* statement) noexcept : statement_{statement} {}
  int columns() const noexcept;
  bool is_null(int column) const noexcept;
  std::int64_t integer(int column) const noexcept;
  std::uint64_t u64(int column) const noexcept { return static_cast<std::uint64_t>(integer(column)); }
  bool flag(int column) const noexcept { return integer(column) != 0; }
  double real(int column) const noexcept;  // NaN when null: NaN is stored as null
  std::string text(int column) const;
  std::span<const std::byte> bytes(int column) const noexcept;
  std::vector<std::byte> blob(int column) const;
  Uuid uuid(int column) const noexcept;     // nil unless 16 bytes
  Hash256 hash(int column) const noexcept;  // zeros unless 32 bytes
  template <class I>
  I id(int column) const noexcept {
    return I{uuid(column)};
  }
  std::optional<std::int64_t> maybe_integer(int column) const noexcept {
    return is_null(column) ? std::nullopt : std::optional{integer(column)};
  }
  std::optional<double> maybe_real(int column) const noexcept {
    return is_null(column) ? std::nullopt : std::optional{real(column)};
  }
  /// Same type and bytes in this column of both rows.
  bool same_value(int column, const Row& other) const;
  /// Hash of `first` and every column after it, with its type; of those before `end` alone if there is one.
  Hash256 content_hash(int first = 0, std::optional<int> end = {}) const;

 private:
  sqlite3_stmt* statement_;
};

class Statement {
 public:
  /// step() reports a failure to prepare.
  Statement(sqlite3* database, std::string_view sql);
  ~Statement();
  Statement(Statement&& other) noexcept;
  Statement& operator=(Statement&&) = delete;
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  /// Binds all parameters in order, from ?1 on. Integers, bool, double, text, bytes, ids, hashes, optionals, nullptr.
  template <class... Values>
  Statement& bind(const Values&... values) {
    reset();
    int at = 0;
    (put(++at, values), ...);
    return *this;
  }
  /// True: on a row. False: done.
  Stored<bool> step();
  Row row() const noexcept { return Row{statement_}; }
  void reset() noexcept;

 private:
  void put(int at, std::nullptr_t);
  void put(int at, std::int64_t value);
  void put(int at, int value) { put(at, std::int64_t{value}); }
  void put(int at, std::uint64_t value) { put(at, static_cast<std::int64_t>(value)); }
  void put(int at, bool value) { put(at, std::int64_t{value}); }
  void put(int at, double value);
  void put(int at, std::string_view value);
  void put(int at, const std::string& value) { put(at, std::string_view{value}); }
  void put(int at, const char* value) { put(at, std::string_view{value}); }
  void put(int at, std::span<const std::byte> value);
  void put(int at, const std::vector<std::byte>& value) { put(at, std::span<const std::byte>{value}); }
  template <std::size_t N>
  void put(int at, const std::array<std::uint8_t, N>& value) {
    put(at, std::as_bytes(std::span{value}));
  }
  void put(int at, const Uuid& value) { put(at, value.bytes); }
  template <class Tag>
  void put(int at, const Id<Tag>& value) {
    put(at, value.uuid);
  }
  template <class T>
  void put(int at, const std::optional<T>& value) {
    if (value) {
      put(at, *value);
    } else {
      put(at, nullptr);
    }
  }

  sqlite3* database_;
  sqlite3_stmt* statement_ = nullptr;
  int status_ = 0;  // first failure of prepare or bind
};

/// SQLite's status as a failure of storage. `where`: the database's file unless given. Without a database the system's
/// errno is unknown, and a failed read or write is io.
StorageFailure failure_of(sqlite3* database, int status, std::string where = {});

}  // namespace cusp::storage
