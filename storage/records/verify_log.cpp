#include "storage/records/verify_log.h"

#include <utility>

#include "storage/records/chain_check.h"

namespace cusp::storage {

Stored<Verification> follow_audit_log(StorageContext& context, const Uuid& station,
                                      const std::function<void(const AuditEntry&)>& each) {
  Verification out;
  ChainFollower follower(station);
  std::uint64_t expected = 0;
  const auto read = [&](Row row) {
    const StoredLink entry{{row.u64(1), 0, row.u64(1), -1, row.content_hash(1)}, row.hash(0)};
    const bool gap = entry.link.position != expected;
    if (gap) out.findings.push_back({FindingCode::row_missing, "audit_log", static_cast<std::int64_t>(expected)});
    expected = entry.link.position + 1;
    ++out.links;
    // After a gap no link can follow; the gap is a finding already.
    if (!follower.follows(entry) && !gap) {
      out.findings.push_back({FindingCode::row_changed, "audit_log", row.integer(1), -1, {}, {}, row.integer(2)});
      return false;
    }
    each({row.integer(1), row.integer(2), row.integer(3), row.id<UserId>(4), row.text(5), row.uuid(6), row.text(7)});
    return true;
  };
  const auto rows = context.db.all(
      "SELECT link, number, at, sequence, actor, action, subject, detail FROM audit_log ORDER BY number", read);
  if (!rows) return std::unexpected(rows.error());
  const auto head = context.db.first("SELECT entries, link, key, signature FROM audit_head WHERE one = 1", [](Row row) {
    return SignedHead{{row.u64(0), row.hash(1)}, row.hash(2), signature_of(row.bytes(3))};
  });
  if (!head) return std::unexpected(head.error());
  if (!*head) {
    if (!rows->empty()) out.findings.push_back({FindingCode::row_missing, "audit_head"});
    return out;
  }
  check_head(context.db, station, **head, "audit_head", out.findings);
  if (out.findings.empty() && ((*head)->head.links != out.links || !follower.ends_in((*head)->head.link))) {
    out.findings.push_back({FindingCode::head_broken, "audit_head"});
  }
  return out;
}

Stored<Verification> verify_audit_log(StorageContext& context) {
  const Snapshot snapshot(context.db);
  return follow_audit_log(context, context.station, [](const AuditEntry&) {});
}

}  // namespace cusp::storage
