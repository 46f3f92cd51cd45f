#include "scenarios/import/left_parts.h"

#include <chrono>
#include <string>
#include <string_view>
#include <system_error>

#include "engine/base/ids.h"

namespace cusp::scenarios {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kOldMark = ".part-", kPart = ".part";
constexpr std::size_t kDigits = 12;

bool is_mark_and_digits(std::string_view rest, std::string_view mark) {
  return rest.size() == mark.size() + kDigits && rest.starts_with(mark) &&
         rest.find_first_not_of("0123456789abcdef", mark.size()) == std::string_view::npos;
}

bool is_part(std::string_view name) {
  constexpr std::size_t end = kPartMark.size() + kDigits;
  return name.size() > end && is_mark_and_digits(name.substr(name.size() - end), kPartMark);
}

/// `rest`: what follows the file's name.
bool is_old_part(std::string_view rest) {
  if (is_mark_and_digits(rest, kOldMark)) return true;
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
    if (!is_part(other) && (!other.starts_with(name) || !is_old_part(std::string_view(other).substr(name.size())))) continue;
    std::error_code gone;
    const bool plain = fs::is_regular_file(it->symlink_status(gone));
    const fs::file_time_type written = it->last_write_time(gone);
    if (plain && !gone && begun - written > std::chrono::hours(24)) fs::remove(it->path(), gone);
  }
}

}  // namespace cusp::scenarios
