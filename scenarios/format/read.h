/// scenario.json -> Scenario. Nothing is guessed: an unknown key, a missing one, a value of another type or out of its
/// range is refused, with its place. Never throws; the text may be anything. Not for the haptic thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "engine/base/result.h"
#include "scenarios/format/format_error.h"
#include "scenarios/format/scenario.h"

namespace cusp::scenarios {

/// A scenario is a page or two of text; more is not one.
inline constexpr std::size_t kMaxScenarioBytes = 1u << 20;
/// Objects and lists within each other. A target's outline fits into 5 nodes, any other leaf into 6; of a protected region
/// one less.
inline constexpr int kMaxDepth = 16;

/// UTF-8 text of a scenario.json. The first failure found is returned.
[[nodiscard]] Result<Scenario, FormatFailure> read_scenario(std::string_view text);

/// A scenario.json, or a folder that holds one.
[[nodiscard]] Result<Scenario, FormatFailure> read_scenario_file(const std::filesystem::path& path);

}  // namespace cusp::scenarios
