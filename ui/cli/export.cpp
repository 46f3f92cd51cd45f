// cusp export DB

#include "storage/export/csv.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "scenarios/import/whole_file.h"
#include "storage/base/clock.h"
#include "ui/cli/account.h"
#include "ui/cli/gradebook.h"
#include "ui/cli/interrupt.h"
#include "ui/cli/outputs.h"
#include "ui/cli/row_json.h"
#include "ui/cli/text.h"
#include "ui/cli/verb.h"
#include "ui/modules.h"
#include "ui/text/gradebook_text.h"
#include "ui/text/language.h"

namespace cusp::ui {
namespace {

struct ExportOptions {
  std::string db, out, student, drilled_by, result;
  std::optional<std::string> from, to, cohort, exercise, device, due;
  std::string gradebook;  // of which system; empty: attempts
  std::string kind;       // of the assignment; empty: any
  std::optional<int> version;
  AccountOption account;
  JsonOption json;
  /// Without a file of any kind the CSV goes to stdout.
  bool csv_on_stdout() const { return out == "-" || (out.empty() && !json.wanted()); }
};

QString typed_text(const std::string& value) { return QString::fromStdString(value); }

QString no_date(const std::string& typed) {
  return CliText::tr("“%1” is no date: write it as 2026-11-20 or 2026-11-20T09:14:03Z, in UTC.").arg(typed_text(typed));
}

/// Both ends are included: --to is a whole day or second.
Result<HistoryFilter, QString> dates_in(const ExportOptions& o) {
  const auto span = [](const std::optional<std::string>& typed) -> Result<std::optional<UtcSpan>, QString> {
    if (!typed) return std::optional<UtcSpan>{};
    const auto read = utc_span_of(*typed);
    if (read) return read;
    return std::unexpected(no_date(*typed));
  };
  const auto from = span(o.from), to = span(o.to);
  if (!from) return std::unexpected(from.error());
  if (!to) return std::unexpected(to.error());
  HistoryFilter filter;
  if (*from) filter.from_utc_us = (*from)->begin_utc_us;
  if (*to) filter.to_utc_us = (*to)->end_utc_us;
  if (*from && *to && *filter.from_utc_us >= *filter.to_utc_us) {
    return std::unexpected(CliText::tr("--from %1 is after --to %2.").arg(typed_text(*o.from), typed_text(*o.to)));
  }
  return filter;
}

/// Of those with an attempt. An exercise of a file may have the key of another one.
Result<ScenarioId, Message> exercise_in(Store& store, const Actor& actor, const std::string& typed) {
  const auto practised = store.history.scenarios(actor);
  if (!practised) return std::unexpected(describe(practised.error()));
  std::optional<ScenarioId> found;
  for (const PractisedScenario& s : *practised) {
    const auto called = is_called(store, s.scenario, typed);
    if (!called) return std::unexpected(describe(called.error()));
    if (!*called) continue;
    if (found) return std::unexpected(Message{CliText::tr("“%1” is the key of more than one exercise: give the id of one.").arg(typed_text(typed)), {}});
    found = s.scenario;
  }
  if (found) return *found;
  return std::unexpected(Message{CliText::tr("There is no attempt at an exercise “%1”.").arg(typed_text(typed)), {}});
}

Result<CohortId, Message> cohort_in(Store& store, const std::string& typed) {
  const auto cohort = store.cohorts.find_name(typed);
  if (cohort) return cohort->id;
  if (cohort.error().code != StorageError::not_found) return std::unexpected(describe(cohort.error()));
  return std::unexpected(Message{CliText::tr("No cohort is called “%1”.").arg(typed_text(typed)), {}});
}

Result<std::string, Message> device_in(Store& store, const Actor& actor, const std::string& typed) {
  const auto classes = store.history.device_classes(actor);
  if (!classes) return std::unexpected(describe(classes.error()));
  if (std::ranges::find(*classes, typed) != classes->end()) return typed;
  return std::unexpected(Message{CliText::tr("There is no attempt with a device of class “%1”.").arg(typed_text(typed)), {}});
}

/// The value of --kind, as row_json() and the CSV name kinds.
std::optional<SessionKind> typed_kind(const std::string& typed) {
  if (typed.empty()) return std::nullopt;
  return typed == key_of(SessionKind::assessment) ? SessionKind::assessment : SessionKind::practice;
}

/// Of --drilled-by: a scripted operator's attempt is not that of the person in whose name it was drilled. Without it every attempt counts.
std::optional<bool> scripted_in(const std::string& drilled_by) {
  return drilled_by.empty() ? std::nullopt : std::optional(drilled_by == "scripted");
}

/// The dates, and what names something in the records.
Result<HistoryFilter, Message> filter_in(Store& store, const Actor& actor, const ExportOptions& o, HistoryFilter filter) {
  if (o.cohort) {
    const auto cohort = cohort_in(store, *o.cohort);
    if (!cohort) return std::unexpected(cohort.error());
    filter.cohort = *cohort;
  }
  if (o.exercise && o.gradebook.empty()) {  // of a gradebook, it is one of the cohort's
    const auto exercise = exercise_in(store, actor, *o.exercise);
    if (!exercise) return std::unexpected(exercise.error());
    filter.scenario = *exercise;
  }
  if (o.device) {
    const auto device = device_in(store, actor, *o.device);
    if (!device) return std::unexpected(device.error());
    filter.device_class = *device;
  }
  filter.version_number = o.version;
  if (o.gradebook.empty()) filter.kind = typed_kind(o.kind);  // of a gradebook, it is the assignment's
  filter.search = o.student;
  filter.scripted = scripted_in(o.drilled_by);
  if (filter.scripted == false) filter.drilled_by = o.drilled_by == "staff" ? DrilledBy::staff : DrilledBy::students;
  if (!o.result.empty()) filter.passed = o.result == "passed";
  return filter;
}

/// Where CSV or JSON goes, piece by piece: nowhere without a name. The entry in the audit log follows close(), and finish() follows the
/// entry: no file under its name lacks the entry. False: could not be written; stderr has the message, or gets that of after_output().
class Output {
 public:
  enum class To : std::uint8_t { file, standard_output };
  Output(std::string name, To to) : name_{std::move(name)}, on_stdout_{to == To::standard_output} {
    if (!on_stdout_ && !name_.empty()) file_.emplace(name_);
  }
  bool wanted() const { return on_stdout_ || file_; }
  bool write(const std::string& piece) { return file_ ? settled(file_->write(piece)) : !on_stdout_ || write_out(piece); }
  bool close() { return !file_ || settled(file_->close()); }
  bool finish() { return !file_ || settled(file_->finish()); }

