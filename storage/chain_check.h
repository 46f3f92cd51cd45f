/// What the verifiers share: a chain followed link by link, and the signature over its head. Within storage only.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "storage/verify.h"

namespace cusp::storage {

struct StoredLink {
  ChainLink link;
  Hash256 hash{};  // as stored
};

struct StoredHead {
  std::uint64_t links = 0;
  Hash256 link{}, key{};
  Signature signature{};
};

/// Zeros unless 64 bytes.
Signature signature_of(std::span<const std::byte> bytes);

/// Follows a chain of stored links. After one that does not hold, what comes next may follow either from the link as
/// stored (its entry was changed) or as reckoned (the link itself was): so one changed byte gives one finding.
class ChainFollower {
 public:
  explicit ChainFollower(Uuid owner) : owner_{owner}, stored_{chain_start(owner)}, reckoned_{stored_} {}
  bool follows(const StoredLink& entry);
  bool ends_in(const Hash256& link) const { return link == stored_ || link == reckoned_; }

 private:
  Uuid owner_;
  Hash256 stored_, reckoned_;
};

/// Key and signature of a head; what does not hold joins `findings` under the name of `table`.
void check_head(Database& db, const Uuid& owner, const StoredHead& head, const char* table,
                std::vector<ChainFinding>& findings);

}  // namespace cusp::storage
