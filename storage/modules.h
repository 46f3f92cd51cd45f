/// The modules that storage builds on: their names are used without a prefix.
#pragma once

namespace cusp::engine {}
namespace cusp::scenarios {}

namespace cusp::storage {
using namespace engine;
using namespace scenarios;
}
