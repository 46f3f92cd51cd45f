#include "ui/cli/load_scenario.h"

#include <algorithm>
#include <fstream>

#include <nlohmann/json.hpp>

#include "scenarios/format/migrate.h"
#include "scenarios/format/read.h"
#include "scenarios/format/validate.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "ui/cli/text.h"
#include "ui/modules.h"

namespace cusp::ui {

namespace {

Message cannot_be_used(const std::string& what, const Finding& why) {
  return {CliText::tr("%1 cannot be used: %2").arg(QString::fromStdString(what), finding_text(why)), {}};
}

/// The scenario's rubric, unless validate() has an error of it.
Result<Rubric, Message> checked_rubric(const std::string& file, const Scenario& with) {
  const auto findings = validate(with);
  const auto wrong = std::ranges::find_if(
      findings, [](const Finding& f) { return f.severity == Severity::error && f.path.starts_with("/rubric"); });
  if (wrong != findings.end()) return std::unexpected(cannot_be_used(file, *wrong));
  return with.rubric;
}

}  // namespace

Result<LoadedScenario, Message> load_scenario(const std::string& what) {
  const bool built_in = !builtin_scenario_text(what).empty();
  auto scenario = built_in ? load_builtin(what) : read_scenario_file(what);
  if (!scenario) return std::unexpected(describe(scenario.error()));
  // Errors come first.
  if (const auto findings = validate(*scenario); has_error(findings)) return std::unexpected(cannot_be_used(what, findings.front()));
  LoadedScenario out{std::move(*scenario), {}};
  if (!built_in) {
    const std::filesystem::path path(what);
    out.folder = std::filesystem::is_directory(path) ? path : path.parent_path();
  }
  return out;
}

Result<Rubric, Message> read_rubric(const std::string& file, const Scenario& scenario) {
  if (auto whole = read_scenario_file(file)) {
    Scenario with = scenario;
    with.rubric = std::move(whole->rubric);
    return checked_rubric(file, with);
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::unexpected(describe(FormatFailure{FormatError::unreadable, file, {}}));
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::unexpected(describe(FormatFailure{FormatError::unreadable, file, {}}));
  // One byte too many is enough to be refused.
  std::string text(kMaxScenarioBytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (auto canonical = canonical_json(text); !canonical) {
    FormatFailure failure = canonical.error();
    failure.where = file + ':' + failure.where;
    return std::unexpected(describe(failure));
  }
  auto rubric = nlohmann::json::parse(text, nullptr, false);
  if (rubric.is_object() && rubric.contains("format")) {
    const auto whole = read_scenario_file(file);
    return std::unexpected(describe(whole.error()));
  }
  auto with = nlohmann::json::parse(canonical_json(scenario));
  migrate_rubric(rubric);
  with["rubric"] = rubric;
  auto read = read_scenario(with.dump());
  if (!read) {
    FormatFailure failure = read.error();
    failure.where = file + '#' + failure.where;
    return std::unexpected(describe(failure));
  }
  return checked_rubric(file, *read);
}

}  // namespace cusp::ui
