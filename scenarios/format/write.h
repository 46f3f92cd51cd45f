/// Scenario -> scenario.json. read_scenario(write_scenario(s)) == s for every scenario that validate() passes, whose lists, names
/// and nesting the reader takes (validate() does not see them), and whose fields out of use (fdi and seed of a block, volume
/// beside a generator) stand at their defaults.
#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "scenarios/format/format_error.h"
#include "scenarios/format/scenario.h"

namespace cusp::scenarios {

/// For people and version control: keys in the order of scenario.h, two spaces, shortest numbers that read back the
/// same, a newline at the end.
std::string write_scenario(const Scenario& scenario);

/// For records: one line, keys sorted by bytes, shortest numbers that read back the same.
std::string canonical_json(const Scenario& scenario);

/// For hashing: the canonical form in the oldest format that can say these values. So an exercise keeps its hash when the
/// format that its file is written in changes, and no two exercises share one.
std::string hashed_json(const Scenario& scenario);

/// The same for any JSON text; the failure names line and column.
Result<std::string, FormatFailure> canonical_json(std::string_view text);

}  // namespace cusp::scenarios
