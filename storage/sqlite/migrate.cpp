#include "storage/sqlite/migrate.h"

#include <string>

namespace cusp::storage {

Stored<void> migrate(Database& database, std::span<const std::string_view> migrations) {
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

}  // namespace cusp::storage
