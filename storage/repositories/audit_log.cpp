#include "storage/repositories/audit_log.h"

#include "storage/records/sealing.h"

namespace cusp::storage {

Stored<void> AuditLog::add(const AuditEvent& event) {
  Transaction transaction(c_.db);
  log_event(c_, transaction, event);
  return commit_sealed(c_, transaction);
}

Stored<std::vector<AuditEntry>> AuditLog::list(const Actor& actor, int limit, std::int64_t before_number) {
  if (auto allowed = require(actor, Action::see_audit_log); !allowed) return std::unexpected(allowed.error());
  return c_.db.all(
      "SELECT number, at, sequence, actor, action, subject, detail FROM audit_log WHERE number < ?1 "
      "ORDER BY number DESC LIMIT ?2",
      [](Row row) {
        return AuditEntry{row.integer(0), row.integer(1), row.integer(2), row.id<UserId>(3),
                          row.text(4),    row.uuid(5),    row.text(6)};
      },
      before_number, limit);
}

}  // namespace cusp::storage
