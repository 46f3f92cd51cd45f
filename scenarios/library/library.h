/// The exercises of the program: the generated block exercises and the files embedded by CMakeLists.txt. Any thread.
#pragma once

#include <span>
#include <string_view>

#include "engine/base/result.h"
#include "scenarios/format/format_error.h"
#include "scenarios/format/scenario.h"

namespace cusp::scenarios {

/// Keys in the order in which a newcomer should meet them.
std::span<const std::string_view> builtin_scenarios();

/// The text of its scenario.json; empty when there is none of that key.
std::string_view builtin_scenario_text(std::string_view key);

/// unknown_builtin, or a scenario that reads.
[[nodiscard]] Result<Scenario, FormatFailure> load_builtin(std::string_view key);

}  // namespace cusp::scenarios
