/// Older formats of scenario.json are brought to the present one before they are read; newer ones are refused.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/base/result.h"
#include "scenarios/format/format_error.h"

namespace cusp::scenarios {

/// The format this program writes. 1: the first.
inline constexpr int kScenarioFormat = 1;

/// Pre: the document is an object. Afterwards its "format" is kScenarioFormat, or the failure names the reason.
Result<void, FormatFailure> migrate(nlohmann::json& document);

}  // namespace cusp::scenarios
