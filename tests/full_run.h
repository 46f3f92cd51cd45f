/// Whether a test runs whole: `./check --full` sets CUSP_FULL. By default it takes a part that still fails for each fault it names.
#pragma once

#include <cstdlib>

namespace cusp::test {

inline bool full_run() { return std::getenv("CUSP_FULL") != nullptr; }

}  // namespace cusp::test
