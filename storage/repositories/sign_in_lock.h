/// Wrong tries of a password or PIN, and the lock of the account that follows them. Private to storage/repositories. Thread: the
/// context's own.
#pragma once

#include "storage/records/context.h"
#include "storage/sqlite/database.h"

namespace cusp::storage {

/// Whether an account that is locked until `locked_until` is locked. Where the clock was set back, no lock lasts longer than the longest.
bool lock_holds(std::int64_t locked_until, std::int64_t now) noexcept;
/// `locked`, with the lock's end.
StorageFailure locked_failure(std::int64_t locked_until);
/// The later end of the written lock and of the one in memory. One that does not hold hides no other: a clock may have been set back.
std::int64_t locked_until(StorageContext& c, UserId user, std::int64_t written, std::int64_t now);

/// Within a transaction: from the fifth wrong try on the account is locked.
void count_wrong_try(StorageContext& c, Transaction& transaction, UserId user, std::int64_t now);
/// The same in memory, where the records are read-only.
void count_unwritten_try(StorageContext& c, UserId user, std::int64_t now);

}  // namespace cusp::storage
