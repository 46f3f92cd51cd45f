/// The rows of one query, one after the other, for two queries that are compared in step. Thread: the database's own.
#pragma once

#include <string_view>

#include "storage/sqlite/database.h"

namespace cusp::storage {

class RowStream {
 public:
  RowStream(Database& db, std::string_view sql) : statement_{db.prepare(sql)} {}
  /// Takes the next row; the first call takes the first.
  Stored<void> next() {
    auto more = statement_.step();
    if (!more) return std::unexpected(more.error());
    there_ = *more;
    return {};
  }
  /// False after the last row.
  bool there() const noexcept { return there_; }
  /// Pre: there().
  Row row() const noexcept { return statement_.row(); }

 private:
  Statement statement_;
  bool there_ = false;
};

}  // namespace cusp::storage
