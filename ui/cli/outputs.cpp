#include "ui/cli/outputs.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "ui/cli/text.h"

namespace cusp::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kKey = ".key";
/// Folder of the key states (storage/cache): a file of that name stops the cache, and a file in it may take a state's place.
constexpr std::string_view kStates = ".states";
/// What stands behind the database's name in those of its files.
constexpr std::array<std::string_view, 8> kEndings = {"", "-wal", "-shm", "-journal", kKey, ".key-counter", ".running", kStates};

fs::path with(const fs::path& database, std::string_view ending) {
  fs::path out = database;
  out += ending;
  return out;
}

/// The same name once links and ".." are gone, or the same file under two names.
bool same(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  const fs::path one = fs::weakly_canonical(fs::absolute(a, error), error);
  if (error) return false;
  const fs::path other = fs::weakly_canonical(fs::absolute(b, error), error);
  return !error && one == other;
}

/// `database`, or one that is there, whose name and one of `endings` make up `path`.
std::optional<fs::path> database_of(const fs::path& path, const fs::path& database, std::span<const std::string_view> endings) {
  if (!database.empty()) {
    for (const std::string_view ending : endings) {
      if (same(path, with(database, ending))) return database;
    }
  }
  const std::string name = path.string();
  for (const std::string_view ending : endings) {
    if (!name.ends_with(ending)) continue;
    std::error_code error;
    const fs::path base = name.substr(0, name.size() - ending.size());
    if (fs::is_regular_file(base, error) && fs::is_regular_file(with(base, kKey), error)) return base;
  }
  return std::nullopt;
}

bool is_name(const fs::path& file) { return !file.empty() && file != "-"; }

/// Whether writing to `file` replaces `other`.
bool replaced_by(const fs::path& other, const fs::path& file) {
  std::error_code error;
  if (!is_name(other) || (fs::exists(file, error) && !fs::is_regular_file(file, error))) return false;
  return same(other, file);
}

bool named_before(const fs::path& file, std::span<const fs::path> others) {
  return std::ranges::any_of(others, [&](const fs::path& other) { return replaced_by(other, file); });
}

QString shown_path(const fs::path& file) { return QString::fromStdString(file.string()); }

}  // namespace

std::optional<fs::path> records_of(const fs::path& file, const fs::path& database) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(file, error), error);
  const fs::path& path = error ? file : whole;
  if (auto found = database_of(path, database, kEndings)) return found;
  return database_of(path.parent_path(), database, std::span(&kStates, 1));
}

std::vector<fs::path> scenario_files(const fs::path& named) { return {named, named / "scenario.json"}; }

std::optional<Message> refuse_outputs(const std::vector<fs::path>& outputs, const fs::path& database, const std::vector<fs::path>& inputs) {
  const QString other_name = CliText::tr("Nothing was written. Give another name.");
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const fs::path& file = outputs[i];
    if (!is_name(file)) continue;
    if (const auto records = records_of(file, database))
      return Message{CliText::tr("%1 belongs to the database %2.").arg(shown_path(file), shown_path(*records)), other_name};
    if (named_before(file, std::span(outputs).first(i)) || named_before(file, inputs))
      return Message{CliText::tr("%1 is named twice.").arg(shown_path(file)), other_name};
  }
  return std::nullopt;
}

}  // namespace cusp::ui
