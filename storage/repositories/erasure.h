/// What goes with an erased user besides the account. Within storage only.
#pragma once

#include "storage/base/rights.h"
#include "storage/records/context.h"

namespace cusp::storage {

/// Within a transaction: refuses it with not_found (where = people) if the user was erased, as another window may have done since a page was
/// read.
void require_not_erased(Transaction& transaction, UserId user);
/// Within a transaction: what comments and statements say about a student goes; the rows stay, and the log names each.
void erase_texts_about(StorageContext& context, Transaction& transaction, const Actor& actor, UserId student);
/// Within a transaction: the user is in no cohort any more; the log names each.
void leave_cohorts(StorageContext& context, Transaction& transaction, const Actor& actor, UserId user);

}  // namespace cusp::storage
