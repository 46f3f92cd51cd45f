#include "ui/text/audit_log_text.h"

#include <charconv>
#include <optional>
#include <string_view>

#include "ui/text/text.h"

namespace cusp::ui {
namespace {

struct Entry {
  std::string_view action;
  LogKind kind;
  const char* text;
};

constexpr Entry kEntries[] = {
    {"signed_in", LogKind::sign_ins, QT_TRANSLATE_NOOP("cusp::ui::Text", "Signed in")},
    {"sign_in_failed", LogKind::sign_ins, QT_TRANSLATE_NOOP("cusp::ui::Text", "Sign-in failed: wrong password or PIN")},
    {"account_created", LogKind::accounts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Account created")},
    {"account_renamed", LogKind::accounts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Name or number of an account changed")},
    {"role_changed", LogKind::accounts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Role of an account changed")},
    {"account_disabled", LogKind::accounts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Account disabled")},
    {"account_enabled", LogKind::accounts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Account enabled")},
    {"password_changed", LogKind::accounts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Password changed")},
    {"pin_changed", LogKind::accounts, QT_TRANSLATE_NOOP("cusp::ui::Text", "PIN changed")},
    {"person_erased", LogKind::accounts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Person erased")},
    {"comment_erased", LogKind::accounts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Text of a comment erased")},
    {"statement_erased", LogKind::accounts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Text of a statement erased")},
    {"person_sealed", LogKind::accounts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Account sealed as it was found")},
    {"cohort_created", LogKind::cohorts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Cohort created")},
    {"cohort_joined", LogKind::cohorts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Student added to a cohort")},
    {"cohort_left", LogKind::cohorts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Student taken out of a cohort")},
    {"cohort_sealed", LogKind::cohorts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Cohort sealed as it was found")},
    {"assigned", LogKind::cohorts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Exercise assigned")},
    {"assignment_withdrawn", LogKind::cohorts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Assignment withdrawn")},
    {"assignment_withdrawal_sealed", LogKind::cohorts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Withdrawal of an assignment sealed as it was found")},
    {"assessment_set", LogKind::cohorts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Assessment set")},
    {"adjusted", LogKind::cohorts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Adjustment of a student set")},
    {"adjustment_sealed", LogKind::cohorts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Adjustment of a student sealed as it was found")},
    {"assignment_sealed", LogKind::cohorts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Assignment sealed as it was found")},
    {"assessment_sealed", LogKind::cohorts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Assessment sealed as it was found")},
    {"version_published", LogKind::exercises, QT_TRANSLATE_NOOP("cusp::ui::Text", "Version of an exercise published")},
    {"version_kept", LogKind::exercises, QT_TRANSLATE_NOOP("cusp::ui::Text", "Version of an exercise kept")},
    {"version_withdrawn", LogKind::exercises, QT_TRANSLATE_NOOP("cusp::ui::Text", "Version of an exercise withdrawn")},
    {"version_sealed", LogKind::exercises, QT_TRANSLATE_NOOP("cusp::ui::Text", "Version of an exercise sealed as it was found")},
    {"withdrawal_sealed", LogKind::exercises, QT_TRANSLATE_NOOP("cusp::ui::Text", "Withdrawal of a version sealed as it was found")},
    {"session_sealed", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Attempt sealed as it was found")},
    {"stated", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Statement about an attempt signed")},
    {"statement_sealed", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Statement about an attempt sealed as it was found")},
    {"comment_sealed", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Comment sealed as it was found")},
    {"trace_thinned", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Recording of an attempt thinned")},
    {"thinning_sealed", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Thinning of a recording sealed as it was found")},
    {"trace_returned", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Thinned recording came back in another station’s file")},
    {"backed_up", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Records backed up")},
    {"restored", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Records restored from a backup")},
    {"packed", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Attempt saved as an appeal pack")},
    {"history_exported", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Attempts exported as a list")},
    {"gradebook_exported", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Results exported for a gradebook")},
    {"log_exported", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Audit log exported as a list")},
    {"exchange_given_out", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "File for other stations given out")},
    {"exchange_read_in", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "File of another station read in")},
    {"exchange_file_known", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "File of another station named by its station")},
    {"key_trusted", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Key of another station trusted")},
    {"key_role_changed", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Trust in another station’s key changed")},
    {"key_revoked", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Key of another station revoked")},
    {"key_kept", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Former key of another station kept")},
    {"other_key_sealed", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Key of another station sealed as it was found")},
    {"referred", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Named by another station’s records")},
    {"arrived", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Arrived from the office after others named it")},
    {"referred_sealed", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Name from another station sealed as it was found")},
    {"summaries_rebuilt", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Lists made anew from the records")},
    {"device_tested", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Self-test of a device")},
    {"station_key_added", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Key of this station added")},
    {"sealing_began", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Sealing of the records began")},
    {"log_damaged", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Audit log found changed at its end")},
    {"counter_missing", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Counter beside the records’ key found missing")},
    {"counter_broken", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Counter beside the records’ key found changed")},
    {"rolled_back", LogKind::records, QT_TRANSLATE_NOOP("cusp::ui::Text", "Records found older than their counter")},
};

/// First word of the detail of "session_sealed".
constexpr Entry kSessionEvents[] = {
    {"started", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Attempt started")},
    {"interrupted", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Attempt interrupted")},
    {"resumed", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Attempt resumed")},
    {"finished", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Attempt finished")},
    {"graded", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Attempt graded")},
    {"closed", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Attempt closed")},
    {"read_in", LogKind::attempts, QT_TRANSLATE_NOOP("cusp::ui::Text", "Attempt read in from another station")},
};

/// The count in a detail that is one number.
std::optional<int> count_of(std::string_view detail) {
  int count = 0;
  const auto [end, error] = std::from_chars(detail.data(), detail.data() + detail.size(), count);
  if (error != std::errc() || end != detail.data() + detail.size()) return std::nullopt;
  return count;
}

}  // namespace

QString log_kind_name(LogKind kind) {
  switch (kind) {
    case LogKind::sign_ins: return Text::tr("Sign-ins");
    case LogKind::accounts: return Text::tr("Accounts");
    case LogKind::cohorts: return Text::tr("Cohorts and assignments");
    case LogKind::exercises: return Text::tr("Exercises");
    case LogKind::attempts: return Text::tr("Attempts");
    case LogKind::records: return Text::tr("Records and exports");
  }
  return {};
}

std::vector<std::string> actions_of(LogKind kind) {
  std::vector<std::string> out;
  for (const Entry& entry : kEntries)
    if (entry.kind == kind) out.emplace_back(entry.action);
  return out;
}

QString entry_text(const AuditEntry& entry) {
  const auto count = count_of(entry.detail);
  if (entry.action == "sign_in_failed" && count) return Text::tr("Sign-in failed, %n wrong time(s) in a row", nullptr, *count);
  if (entry.action == "backed_up" && count) return Text::tr("Records backed up, %n session(s)", nullptr, *count);
  if (entry.action == "log_exported" && count) return Text::tr("Audit log exported, %n entry(ies)", nullptr, *count);
  if (entry.action == "session_sealed") {
    const std::string_view event = std::string_view(entry.detail).substr(0, entry.detail.find(' '));
    for (const Entry& e : kSessionEvents)
      if (e.action == event) return Text::tr(e.text);
  }
  for (const Entry& e : kEntries)
    if (e.action == entry.action) return Text::tr(e.text);
  return text(entry.action);
}

}  // namespace cusp::ui
