/// History as CSV: RFC 4180 (CRLF, doubled quotes), UTF-8, numbers with a point. A text that a spreadsheet would take for
/// a formula gets an apostrophe in front, also after a semicolon, a tab or a line's end within. Column names are stable keys.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "storage/records/audit_writer.h"
#include "storage/summary/attempt_dates.h"
#include "storage/summary/history.h"

namespace cusp::storage {

/// First in a file that people open: without it a spreadsheet may read UTF-8 as the system's older encoding.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

struct CsvOptions {
  bool byte_order_mark = false;
  std::string language = "en";  // of the exercise's title
};

/// One cell of text, quoted and guarded against formulas.
std::string csv_text(std::string_view text);
/// Shortest decimal that reads back exactly; empty for NaN and infinities.
std::string csv_number(double value);

/// In the language, else in English, else in any that there is.
std::string title_in(const LocalText& title, const std::string& language);

/// Of a user, cohort or exercise; empty if it has none.
using NameOf = std::function<std::string(const Uuid&)>;
/// Entries of the audit log: codes and ids as stored, names beside them.
std::string audit_csv_head();
std::string audit_csv_line(const AuditEntry& entry, const NameOf& name_of);

struct ExportRow {
  HistoryRow attempt;
  AttemptDates dates;
};
inline constexpr std::size_t kExportedAtOnce = 1000;  // rows
/// Takes the next rows of `all`; false stops the export.
using TakeRows = std::function<Stored<bool>(std::span<const ExportRow> rows, std::size_t all)>;
/// Sessions that match, newest first, as of one moment, at most kExportedAtOnce in one call of `take`; without a session one call
/// with no rows. Needs export_results, at the end as the records have it then; adds an entry to the audit log. Returns how many;
/// nullopt: stopped, and no entry. `written`, called between the last rows and the entry, closes what was written: if it fails, there
/// is no entry.
Stored<std::optional<std::size_t>> export_rows(StorageContext& context, const Actor& actor, const HistoryFilter& filter,
                                               const TakeRows& take, const std::function<Stored<void>()>& written = {});
/// What history_csv() writes: a file's beginning has the names of the columns.
enum class CsvPart : std::uint8_t { beginning, further };
/// One line per session. Times are ISO 8601, UTC; opens_utc and due_utc are the assignment's.
std::string history_csv(std::span<const ExportRow> rows, CsvPart part, const CsvOptions& options = {});

}  // namespace cusp::storage
