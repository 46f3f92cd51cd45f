/// The audit log as a list: who did what, without names. Its chain and head: storage/records/audit_writer.h.
#pragma once

#include <cstdint>
#include <vector>

#include "storage/base/rights.h"
#include "storage/records/audit_writer.h"

namespace cusp::storage {

class AuditLog {
 public:
  explicit AuditLog(StorageContext& context) : c_{context} {}
  /// One entry in a transaction of its own.
  Stored<void> add(const AuditEvent& event);
  /// Newest first, at most `limit`. Needs see_audit_log.
  Stored<std::vector<AuditEntry>> list(const Actor& actor, int limit, std::int64_t before_number = INT64_MAX);

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
