/// Text of scenarios/teeth/teeth.json, embedded by the build.
#pragma once

#include <string_view>

namespace cusp::scenarios {

extern const std::string_view kTeethJson;

}  // namespace cusp::scenarios
