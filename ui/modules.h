/// The modules that ui builds on: their names are used without a prefix.
#pragma once

namespace cusp::engine {}
namespace cusp::device {}
namespace cusp::scenarios {}
namespace cusp::storage {}

namespace cusp::ui {
using namespace engine;
using namespace device;
using namespace scenarios;
using namespace storage;
}
