// cusp grade DB SESSION [--rubric FILE], cusp grade SCENARIO --volume FILE|--operator NAME [--rubric FILE]

#include <nlohmann/json.hpp>

#include "scenarios/operators/single_fault.h"
#include "ui/cli/account.h"
#include "ui/cli/grade_volume.h"
#include "ui/cli/load_scenario.h"
#include "ui/cli/outputs.h"
#include "ui/cli/report_files.h"
#include "ui/cli/verb.h"
#include "ui/cli/text.h"
#include "ui/modules.h"
#include "ui/text/grade_text.h"
#include "ui/session/replay.h"

namespace cusp::ui {

namespace {

struct GradeOptions {
  std::string db, session, rubric, volume, cuts_of, out;
  AccountOption account;
  JsonOption json;
};

/// What counts of the stored grade, if an examiner changed it; nullopt also for a session without a summary.
Result<std::optional<EffectiveGrade>, Message> changed_grade(Store& store, const Actor& reader, SessionId id) {
  const auto details = store.history.details(reader, id);
  if (!details && details.error().code == StorageError::not_found) return std::optional<EffectiveGrade>{};
  if (!details) return std::unexpected(describe(details.error()));
  if (!details->grade || details->grade->overrides.empty()) return std::optional<EffectiveGrade>{};
  return details->grade;
}

/// Report files, JSON and lines of one result.
int give_out(const GradeOptions& o, const SessionResult& result, Store& store, const ReportOrder& order) {
  if (!o.out.empty()) {
    if (auto written = write_report_files(o.out, result, store, order); !written) return failed(written.error());
  }
  if (!o.json.write(nlohmann::ordered_json::parse(report_file_text(result, store, order)))) return kFailed;
  if (o.json.on_stdout()) return kDone;
  if (order.changed) {
    print_changed_grade(*order.changed, result, store);
  } else {
    print_grade(result);
  }
  if (result.changes) print_line(plain(changes_text(*result.changes, &result.scenario.target, tissue_names_of(result))));
  return kDone;
}

int grade_verb(const GradeOptions& o) {
  const bool of_scenario = !o.volume.empty() || !o.cuts_of.empty();
  if (of_scenario && !o.account.number.empty()) return wrong_usage(CliText::tr("--as belongs to a database; --volume and --operator need no account."));
  if (of_scenario == o.session.empty() && o.volume.empty() != o.cuts_of.empty())
    return grade_volume({o.db, o.rubric, o.volume, o.cuts_of, o.out}, o.json);
  if (of_scenario || o.session.empty())
    return wrong_usage(CliText::tr("Give a database and a session, or a scenario and either --volume or --operator."));
  const auto id = SessionId::parse(o.session);
  if (!id) return wrong_usage(CliText::tr("%1 is not a session’s id.").arg(QString::fromStdString(o.session)));
  std::vector<std::filesystem::path> outputs;
  if (!o.out.empty()) outputs = report_files_in(o.out);
  outputs.emplace_back(o.json.file);
  if (const auto no = refuse_outputs(outputs, o.db, {o.rubric})) return failed(*no);
  if (!o.out.empty()) {
    if (const auto fits = writable_folder(o.out); !fits) return failed(nothing_written_to(o.out, fits.error().detail));
  }
  auto opened_store = open_records(o.db);
  if (!opened_store) return failed(opened_store.error());
  Store& store = **opened_store;
  auto account = sign_in(store, o.account, WithoutAccounts::refuse);
  if (!account) return failed(account.error());
  const auto session = store.sessions.find(*id);
  if (!session) return failed(describe(session.error()));
  if (auto may = store.history.may_read_result(account->actor(), *id); !may) return failed(describe(may.error()));
  auto student = store.accounts.find(session->student);
  if (!student) return failed(describe(student.error()));

  std::optional<Rubric> rubric;
  if (!o.rubric.empty()) {
    const auto opened = open_session(store, *id);
    if (!opened) return failed(describe(opened.error()));
    auto read = read_rubric(o.rubric, opened->scenario);
    if (!read) return failed(read.error());
    rubric = std::move(*read);
  }
  // With another rubric only shown; without one, a session that has no grade yet gets its own. An interrupted one ends with it: that is up
  // to its student, and to who may grade.
  const auto before = store.grades.newest(*id);
  if (!before) return failed(describe(before.error()));
  const bool grades_it = account->id == session->student || may(account->role, Action::grade_again);
  auto result = grade_session(store, *id, rubric ? &*rubric : nullptr, !rubric && !*before && grades_it ? Keep::grade : Keep::nothing);
  if (!result) return failed(describe(result.error()));
  ReportOrder order{.student = *student, .reader = account->actor()};
  if (!rubric) {  // an examiner changes the stored grade: another rubric's result has no changes
    auto changed = changed_grade(store, order.reader, *id);
    if (!changed) return failed(changed.error());
    order.changed = std::move(*changed);
  }
  return give_out(o, *result, store, order);
}

/// Names of operators whose cuts are made at once.
std::vector<std::string> operators_of_cuts() {
  std::vector<std::string> out = {"reference", "competent", "novice", "too_deep", "too_shallow", "off_outline", "pulp"};
  for (const SingleFaultRow& row : single_faults())
    for (std::size_t size = 0; size < kFaultSizeKeys.size(); ++size) out.push_back(scenarios::key_of(SizedFault{row.fault, static_cast<FaultSize>(size)}));
  return out;
}

/// "too_deep, too_shallow, ..."
QString faults_text() {
  QStringList out;
  for (const SingleFaultRow& row : single_faults()) out << QString::fromUtf8(row.key.data(), static_cast<qsizetype>(row.key.size()));
  return out.join(QStringLiteral(", "));
}

}  // namespace

void add_grade(CLI::App& program, Job& job) {
  auto o = std::make_shared<GradeOptions>();
  CLI::App* verb = program.add_subcommand(
      "grade", help(CliText::tr("Run a stored session again and grade it as it stands, or grade a volume or an operator's cuts; an interrupted session "
                                "keeps its grade")));
  verb->add_option("DB", o->db, help(CliText::tr("Database; with --volume or --operator a scenario.json, its folder, or a built-in one")))
      ->required()
      ->check(check_not_empty);
  verb->add_option("SESSION", o->session, help(CliText::tr("The session's id")));
  verb->add_option("--volume", o->volume,
                   help(CliText::tr("Grade this prepared volume of the scenario's specimen (NRRD). Shown, not stored")))
      ->type_name("FILE")
      ->check(check_not_empty);
  verb->add_option("--operator", o->cuts_of,
                   help(CliText::tr("Cut the scenario's specimen as this operator would, at once, and grade that: reference, competent, "
                                     "novice, too_deep, too_shallow, off_outline or pulp; or the reference with one fault, small, medium or "
                                     "large, such as too_deep:small. Faults: %1. Shown, not stored")
                            .arg(faults_text())))
      ->type_name("NAME")
      ->check(CLI::IsMember(operators_of_cuts()));
  verb->add_option("--rubric", o->rubric,
                   help(CliText::tr("Another rubric: a scenario.json or its rubric alone. Shown, not stored")))
      ->type_name("FILE")
      ->check(check_not_empty);
  verb->add_option("--out", o->out, help(CliText::tr("Folder for the report")))->type_name("DIR")->check(check_not_empty);
  o->account.add_to(*verb);
  o->json.add_to(*verb);
  verb->callback([&job, o] { job = [o] { return grade_verb(*o); }; });
}

}  // namespace cusp::ui
