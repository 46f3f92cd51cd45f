#include "storage/export/csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "storage/repositories/audit_log.h"

namespace cusp::storage {
namespace {

/// One line: cells with commas between, CRLF at the end.
class Line {
 public:
  explicit Line(std::string& out) : out_{out} {}
  ~Line() { out_ += "\r\n"; }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  Line& text(std::string_view value) { return raw(csv_text(value)); }
  Line& number(double value) { return raw(csv_number(value)); }
  Line& number(const std::optional<double>& value) { return raw(value ? csv_number(*value) : std::string{}); }
  Line& integer(std::int64_t value) { return raw(std::to_string(value)); }
  Line& time(const std::optional<std::int64_t>& utc_us) { return raw(utc_us ? iso_utc(*utc_us) : std::string{}); }
  Line& flag(const std::optional<bool>& value) { return raw(value ? (*value ? "1" : "0") : ""); }
  Line& raw(std::string_view cell) {
    if (!first_) out_ += ',';
    first_ = false;
    out_ += cell;
    return *this;
  }

 private:
  std::string& out_;
  bool first_ = true;
};

std::string joined(const std::vector<std::string>& keys) {
  std::string out;
  for (const std::string& key : keys) out += (out.empty() ? "" : " ") + key;
  return out;
}

std::string begin(const CsvOptions& options, std::string_view head) {
  return std::string(options.byte_order_mark ? kByteOrderMark : "") + std::string(head) + "\r\n";
}

/// Logs the export, unless the file is open read-only.
Stored<void> note(StorageContext& context, const Actor& actor, std::string_view action, std::size_t lines) {
  if (context.db.read_only()) return {};
  return AuditLog(context).add_if_allowed({.actor = actor.id, .action = action, .detail = std::to_string(lines)}, Action::export_results);
}

Stored<std::vector<ExportRow>> dated(Database& db, std::vector<HistoryRow> rows) {
  auto dates = dates_of(db, rows);
  if (!dates) return std::unexpected(dates.error());
  std::vector<ExportRow> out;
  out.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) out.push_back({std::move(rows[i]), std::move((*dates)[i])});
  return out;
}

/// How many were taken; nullopt: stopped.
Stored<std::optional<std::size_t>> give_rows(StorageContext& context, const Actor& actor, const HistoryFilter& filter, const TakeRows& take) {
  History history(context);
  const Snapshot snapshot(context.db);
  const auto all = history.count(actor, filter);
  if (!all) return std::unexpected(all.error());
  std::size_t given = 0, read = 0;
  std::optional<HistoryKey> after;
  do {
    auto page = history.page(actor, filter, after, static_cast<int>(std::clamp<std::size_t>(*all - read, 1, kExportedAtOnce)));
    if (!page) return std::unexpected(page.error());
    const auto rows = dated(context.db, std::move(page->rows));
    if (!rows) return std::unexpected(rows.error());
    const auto taken = take(*rows, *all);
    if (!taken) return std::unexpected(taken.error());
    if (!*taken) return std::optional<std::size_t>{};
    given += rows->size();
    read = std::min(*all, read + kExportedAtOnce);
    after = page->after;
  } while (after && read < *all);
  return std::optional(given);
}

constexpr std::string_view kDatesHead = ",finished_utc,cohort,opens_utc,due_utc";
void add_dates(Line& line, const AttemptDates& dates) {
  line.time(dates.finished_utc_us).text(dates.cohort).time(dates.opens_utc_us).time(dates.due_utc_us);
}

/// Whether a spreadsheet takes a cell that begins so for a formula, in full width too. Source: OWASP, "CSV Injection".
bool begins_formula(std::string_view text) {
  constexpr std::array<std::string_view, 8> signs = {"=", "+", "-", "@", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};
  return std::ranges::any_of(signs, [&](std::string_view sign) { return text.starts_with(sign); });
}

}  // namespace

std::string csv_text(std::string_view text) {
  std::string out;
  if (!text.empty() && (begins_formula(text) || std::string_view("\t\r\n").contains(text.front()))) out += '\'';
  bool quote = false;
  char before = '\0';  // the last character but quotes, which a spreadsheet takes off
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    quote = quote || c == '"' || c == ',' || c == '\r' || c == '\n';
    // A spreadsheet that parts columns by semicolons or tabs begins a cell here, also after a line's end within quotes.
    if (std::string_view(";\t\r\n").contains(before) && begins_formula(text.substr(i))) out += '\'';
    if (c == '"') out += '"';
    out += c;
    if (c != '"') before = c;
  }
  quote = quote || (!text.empty() && (text.front() == ' ' || text.back() == ' '));
  return quote ? '"' + out + '"' : out;
}

std::string csv_number(double value) {
  if (!std::isfinite(value)) return {};
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return {text, end.ptr};
}

std::string title_in(const LocalText& title, const std::string& language) {
  for (const std::string& wanted : {language, std::string("en")}) {
    if (const auto found = title.find(wanted); found != title.end()) return found->second;
  }
  return title.empty() ? std::string{} : title.begin()->second;
}

std::string audit_csv_head() { return "number,at,actor,actor_name,action,subject,subject_name,detail\r\n"; }

std::string audit_csv_line(const AuditEntry& entry, const NameOf& name_of) {
  std::string out;
  const auto id = [](const Uuid& uuid) { return uuid.is_nil() ? std::string() : uuid.text(); };
  Line(out)
      .integer(shown_number(entry.number))
      .text(iso_utc(entry.at_utc_us))
      .text(id(entry.actor.uuid))
      .text(name_of(entry.actor.uuid))
      .text(entry.action)
      .text(id(entry.subject))
      .text(name_of(entry.subject))
      .text(entry.detail);
  return out;
}

Stored<std::optional<std::size_t>> export_rows(StorageContext& context, const Actor& actor, const HistoryFilter& filter,
                                               const TakeRows& take, const std::function<Stored<void>()>& written) {
  if (auto allowed = require(actor, Action::export_results); !allowed) return std::unexpected(allowed.error());
  const auto taken = give_rows(context, actor, filter, take);
  if (!taken || !*taken) return taken;
  if (written) {
    if (auto done = written(); !done) return std::unexpected(done.error());
  }
  if (auto noted = note(context, actor, "history_exported", **taken); !noted) return std::unexpected(noted.error());
  return taken;
}

std::string history_csv(std::span<const ExportRow> rows, CsvPart part, const CsvOptions& options) {
  std::string out;
  if (part == CsvPart::beginning) {
    out = begin(options,
                "session,started_utc,student_number,student_name,exercise,exercise_key,version,kind,hand,device,"
                "device_class,go,duration_s,state,score,score_max,pass_mark,passed,critical,assignment,released" +
                    std::string(kDatesHead));
  }
  for (const auto& [r, dates] : rows) {
    Line line(out);
    line.text(r.session.text())
        .text(iso_utc(r.started_utc_us))
        .text(r.student_number)
        .text(r.student_name)
        .text(title_in(r.title, options.language))
        .text(r.scenario_key)
        .integer(r.version_number)
        .text(key_of(r.kind))
        .text(r.operator_name)
        .text(r.device)
        .text(r.device_class)
        .integer(r.attempt)
        .number(static_cast<double>(r.elapsed_us) / 1e6)
        .text(key_of(r.state))
        .number(r.score)
        .number(r.score_max)
        .number(r.pass_mark)
        .flag(r.passed)
        .text(joined(r.critical))
        .text(r.assignment ? r.assignment->text() : std::string())
        .flag(r.released);
    add_dates(line, dates);
  }
  return out;
}

}  // namespace cusp::storage
