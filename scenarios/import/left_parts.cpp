#include "scenarios/import/left_parts.h"

#include <chrono>
#include <string>
#include <string_view>
#include <system_error>

#include "engine/base/ids.h"

namespace cusp::scenarios {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPart = ".part", kShort = ".part-";
constexpr std::size_t kShortDigits = 12;

/// What follows a file's name in that of its part.
bool is_of_part(std::string_view rest) {
  if (rest.starts_with(kShort)) {
    rest.remove_prefix(kShort.size());
    return rest.size() == kShortDigits && rest.find_first_not_of("0123456789abcdef") == std::string_view::npos;
  }
  if (rest.ends_with(kPart)) rest.remove_suffix(kPart.size());
  return rest.starts_with('.') && Uuid::parse(rest.substr(1)).has_value();
}

}  // namespace

void remove_left_parts(const fs::path& file, const fs::path& own) {
  std::error_code error;
  const fs::file_time_type begun = fs::last_write_time(own, error);
  if (error) return;
  const std::string name = file.filename().string();
  for (fs::directory_iterator it(file.has_parent_path() ? file.parent_path() : ".", error), end; !error && it != end; it.increment(error)) {
    const std::string other = it->path().filename().string();
    if (!other.starts_with(name) || !is_of_part(std::string_view(other).substr(name.size()))) continue;
    std::error_code gone;
    const bool plain = fs::is_regular_file(it->symlink_status(gone));
    const fs::file_time_type written = it->last_write_time(gone);
    if (plain && !gone && begun - written > std::chrono::hours(24)) fs::remove(it->path(), gone);
  }
}

}  // namespace cusp::scenarios
