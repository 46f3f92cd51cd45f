// cusp validate PATH

#include <optional>
#include <system_error>
#include <variant>
#include <nlohmann/json.hpp>

#include "scenarios/checks/checks.h"
#include "scenarios/format/read.h"
#include "scenarios/format/validate.h"
#include "scenarios/format/write.h"
#include "scenarios/library/exercise_file.h"
#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "scenarios/specimens/taken_codes.h"
#include "ui/cli/outputs.h"
#include "ui/cli/verb.h"
#include "ui/cli/text.h"
#include "ui/modules.h"
#include "ui/session/file_bytes.h"

namespace cusp::ui {

namespace {

struct ValidateOptions {
  std::string path;
  bool form_only = false;
  JsonOption json;
};

/// What PATH names: the text of a scenario, and where its specimen comes from.
struct Input {
  std::string text;
  std::filesystem::path folder;      // of the volume that the text names
  std::optional<ExerciseFile> file;  // with its volume
  std::vector<Finding> findings{};   // that refused the file
};

Result<Input, Message> open_file(const std::string& path) {
  auto file = read_exercise_file(path);
  if (file) return Input{canonical_json(file->scenario), {}, std::move(*file)};
  if (const auto* finding = std::get_if<Finding>(&file.error())) return Input{{}, {}, {}, {*finding}};
  return std::unexpected(describe(file.error()));
}

Result<Input, Message> open_input(const std::string& path) {
  if (const std::string_view text = builtin_scenario_text(path); !text.empty()) return Input{std::string(text), {}, {}};
  std::filesystem::path file(path);
  std::error_code error;
  const bool is_folder = std::filesystem::is_directory(file, error);
  if (names_exercise_file(path) && !is_folder) return open_file(path);
  if (is_folder) file /= "scenario.json";
  auto text = text_of_file(file, kMaxScenarioBytes);
  if (text) return Input{std::move(*text), file.parent_path(), {}};
  const bool too_large = text.error().code == StorageError::file_too_large;
  return std::unexpected(describe(FormatFailure{too_large ? FormatError::too_large : FormatError::unreadable, file.string(), {}}));
}

enum class Checked : std::uint8_t { form, form_and_specimen };

struct Found {
  std::vector<Finding> findings;
  TissueNames names{};  // of the specimen's own tissues
};

/// Findings about form and values, then with the specimen unless only the form is asked for.
Result<Found, Message> findings_of(const Input& input, Checked checked) {
  if (!input.findings.empty()) return Found{input.findings};
  std::vector<Finding> findings = validate_text(input.text);
  const auto scenario = read_scenario(input.text);
  if (checked == Checked::form || has_error(findings) || !scenario) return Found{std::move(findings)};
  const bool packed = input.file && scenario->specimen.generator.empty();
  const auto volume = packed ? voxels_of(*input.file) : make_specimen(scenario->specimen, input.folder);
  if (!volume) return std::unexpected(describe(volume.error()));
  if (const auto taken = refuse_taken_codes(*volume, scenario->specimen.volume)) return std::unexpected(describe(*taken));
  const SpecimenFacts facts = facts_of(*volume);
  findings = validate_text(input.text, &facts);
  if (has_error(findings)) return Found{std::move(findings), volume->names};
  const std::vector<Finding> checks = check_exercise(*scenario, Specimen::build(*volume, reading_of(scenario->method)));
  findings.insert(has_error(checks) ? findings.begin() : findings.end(), checks.begin(), checks.end());
  return Found{std::move(findings), volume->names};
}

int validate_verb(const ValidateOptions& o) {
  if (const auto no = refuse_outputs({o.json.file}, {}, scenario_files(o.path))) return failed(*no);
  const auto input = open_input(o.path);
  if (!input) return failed(input.error());
  const auto found = findings_of(*input, o.form_only ? Checked::form : Checked::form_and_specimen);
  if (!found) return failed(found.error());
  const std::vector<Finding>& findings = found->findings;

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
    print_line(plain(line.arg(finding_text(f, found->names))));
  }
  if (errors > 0) {
    const QString first = finding_text(findings.front(), found->names);
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
  verb->add_option("PATH", o->path, help(CliText::tr("A scenario.json, its folder, an exercise saved as a file, or a built-in one")))->required()->check(check_not_empty);
  verb->add_flag("--form-only", o->form_only, help(CliText::tr("Leave the specimen out")));
  o->json.add_to(*verb);
  verb->callback([&job, o] { job = [o] { return validate_verb(*o); }; });
}

}  // namespace cusp::ui
