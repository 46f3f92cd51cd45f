/// Reads the audit log once, link by link. Within storage only.
#pragma once

#include <functional>

#include "storage/repositories/audit_log.h"
#include "storage/verify.h"

namespace cusp::storage {

/// Entries that hold go to `each`, in order. `station`: whose log it is.
Stored<Verification> follow_audit_log(StorageContext& context, const Uuid& station,
                                      const std::function<void(const AuditEntry&)>& each);

}  // namespace cusp::storage
