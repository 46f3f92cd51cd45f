/// SCENARIO of the command line: a path, or the key of a built-in one.
#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"
#include "scenarios/format/scenario.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"

namespace cusp::ui {

struct LoadedScenario {
  Scenario scenario;
  std::filesystem::path folder;  // where a volume that it names lies; empty for a built-in one
};

/// A scenario with errors of validate() is refused by the first of them, with its path; what needs the specimen is left to
/// `cusp validate`.
Result<LoadedScenario, Message> load_scenario(const std::string& what);

}  // namespace cusp::ui
