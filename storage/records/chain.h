/// The hash chain of a session's rows, and of the audit log's entries.
///
///   link 0 = H(label, owner)      link n = H(link n-1, owner, n, table, row, second, content n)
///
/// Content n is the hash of every column of one row. The station signs the head (count, last link) after each
/// transaction, so that a cut-off tail shows (station_key.h). A chain covers pseudonymous ids, never names: erasing a
/// user leaves it whole.
#pragma once

#include <cstdint>

#include "engine/base/ids.h"
#include "storage/base/hash.h"

namespace cusp::storage {

/// One entry of a chain.
struct ChainLink {
  std::uint64_t position = 0;  // 0, 1, 2 ... without gaps
  std::uint64_t table = 0;     // number of the chained table (session_tables.h)
  std::uint64_t row = 0;       // the row's number within that table and session
  std::int64_t second = -1;    // second of the session; -1 for a row without a time
  Hash256 content{};           // hash of the row
};

/// The link before position 0. `owner`: the session, or the station for the audit log.
Hash256 chain_start(const Uuid& owner);
Hash256 chain_link(const Hash256& before, const Uuid& owner, const ChainLink& link);

/// A chain's length and last link: what the station signs.
struct ChainHead {
  std::uint64_t links = 0;
  Hash256 link{};
};

}  // namespace cusp::storage
