/// Folders in which a program made what it would then have renamed, and was killed. Any thread.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace cusp::storage {

/// Whether what was made has a file of this name.
using IsContent = std::function<bool(std::string_view name)>;

/// Whether nobody can be writing the folder any more: it holds content alone, unchanged for a day.
bool is_left_folder(const std::filesystem::path& folder, const IsContent& is_content);

/// Removes of `parent` each folder of that kind that is named `prefix` and a UUID. Failures are ignored.
void remove_left_folders(const std::filesystem::path& parent, std::string_view prefix, const IsContent& is_content);

}  // namespace cusp::storage
