#include "storage/summary/records_size.h"

namespace cusp::storage {

Stored<RecordsSize> records_size(Database& db) {
  // SQLite counts the pages of the log that are not in the file yet.
  const auto size = db.first(
      "SELECT (SELECT count(*) FROM session_summaries), page_count * page_size, page_size FROM pragma_page_count(), pragma_page_size()",
      [](Row row) { return RecordsSize{row.u64(0), row.u64(1), row.u64(2)}; });
  if (!size) return std::unexpected(size.error());
  return size->value_or(RecordsSize{});
}

}  // namespace cusp::storage
