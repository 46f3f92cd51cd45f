/// scenario.schema.json as it was built in, and a check of any JSON text against it (JSON Schema draft 7, valijson).
#pragma once

#include <string_view>
#include <vector>

#include "scenarios/format/validate.h"

namespace cusp::scenarios {

std::string_view scenario_schema() noexcept;

/// One finding "schema" for each place that breaks the schema, innermost first; of alternatives (specimen) what each of
/// them minds. Text that is not JSON gives none: the reader reports it.
std::vector<Finding> check_schema(std::string_view text);

}  // namespace cusp::scenarios
