/// Appends to the audit log: a hash chain of its own, with a signed head. Entries hold ids, codes and seals, never names.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "storage/records/context.h"

namespace cusp::storage {

/// An entry as the log stores it.
struct AuditEntry {
  std::int64_t number = 0;
  std::int64_t at_utc_us = 0;
  std::int64_t sequence = 0;
  UserId actor;        // nil = the program
  std::string action;  // code: "account_created", "sign_in_failed", "version_published", ...
  Uuid subject;        // what the action concerns; nil = nothing
  std::string detail;  // codes, numbers and seals (seals.h)
};

/// The number of an entry as people read it: the log counts from 0.
constexpr std::int64_t shown_number(std::int64_t number) noexcept { return number + 1; }

/// An entry to append; the fields mean what they mean in AuditEntry.
struct AuditEvent {
  UserId actor{};
  std::string_view action;
  Uuid subject{};
  std::string_view detail{};
};

/// Appends entries within the transaction that performs the action. finish() signs the head once, last.
class AuditWriter {
 public:
  /// If the head does not hold, or is gone while entries exist, the entry "log_damaged" comes first, and the chain
  /// continues from the last entry.
  AuditWriter(StorageContext& context, Transaction& transaction);
  void add(const AuditEvent& event);
  void finish();

 private:
  StorageContext& context_;
  Transaction& transaction_;
  ChainHead head_;
};

/// One entry, and the signed head.
void log_event(StorageContext& context, Transaction& transaction, const AuditEvent& event);

}  // namespace cusp::storage
