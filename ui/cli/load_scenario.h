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

/// --rubric FILE: a scenario.json, or its "rubric" alone. That is checked as a part of `scenario`.
Result<Rubric, Message> read_rubric(const std::string& file, const Scenario& scenario);

}  // namespace cusp::ui
