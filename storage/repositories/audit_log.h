/// The audit log as a list by pages, and its verification: who did what, without names. Its chain and head:
/// storage/records/audit_writer.h.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "storage/base/rights.h"
#include "storage/records/audit_writer.h"
#include "storage/records/verify.h"

namespace cusp::storage {

/// Which entries a list has; an empty member leaves none out.
struct AuditFilter {
  std::vector<std::string> actions{};                      // codes, without blanks
  std::optional<UserId> person{};                          // who acted, or whom it concerns; nil = the program acted
  std::optional<std::int64_t> from_utc_us{}, to_utc_us{};  // from <= at < to
};

class AuditLog {
 public:
  explicit AuditLog(StorageContext& context) : c_{context} {}
  /// One entry in a transaction of its own.
  Stored<void> add(const AuditEvent& event);
  /// The same, unless the actor has lost the right since sign-in (current_rights.h).
  Stored<void> add_if_allowed(const AuditEvent& event, Action action);
  /// Newest first, at most `limit`, those below `before_number`: the last number of a page begins the next. By number; with
  /// a filter by time, then by number. Needs see_audit_log.
  Stored<std::vector<AuditEntry>> list(const Actor& actor, int limit, std::int64_t before_number = INT64_MAX,
                                       const AuditFilter& filter = {});
  /// verify_audit_log(); `each` gets the number of each entry that holds, in order. Needs see_audit_log.
  Stored<Verification> verify(const Actor& actor, const std::function<void(std::int64_t number)>& each);

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
