#include "tests/source_dir.h"

namespace cusp::test {

std::filesystem::path source_dir() { return CUSP_SOURCE_DIR; }

}  // namespace cusp::test
