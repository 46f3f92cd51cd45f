// cusp validate PATH

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scenarios/checks/checks.h"
#include "scenarios/format/read.h"
#include "scenarios/format/validate.h"
#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "ui/cli/outputs.h"
#include "ui/cli/verb.h"
#include "ui/cli/text.h"
#include "ui/modules.h"

namespace cusp::ui {

namespace {

struct ValidateOptions {
  std::string path;
  bool form_only = false;
  JsonOption json;
};

int validate_verb(const ValidateOptions& o) {
  if (const auto no = refuse_outputs({o.json.file})) return failed(*no);
  std::string text(builtin_scenario_text(o.path));
  std::filesystem::path folder;
  if (text.empty()) {
    std::filesystem::path file(o.path);
    if (std::filesystem::is_directory(file)) file /= "scenario.json";
    folder = file.parent_path();
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    std::ifstream in(file, std::ios::binary);
    if (error || !in) return failed(describe(FormatFailure{FormatError::unreadable, file.string(), {}}));
    if (size > kMaxScenarioBytes) return failed(describe(FormatFailure{FormatError::too_large, file.string(), {}}));
    text.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  std::vector<Finding> findings = validate_text(text);
  if (!o.form_only && !has_error(findings)) {
    if (const auto scenario = read_scenario(text)) {
      const auto volume = make_specimen(scenario->specimen, folder);
      if (!volume) return failed(describe(volume.error()));
      const SpecimenFacts facts = facts_of(*volume);
      findings = validate_text(text, &facts);
      if (!has_error(findings)) {
        const std::vector<Finding> checks = check_exercise(*scenario, Specimen::build(*volume, reading_of(scenario->method)));
        findings.insert(has_error(checks) ? findings.begin() : findings.end(), checks.begin(), checks.end());
      }
    }
  }

  nlohmann::ordered_json json;
  json["valid"] = !has_error(findings);
  json["findings"] = nlohmann::ordered_json::array();
  for (const Finding& f : findings) {
    nlohmann::ordered_json row;
    row["severity"] = f.severity == Severity::error ? "error" : "warning";
    row["path"] = f.path;
    row["code"] = f.code;
    row["args"] = f.args;
    row["detail"] = f.detail;
    json["findings"].push_back(row);
  }
  if (!o.json.write(json)) return kFailed;
  std::size_t errors = 0;
  for (const Finding& f : findings) {
    if (f.severity == Severity::error) ++errors;
    if (o.json.on_stdout()) continue;
    const QString line = f.severity == Severity::error ? CliText::tr("Error: %1") : CliText::tr("Warning: %1");
    print_line(plain(line.arg(finding_text(f))));
  }
  if (errors > 0) {
    const QString first = finding_text(findings.front());
    const QString what = QString::fromStdString(o.path);
    return failed(errors == 1 ? CliText::tr("%1 cannot be used: %2").arg(what, first)
                              : CliText::tr("%1 cannot be used: %2 (and %n more)", nullptr, static_cast<int>(errors) - 1)
                                    .arg(what, first));
  }
  if (findings.empty() && !o.json.on_stdout()) print_line(plain(CliText::tr("%1 can be used.").arg(QString::fromStdString(o.path))));
  return kDone;
}

}  // namespace

void add_validate(CLI::App& program, Job& job) {
  auto o = std::make_shared<ValidateOptions>();
  CLI::App* verb = program.add_subcommand("validate", help(CliText::tr("Check a scenario: its form, its values, and its specimen")));
  verb->add_option("PATH", o->path, help(CliText::tr("A scenario.json, its folder, or a built-in one")))->required();
  verb->add_flag("--form-only", o->form_only, help(CliText::tr("Leave the specimen out")));
  o->json.add_to(*verb);
  verb->callback([&job, o] { job = [o] { return validate_verb(*o); }; });
}

}  // namespace cusp::ui
