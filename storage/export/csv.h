/// Performance history as CSV: RFC 4180 (CRLF, quotes doubled), UTF-8, numbers with a point. A text that a spreadsheet
/// would take for a formula gets an apostrophe in front. Column names are stable keys, not sentences.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "storage/repositories/history.h"

namespace cusp::storage {

struct CsvOptions {
  bool byte_order_mark = false;  // some spreadsheets need one to see UTF-8
  std::string language = "en";   // of the exercise's title
};

/// One cell of text, quoted and guarded as needed.
std::string csv_text(std::string_view text);
/// Shortest decimal that reads back exactly; empty for NaN and infinities.
std::string csv_number(double value);

/// One line a session.
std::string history_csv(std::span<const HistoryRow> rows, const CsvOptions& options = {});
/// Needs export_results: the sessions that match. Leaves a line in the audit log.
Stored<std::string> export_history(StorageContext& context, const Actor& actor, const HistoryFilter& filter,
                                   const CsvOptions& options = {});
/// Needs export_results: one line a criterion of the newest grade of each session that matches.
Stored<std::string> export_criteria(StorageContext& context, const Actor& actor, const HistoryFilter& filter,
                                    const CsvOptions& options = {});

}  // namespace cusp::storage
