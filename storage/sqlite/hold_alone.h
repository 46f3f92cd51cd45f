/// Holding a database file against every other connection, whether it is whole or damaged: before it is moved.
/// Thread: any; release it on the same one.
#pragma once

#include <filesystem>
#include <memory>

#include "storage/base/error.h"

namespace cusp::storage {

/// While the value lives, no connection of any process begins to use the file. busy if one uses it already. A file that cannot be
/// opened or locked, as one that is read-only, is not held, and no failure: nothing can be found out about it.
Stored<std::shared_ptr<void>> hold_alone(const std::filesystem::path& file);

}  // namespace cusp::storage
