#include "storage/retention/log_order.h"

namespace cusp::storage {

Stored<std::int64_t> first_sequence_since(StorageContext& context, std::int64_t before_utc_us, std::int64_t now_utc_us) {
  const auto first = context.db.first("SELECT sequence FROM audit_log WHERE at > ?1 AND at <= ?2 ORDER BY number LIMIT 1",
                                      [](Row row) { return row.integer(0); }, before_utc_us, now_utc_us);
  if (!first) return std::unexpected(first.error());
  return first->value_or(INT64_MAX);
}

}  // namespace cusp::storage
