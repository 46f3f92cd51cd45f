/// The modules that scenarios builds on: their names are used without a prefix.
#pragma once

namespace cusp::engine {}

namespace cusp::scenarios {
using namespace engine;
}
