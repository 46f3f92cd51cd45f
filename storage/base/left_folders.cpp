#include "storage/base/left_folders.h"

#include <chrono>
#include <system_error>

#include "engine/base/ids.h"
#include "storage/modules.h"

namespace cusp::storage {

namespace fs = std::filesystem;

bool is_left_folder(const fs::path& folder, const IsContent& is_content) {
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(folder, error))) return false;
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(24);
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code gone;
    if (!is_content(it->path().filename().string()) || it->last_write_time(gone) > old || gone) return false;
  }
  return !error && fs::last_write_time(folder, error) <= old && !error;
}

void remove_left_folders(const fs::path& parent, std::string_view prefix, const IsContent& is_content) {
  std::error_code error;
  for (fs::directory_iterator it(parent, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (!name.starts_with(prefix) || !Uuid::parse(std::string_view(name).substr(prefix.size()))) continue;
    std::error_code ignored;
    if (is_left_folder(it->path(), is_content)) fs::remove_all(it->path(), ignored);
  }
}

}  // namespace cusp::storage
