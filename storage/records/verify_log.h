/// Reads the audit log once, link by link. Within storage only.
#pragma once

#include <functional>

#include "storage/records/audit_writer.h"
#include "storage/records/verify.h"

namespace cusp::storage {

/// Passes each entry that holds to `each`, in order. `station`: the owner of the log.
Stored<Verification> follow_audit_log(StorageContext& context, const Uuid& station,
                                      const std::function<void(const AuditEntry&)>& each);

}  // namespace cusp::storage
