/// Text for the audit log: kinds of entries, and each entry in words. Who and whom: the page has the names. Thread: any.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "storage/records/audit_writer.h"
#include "ui/modules.h"

namespace cusp::ui {

/// What an entry is about, as the page's filter groups them.
enum class LogKind : std::uint8_t { sign_ins, accounts, cohorts, exercises, attempts, records };
inline constexpr int kLogKinds = 6;

QString log_kind_name(LogKind kind);
/// The codes of a kind.
std::vector<std::string> actions_of(LogKind kind);
/// "Account disabled", "Attempt finished"; the code itself where there is no text.
QString entry_text(const AuditEntry& entry);

}  // namespace cusp::ui
