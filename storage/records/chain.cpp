#include "storage/records/chain.h"

namespace cusp::storage {

Hash256 chain_start(const Uuid& owner) { return Blake2b{}.add_text("cusp chain 1").add_uuid(owner).finish(); }

Hash256 chain_link(const Hash256& before, const Uuid& owner, const ChainLink& link) {
  return Blake2b{}
      .add_hash(before)
      .add_uuid(owner)
      .add_u64(link.position)
      .add_u64(link.table)
      .add_u64(link.row)
      .add_u64(static_cast<std::uint64_t>(link.second))
      .add_hash(link.content)
      .finish();
}

}  // namespace cusp::storage
