/// Older formats of scenario.json are brought to the present one before they are read; newer ones are refused.
/// Format 2 against format 1: the target names its kind ("outline"), `protected` lists objects, the metric "undercut" is called
/// "uncut_remainder", and level, expected time, own assessment and the landmarks of a tooth from a file may be stated.
#pragma once

#include <optional>

#include <nlohmann/json_fwd.hpp>

#include "engine/base/result.h"
#include "scenarios/format/format_error.h"

namespace cusp::scenarios {

/// The format this program writes. 1: the first. 2: the target is a region.
inline constexpr int kScenarioFormat = 2;

/// Pre: the document is an object. Afterwards its "format" is kScenarioFormat, or the failure names the reason and the
/// place. A key that only format 2 has is unknown in a document of format 1.
Result<void, FormatFailure> migrate(nlohmann::json& document);

/// A rubric alone, which names no format: its metrics by their present names.
void migrate_rubric(nlohmann::json& rubric);

/// The document as format 1 says it, if format 1 can: migrate() of it gives `document` again. For content_hash.
/// Pre: `document` is of kScenarioFormat.
std::optional<nlohmann::json> in_format_1(const nlohmann::json& document);

}  // namespace cusp::scenarios
