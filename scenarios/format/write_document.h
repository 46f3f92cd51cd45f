/// A scenario as a JSON document, before it is text: to walk its numbers. Inside of scenarios/format.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scenarios/format/scenario.h"

namespace cusp::scenarios {

/// As write_scenario() lays it out, keys sorted. Numbers may be anything, also none.
nlohmann::json document_of(const Scenario& scenario);

}  // namespace cusp::scenarios
