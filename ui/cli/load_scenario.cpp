#include "ui/cli/load_scenario.h"

#include "scenarios/format/read.h"
#include "scenarios/format/validate.h"
#include "scenarios/library/library.h"
#include "ui/cli/text.h"
#include "ui/modules.h"

namespace cusp::ui {

Result<LoadedScenario, Message> load_scenario(const std::string& what) {
  const bool built_in = !builtin_scenario_text(what).empty();
  auto scenario = built_in ? load_builtin(what) : read_scenario_file(what);
  if (!scenario) return std::unexpected(describe(scenario.error()));
  // Errors come first.
  if (const auto findings = validate(*scenario); has_error(findings)) {
    return std::unexpected(Message{
        CliText::tr("%1 cannot be used: %2").arg(QString::fromStdString(what), finding_text(findings.front())), {}});
  }
  LoadedScenario out{std::move(*scenario), {}};
  if (!built_in) {
    const std::filesystem::path path(what);
    out.folder = std::filesystem::is_directory(path) ? path : path.parent_path();
  }
  return out;
}

}  // namespace cusp::ui
