/// Who did what to whom, without names, hash-chained, its head signed: a line that was changed or taken out shows.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "storage/context.h"
#include "storage/rights.h"

namespace cusp::storage {

struct AuditEntry {
  std::int64_t number = 0;
  std::int64_t at_utc_us = 0;
  std::int64_t sequence = 0;
  UserId actor;        // nil = the program
  std::string action;  // code: "account_created", "sign_in_failed", "version_published", ...
  Uuid subject;        // whom or what it was done to; nil = nothing
  std::string detail;  // codes, numbers and seals (storage/sealing.h), never names
};

/// Appends entries within the transaction that does the thing, and signs the log's head once, last.
class AuditWriter {
 public:
  /// A head that does not hold, or that is gone while entries are there, is not signed over in silence: the entry
  /// "log_damaged" comes first, and the log goes on behind its last entry.
  AuditWriter(StorageContext& context, Transaction& transaction);
  void add(UserId actor, std::string_view action, Uuid subject, std::string_view detail = {});
  void finish();

 private:
  StorageContext& context_;
  Transaction& transaction_;
  std::uint64_t entries_ = 0;
  Hash256 link_{};
};

class AuditLog {
 public:
  explicit AuditLog(StorageContext& context) : c_{context} {}
  /// One entry, within the transaction that does the thing.
  static void add(StorageContext& context, Transaction& transaction, UserId actor, std::string_view action,
                  Uuid subject, std::string_view detail = {});
  /// In a transaction of its own.
  Stored<void> add(UserId actor, std::string_view action, Uuid subject, std::string_view detail = {});
  /// Needs see_audit_log. Newest first.
  Stored<std::vector<AuditEntry>> list(const Actor& actor, int limit, std::int64_t before_number = INT64_MAX);

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
