/// Files that may be lost but never half there: written beside their name, brought to the disk, and renamed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "storage/error.h"

namespace cusp::storage {

/// Readable by its owner alone; replaces a file of that name. On failure nothing is left of it.
Stored<void> write_cache_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
/// nullopt: not there, not readable, no plain file, or longer than `most_bytes`.
std::optional<std::vector<std::byte>> read_cache_file(const std::filesystem::path& file, std::size_t most_bytes);

}  // namespace cusp::storage
