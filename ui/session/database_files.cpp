#include "ui/session/database_files.h"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace cusp::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kKeyEnding = ".key";
/// Folder of the key states (storage/cache): a file of that name stops the cache, and a file in it may take a state's place.
constexpr std::string_view kStatesEnding = ".states";
/// What stands behind the database's name in those of its files.
constexpr std::array<std::string_view, 8> kFileEndings = {"", "-wal", "-shm", "-journal", kKeyEnding, ".key-counter", ".running", kStatesEnding};

fs::path with_ending(const fs::path& database, std::string_view ending) {
  fs::path out = database;
  out += ending;
  return out;
}

/// `database`, or one that is there, whose name and one of `endings` make up `path`.
std::optional<fs::path> database_of(const fs::path& path, const fs::path& database, std::span<const std::string_view> endings) {
  if (!database.empty()) {
    for (const std::string_view ending : endings) {
      if (same_file(path, with_ending(database, ending))) return database;
    }
  }
  const std::string name = path.string();
  for (const std::string_view ending : endings) {
    if (!name.ends_with(ending)) continue;
    std::error_code error;
    const fs::path base = name.substr(0, name.size() - ending.size());
    if (fs::is_regular_file(base, error) && fs::is_regular_file(with_ending(base, kKeyEnding), error)) return base;
  }
  return std::nullopt;
}

}  // namespace

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  const fs::path one = fs::weakly_canonical(fs::absolute(a, error), error);
  if (error) return false;
  const fs::path other = fs::weakly_canonical(fs::absolute(b, error), error);
  return !error && one == other;
}

std::optional<fs::path> database_of_file(const fs::path& file, const fs::path& database) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(file, error), error);
  const fs::path& path = error ? file : whole;
  if (auto found = database_of(path, database, kFileEndings)) return found;
  return database_of(path.parent_path(), database, std::span(&kStatesEnding, 1));
}

}  // namespace cusp::ui
