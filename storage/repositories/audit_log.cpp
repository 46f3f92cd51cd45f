#include "storage/repositories/audit_log.h"

#include "storage/records/sealing.h"
#include "storage/records/verify_log.h"

namespace cusp::storage {

namespace {

/// " a b ": a code stands in it with a blank on both sides. Empty: every code.
std::string joined(const std::vector<std::string>& actions) {
  std::string out;
  for (const std::string& action : actions) out += (out.empty() ? " " : "") + action + ' ';
  return out;
}

}  // namespace

Stored<void> AuditLog::add(const AuditEvent& event) {
  Transaction transaction(c_.db);
  log_event(c_, transaction, event);
  return commit_sealed(c_, transaction);
}

Stored<std::vector<AuditEntry>> AuditLog::list(const Actor& actor, int limit, std::int64_t before_number, const AuditFilter& filter) {
  if (auto allowed = require(actor, Action::see_audit_log); !allowed) return std::unexpected(allowed.error());
  return c_.db.all(
      "SELECT number, at, sequence, actor, action, subject, detail FROM audit_log WHERE number < ?1 "
      "AND at >= ?3 AND at < ?4 AND (?5 IS NULL OR actor = ?5 OR subject = ?5) "
      "AND (?6 = '' OR instr(?6, ' ' || action || ' ') > 0) ORDER BY number DESC LIMIT ?2",
      [](Row row) {
        return AuditEntry{row.integer(0), row.integer(1), row.integer(2), row.id<UserId>(3),
                          row.text(4),    row.uuid(5),    row.text(6)};
      },
      before_number, limit, filter.from_utc_us.value_or(INT64_MIN), filter.to_utc_us.value_or(INT64_MAX), filter.person,
      joined(filter.actions));
}

Stored<Verification> AuditLog::verify(const Actor& actor, const std::function<void(std::int64_t number)>& each) {
  if (auto allowed = require(actor, Action::see_audit_log); !allowed) return std::unexpected(allowed.error());
  const Snapshot snapshot(c_.db);
  return follow_audit_log(c_, c_.station, [&each](const AuditEntry& entry) { each(entry.number); });
}

}  // namespace cusp::storage
