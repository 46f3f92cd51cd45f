// cusp grade DB SESSION [--rubric FILE]

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "ui/cli/account.h"
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
  std::string db, session, rubric, out;
  AccountOption account;
  JsonOption json;
};

/// A scenario.json, or its "rubric" alone. That is checked as a part of the session's own scenario.
Result<Rubric, Message> read_rubric(const std::string& file, const Scenario& scenario) {
  if (auto whole = read_scenario_file(file)) return whole->rubric;
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::unexpected(describe(FormatFailure{FormatError::unreadable, file, {}}));
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (auto canonical = canonical_json(text); !canonical) {
    FormatFailure failure = canonical.error();
    failure.where = file + ':' + failure.where;
    return std::unexpected(describe(failure));
  }
  const auto rubric = nlohmann::json::parse(text, nullptr, false);
  if (rubric.is_object() && rubric.contains("format")) {
    const auto whole = read_scenario_file(file);
    return std::unexpected(describe(whole.error()));
  }
  auto with = nlohmann::json::parse(canonical_json(scenario));
  with["rubric"] = rubric;
  auto read = read_scenario(with.dump());
  if (!read) {
    FormatFailure failure = read.error();
    failure.where = file + '#' + failure.where;
    return std::unexpected(describe(failure));
  }
  return read->rubric;
}

int grade_verb(const GradeOptions& o) {
  const auto id = SessionId::parse(o.session);
  if (!id) return wrong_usage(CliText::tr("%1 is not a session’s id.").arg(QString::fromStdString(o.session)));
  std::vector<std::filesystem::path> outputs;
  if (!o.out.empty()) outputs = report_files_in(o.out);
  outputs.emplace_back(o.json.file);
  if (const auto no = refuse_outputs(outputs, o.db)) return failed(*no);
  if (!o.out.empty() && !writable_folder(o.out)) {
    return failed(CliText::tr("Nothing can be written to %1.").arg(QString::fromStdString(o.out)));
  }
  auto opened_store = open_records(o.db);
  if (!opened_store) return failed(opened_store.error());
  Store& store = **opened_store;
  auto account = sign_in(store, o.account, WithoutAccounts::refuse);
  if (!account) return failed(account.error());
  const auto session = store.sessions.find(*id);
  if (!session) return failed(describe(session.error()));
  if (auto may = require_reading(account->actor(), session->student); !may) return failed(describe(may.error()));
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
  // With another rubric only shown; without one, a session that has no grade yet gets its own.
  const auto before = store.grades.newest(*id);
  if (!before) return failed(describe(before.error()));
  auto result = grade_session(store, *id, rubric ? &*rubric : nullptr, !rubric && !*before ? Keep::grade : Keep::nothing);
  if (!result) return failed(describe(result.error()));
  if (!o.out.empty()) {
    if (auto written = write_report_files(o.out, *result, store, *student); !written) return failed(written.error());
  }
  if (!o.json.write(nlohmann::ordered_json::parse(report_text(*result, store, *student)))) return kFailed;
  if (o.json.on_stdout()) return kDone;
  const Grade& g = result->grade;
  print_line(plain(CliText::tr("%1 of %2 points: %3")
                .arg(g.score, 0, 'f', 1)
                .arg(g.score_max, 0, 'f', 0)
                .arg(g.passed ? CliText::tr("passed") : CliText::tr("not passed"))));
  for (const std::string& critical : g.critical) print_line("! " + plain(critical_name(critical)));
  print_criteria(g, {});
  return kDone;
}

}  // namespace

void add_grade(CLI::App& program, Job& job) {
  auto o = std::make_shared<GradeOptions>();
  CLI::App* verb = program.add_subcommand(
      "grade", help(CliText::tr("Run a stored session again and grade it as it stands; an interrupted one keeps that grade")));
  verb->add_option("DB", o->db, help(CliText::tr("Database")))->required();
  verb->add_option("SESSION", o->session, help(CliText::tr("The session's id")))->required();
  verb->add_option("--rubric", o->rubric,
                   help(CliText::tr("Another rubric: a scenario.json or its rubric alone. Shown, not stored")))
      ->type_name("FILE");
  verb->add_option("--out", o->out, help(CliText::tr("Folder for the report")))->type_name("DIR");
  o->account.add_to(*verb);
  o->json.add_to(*verb);
  verb->callback([&job, o] { job = [o] { return grade_verb(*o); }; });
}

}  // namespace cusp::ui
