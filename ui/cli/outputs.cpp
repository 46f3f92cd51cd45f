#include "ui/cli/outputs.h"

#include <array>
#include <string>
#include <string_view>

#include "ui/cli/text.h"

namespace cusp::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kKey = ".key";
/// What stands behind the database's name in those of its files.
constexpr std::array<std::string_view, 7> kEndings = {"", "-wal", "-shm", "-journal", kKey, ".key-counter", ".running"};

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

}  // namespace

std::optional<fs::path> records_of(const fs::path& file, const fs::path& database) {
  if (!database.empty()) {
    for (const std::string_view ending : kEndings) {
      if (same(file, with(database, ending))) return database;
    }
  }
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(file, error), error);
  if (error) return std::nullopt;
  const std::string name = whole.string();
  for (const std::string_view ending : kEndings) {
    if (!name.ends_with(ending)) continue;
    const fs::path base = name.substr(0, name.size() - ending.size());
    if (fs::is_regular_file(base, error) && fs::is_regular_file(with(base, kKey), error)) return base;
  }
  return std::nullopt;
}

std::optional<Message> refuse_outputs(const std::vector<fs::path>& outputs, const fs::path& database) {
  for (const fs::path& file : outputs) {
    if (file.empty() || file == "-") continue;
    const auto records = records_of(file, database);
    if (!records) continue;
    return Message{CliText::tr("%1 belongs to the database %2.")
                    .arg(QString::fromStdString(file.string()), QString::fromStdString(records->string())),
                CliText::tr("Nothing was written. Give another name.")};
  }
  return std::nullopt;
}

}  // namespace cusp::ui