 private:
  bool settled(const Result<void, std::error_code>& done) const {
    if (!done) failed(cannot_write(name_, done.error().message()));
    return done.has_value();
  }
  std::string name_;
  bool on_stdout_;
  std::optional<WholeFile> file_;
};

Output::To to(bool on_stdout) { return on_stdout ? Output::To::standard_output : Output::To::file; }

int export_for_gradebook(Store& store, const Actor& actor, const ExportOptions& o, const HistoryFilter& filter) {
  const auto made = gradebook_of(store, actor,
                                 {.system = o.gradebook == "canvas" ? Gradebook::canvas : Gradebook::moodle,
                                  .cohort = *filter.cohort,
                                  .exercise = *o.exercise,
                                  .version = o.version,
                                  .kind = typed_kind(o.kind),
                                  .due = o.due,
                                  .cohort_typed = *o.cohort});
  if (!made) return failed(made.error());
  const GradebookFile& file = made->file;
  Output csv(o.out, to(o.csv_on_stdout()));
  if (!csv.write(file.text) || !csv.close()) return kFailed;
  if (const auto logged = log_gradebook(store.context(), actor, made->assignment, file); !logged) return failed(describe(logged.error()));
  if (!csv.finish()) return kFailed;
  if (o.csv_on_stdout()) return kDone;
  for (const QString& sentence : gradebook_text(file)) print_line(plain(sentence));
  return kDone;
}

/// One JSON array, written row by row as JsonOption::text_of() would write the whole.
class JsonRows {
 public:
  std::string piece(std::span<const ExportRow> rows) {
    std::string out;
    for (const ExportRow& row : rows) {
      out += std::exchange(empty_, false) ? "[\n  " : ",\n  ";
      std::string text = JsonOption::text_of(row_json(row));
      text.pop_back();  // the end of its last line
      for (const char c : text) {
        out += c;
        if (c == '\n') out += "  ";  // a text has none: JSON escapes it
      }
    }
    return out;
  }
  std::string end() const { return empty_ ? "[]\n" : "\n]\n"; }

