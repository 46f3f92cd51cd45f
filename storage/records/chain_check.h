/// What the verifiers share: a chain followed link by link, and the signature over its head. Within storage only.
#pragma once

#include <string_view>
#include <vector>

#include "storage/records/verify.h"

namespace cusp::storage {

struct StoredLink {
  ChainLink link;
  Hash256 hash{};  // as stored
};

/// Follows a chain of stored links. After a link that does not hold, the next one may continue from the stored hash (if
/// its entry was changed) or from the computed one (if the hash was changed). So one changed byte gives one finding.
class ChainFollower {
 public:
  explicit ChainFollower(Uuid owner) : owner_{owner}, stored_{chain_start(owner)}, computed_{stored_} {}
  bool follows(const StoredLink& entry);
  bool ends_in(const Hash256& link) const { return link == stored_ || link == computed_; }

 private:
  Uuid owner_;
  Hash256 stored_, computed_;
};

/// Checks key and signature of a head. A finding carries the name of `table`, or of station_keys.
void check_head(Database& db, const Uuid& owner, const SignedHead& head, std::string_view table,
                std::vector<ChainFinding>& findings);

}  // namespace cusp::storage
