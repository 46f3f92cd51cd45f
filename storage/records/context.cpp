#include "storage/records/context.h"

namespace cusp::storage {

std::int64_t StorageContext::next_sequence(Transaction& transaction) {
  return transaction
      .first("UPDATE station SET next_sequence = next_sequence + 1 RETURNING next_sequence - 1",
             [](Row row) { return row.integer(0); })
      .value_or(0);
}

}  // namespace cusp::storage