 private:
  bool empty_ = true;
};

/// Where the JSON goes beside a CSV: a pipe is opened once the CSV has gone, for one reader may read both.
bool waits_for_csv(const ExportOptions& o, const Output& csv) {
  std::error_code error;
  return csv.wanted() && !o.json.on_stdout() && std::filesystem::exists(o.json.file, error) && !std::filesystem::is_regular_file(o.json.file, error);
}

int export_rows_of(Store& store, const Actor& actor, const ExportOptions& o, const HistoryFilter& filter) {
  const CsvOptions options{.language = current_language().toStdString()};
  Output csv(o.out, to(o.csv_on_stdout()));
  std::optional<Output> json;
  std::string held;  // JSON that waits
  JsonRows json_rows;
  if (o.json.wanted() && !waits_for_csv(o, csv)) json.emplace(o.json.file, to(o.json.on_stdout()));
  CsvPart part = CsvPart::beginning;
  bool written = true;
  catch_interrupt();
  const auto take = [&](std::span<const ExportRow> some, std::size_t) -> Stored<bool> {
    if (csv.wanted()) written = csv.write(history_csv(some, std::exchange(part, CsvPart::further), options));
    if (json) {
      written = written && json->write(json_rows.piece(some));
    } else if (o.json.wanted()) {
      held += json_rows.piece(some);
    }
    return written && !interrupted();
  };
  const auto close = [&]() -> Stored<void> {
    written = csv.close();
    if (written && o.json.wanted()) {
      if (!json) json.emplace(o.json.file, Output::To::file);
      written = json->write(held + json_rows.end()) && json->close();
    }
    if (!written) return fail(StorageError::io, "export");
    return {};
  };
  const auto rows = export_rows(store.context(), actor, filter, take, close);
  const bool on_stdout = o.csv_on_stdout() || o.json.on_stdout();
  if (!written) return kFailed;
  if (!rows) return failed(describe(rows.error()));
  if (!*rows) return failed(on_stdout ? CliText::tr("Stopped. What was written may lack attempts.") : CliText::tr("Stopped. No file was written."));
  if (!csv.finish() || (json && !json->finish())) return kFailed;
  if (on_stdout) return kDone;
  print_line(plain(CliText::tr("%n attempt(s) exported.", nullptr, static_cast<int>(**rows))));
  return kDone;
}

int export_attempts(const ExportOptions& o) {
  if (!o.gradebook.empty() && o.json.wanted()) return wrong_usage(CliText::tr("A gradebook reads CSV alone: --gradebook goes without --json."));
  if (o.due && *o.due != kNoDueDate && !utc_span_of(*o.due)) return wrong_usage(no_date(*o.due));
  if (o.csv_on_stdout() && o.json.on_stdout()) return wrong_usage(CliText::tr("Only one of CSV and JSON can go to stdout."));
  const auto dates = dates_in(o);
  if (!dates) return wrong_usage(dates.error());
  if (const auto no = refuse_outputs({o.out, o.json.file}, o.db)) return failed(*no);
  auto store = open_records(o.db);
  if (!store) return failed(store.error());
  auto account = sign_in(**store, o.account, WithoutAccounts::refuse);
  if (!account) return failed(account.error());
  const Actor actor = account->actor();
  if (const auto allowed = require(actor, Action::export_results); !allowed) return failed(describe(allowed.error()));
  const auto filter = filter_in(**store, actor, o, *dates);
  if (!filter) return failed(filter.error());
  if (!o.gradebook.empty()) return export_for_gradebook(**store, actor, o, *filter);
  return export_rows_of(**store, actor, o, *filter);
}

/// An empty value is a value: add_option() would take it for none.
CLI::Option* add_named(CLI::App& verb, const char* name, std::optional<std::string>& value, const QString& does) {
  return verb.add_option_function<std::string>(name, [&value](const std::string& typed) { value = typed; }, help(does));
}

void add_filters(CLI::App& verb, ExportOptions& o) {
  CLI::Option* cohort = add_named(verb, "--cohort", o.cohort, CliText::tr("Only students who are in this cohort now"));
  cohort->type_name("NAME");
  std::vector<CLI::Option*> of_attempts;  // which a gradebook has none of
  of_attempts.push_back(
      add_named(verb, "--from", o.from, CliText::tr("Only attempts begun on this day or later, in UTC: 2026-11-20 or 2026-11-20T09:14:03Z"))
          ->type_name("DATE"));
  of_attempts.push_back(add_named(verb, "--to", o.to, CliText::tr("Only attempts begun on this day or earlier"))->type_name("DATE"));
  CLI::Option* exercise =
      add_named(verb, "--exercise", o.exercise, CliText::tr("Only attempts at this exercise: its key or id"))->type_name("KEY");
  verb.add_option("--exercise-version", o.version, help(CliText::tr("Only attempts at this version of the exercise")))
      ->type_name("N")
      ->transform(decimal)
      ->check(check_counting)
      ->needs(exercise);
  of_attempts.push_back(verb.add_option("--student", o.student, help(CliText::tr("Part of a name or number")))->type_name("TEXT"));
  of_attempts.push_back(verb.add_option("--drilled-by", o.drilled_by, help(CliText::tr("Only attempts of students, of staff, or of scripted operators")))
                            ->check(CLI::IsMember({"students", "staff", "scripted"})));
  of_attempts.push_back(verb.add_option("--result", o.result, help(CliText::tr("Only attempts with this result")))
                            ->check(CLI::IsMember({"passed", "not-passed"})));
  of_attempts.push_back(add_named(verb, "--device", o.device, CliText::tr("Only attempts with a device of this class"))->type_name("CLASS"));
  CLI::Option* gradebook =
      verb.add_option("--gradebook", o.gradebook,
                      help(CliText::tr("The best released result of each student in what is assigned to a cohort, as this system reads it")));
  gradebook->check(CLI::IsMember({"moodle", "canvas"}))->needs(cohort)->needs(exercise);
  for (CLI::Option* other : of_attempts) gradebook->excludes(other);
  verb.add_option("--kind", o.kind, help(CliText::tr("Only this kind; of a gradebook the assignment, where the exercise is assigned more than once")))
      ->check(CLI::IsMember({"practice", "assessment"}));
  add_named(verb, "--due", o.due, CliText::tr("The assignment that is due on this day, or none, where the exercise is assigned more than once"))
      ->type_name("DATE")
      ->needs(gradebook);
}

}  // namespace

void add_export(CLI::App& program, Job& job) {
  auto o = std::make_shared<ExportOptions>();
  CLI::App* verb = program.add_subcommand(
      "export", help(CliText::tr("Attempts with results, cohort and dates as CSV or JSON; for instructors and administrators")));
  verb->add_option("DB", o->db, help(CliText::tr("Database")))->required()->check(check_not_empty);
  verb->add_option("-o,--output", o->out, help(CliText::tr("CSV file to write, or - for stdout, where it also goes without -o and --json")))
      ->type_name("FILE")
      ->check(check_not_empty);
  add_filters(*verb, *o);
  o->account.add_to(*verb);
  o->json.add_to(*verb);
  verb->callback([&job, o] { job = [o] { return export_attempts(*o); }; });
}

}  // namespace cusp::ui
