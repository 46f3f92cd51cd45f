/// The modules under test: their names are used without a prefix.
#pragma once

namespace cusp::engine {}
namespace cusp::device {}
namespace cusp::scenarios {}
namespace cusp::storage {}
namespace cusp::ui {}

namespace cusp::test {
using namespace engine;
using namespace device;
using namespace scenarios;
using namespace storage;
using namespace ui;
}
namespace cusp::bench {
using namespace engine;
using namespace device;
using namespace scenarios;
}
namespace cusp::fuzz {
using namespace engine;
using namespace scenarios;
}
