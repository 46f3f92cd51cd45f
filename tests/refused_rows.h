/// A table that takes no further row, as on a full disk, but at once.
#pragma once

#include <string>

#include "storage/sqlite/database.h"

namespace cusp::test {

/// By every connection: no connection runs the triggers of a file. Rows that fit `but` are taken. Pre: so do those that are there.
inline bool refuse_rows(storage::Database& database, const std::string& table, const std::string& but = "0") {
  return database.run("ALTER TABLE " + table + " ADD COLUMN refused INTEGER DEFAULT 0 CHECK (refused <> 0 OR " + but + ")").has_value();
}
inline bool take_rows(storage::Database& database, const std::string& table) {
  return database.run("ALTER TABLE " + table + " DROP COLUMN refused").has_value();
}

}  // namespace cusp::test
