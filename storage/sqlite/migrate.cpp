#include "storage/sqlite/migrate.h"

#include <string>

namespace cusp::storage {
namespace {

Stored<void> run_each(Database& database, std::span<const std::string_view> migrations) {
  const auto newest = static_cast<int>(migrations.size());
  while (true) {
    Transaction transaction(database);
    // Reads within the transaction: another process may have migrated the file meanwhile.
    const auto version =
        transaction.first("PRAGMA user_version", [](Row row) { return static_cast<int>(row.integer(0)); });
    if (!version) return transaction.commit();
    if (*version > newest) {
      return fail(StorageError::newer_schema, database.file().string(), std::to_string(*version));
    }
    if (*version == newest) return {};
    if (auto done = database.script(std::string(migrations[static_cast<std::size_t>(*version)])); !done) {
      transaction.refuse(std::move(done.error()));
    }
    // A pragma takes no parameter; the number is no user's input.
    transaction.run("PRAGMA user_version = " + std::to_string(*version + 1));
    if (auto done = transaction.commit(); !done) return done;
  }
}

}  // namespace

Stored<void> migrate(Database& database, std::span<const std::string_view> migrations) {
  if (database.schema_version() == static_cast<int>(migrations.size())) return {};
  const auto enforced = database.first("PRAGMA foreign_keys", [](Row row) { return row.flag(0); });
  if (!enforced) return std::unexpected(enforced.error());
  // A migration may make a table anew, and a row of a damaged file may refer to none: verification names it afterwards.
  if (auto done = database.run("PRAGMA foreign_keys = OFF"); !done) return done;
  if (auto done = database.run("PRAGMA ignore_check_constraints = ON"); !done) return done;
  auto done = run_each(database, migrations);
  if (const auto checked = database.run("PRAGMA ignore_check_constraints = OFF"); done && !checked) done = checked;
  if (!enforced->value_or(false)) return done;
  const auto again = database.run("PRAGMA foreign_keys = ON");
  return done ? again : done;
}

}  // namespace cusp::storage
