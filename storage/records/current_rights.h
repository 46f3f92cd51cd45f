/// Rights as they stand now: an administrator at another window may have switched the actor off, or changed the role, since sign-in.
/// Thread: the transaction's own.
#pragma once

#include "storage/base/rights.h"
#include "storage/sqlite/database.h"

namespace cusp::storage {

/// Refuses the transaction with `disabled` (where = actor) if the actor's account is switched off, with not_allowed (where = the
/// action's key) if its role has lost the right. Pre: require() has admitted the role of the sign-in, which counts alone for the program and for an actor
/// without an account here.
void require_now(Transaction& transaction, UserId actor, Action action);

}  // namespace cusp::storage
