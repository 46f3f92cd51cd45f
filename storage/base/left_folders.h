/// Folders in which a program made what it would then have renamed, and was killed. Any thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cusp::storage {

/// Whether nobody can be writing the folder any more: it holds files alone whose names begin with `content`, unchanged for a day.
bool is_left_folder(const std::filesystem::path& folder, const std::string& content);

/// Removes of `parent` each folder of that kind that is named `prefix` and a UUID. Failures are ignored.
void remove_left_folders(const std::filesystem::path& parent, std::string_view prefix, const std::string& content);

}  // namespace cusp::storage
