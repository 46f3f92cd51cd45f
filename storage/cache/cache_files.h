/// Files that may be lost, but are never half written: a temporary file is synced, then renamed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "storage/base/error.h"

namespace cusp::storage {

/// Replaces a file of that name; readable by its owner alone. A failure leaves no new file behind.
Stored<void> write_cache_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
/// nullopt: missing, not readable, not a plain file, or longer than `most_bytes`.
std::optional<std::vector<std::byte>> read_cache_file(const std::filesystem::path& file, std::size_t most_bytes);

}  // namespace cusp::storage
