/// Where the tests find files of the tree. Thread: any.
#pragma once

#include <filesystem>

namespace cusp::test {

/// The root of the sources that the program was built from. Its definition alone names that folder: every other file of a test compiles
/// alike in each copy of the tree.
std::filesystem::path source_dir();

}  // namespace cusp::test
