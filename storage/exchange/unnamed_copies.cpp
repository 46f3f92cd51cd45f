#include "storage/exchange/unnamed_copies.h"

#include <optional>
#include <system_error>

#include "engine/base/ids.h"
#include "storage/base/files.h"
#include "storage/base/process.h"
#include "storage/modules.h"

namespace cusp::storage {
namespace {

namespace fs = std::filesystem;

fs::path note_of(const fs::path& copy) { return copy.string() + ".name"; }

bool is_file(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(fs::symlink_status(file, error));
}

/// nullopt unless the copy is to take the name of a file in `folder` that is not there.
std::optional<UnnamedCopy> unnamed_copy(const fs::path& copy, const fs::path& folder) {
  if (!is_file(copy) || !is_file(note_of(copy))) return std::nullopt;
  const auto note = read_private_file(note_of(copy));
  if (!note || !*note) return std::nullopt;
  const auto line = (*note)->find('\n');
  if (line == std::string::npos || process_runs((*note)->substr(0, line), lock_of_copy(copy))) return std::nullopt;
  // A name may hold a line's end, and nothing follows it.
  const fs::path name = (*note)->substr(line + 1);
  std::error_code error;
  if (name.empty() || name != name.filename() || fs::symlink_status(folder / name, error).type() != fs::file_type::not_found) return std::nullopt;
  return UnnamedCopy{copy, folder / name};
}

}  // namespace

fs::path lock_of_copy(const fs::path& copy) { return copy.string() + ".making"; }

Stored<void> note_name(const fs::path& copy, const fs::path& file, const std::string& process) {
  return replace_private_file(note_of(copy), process + '\n' + file.filename().string());
}

std::vector<UnnamedCopy> unnamed_copies(const fs::path& folder) {
  std::vector<UnnamedCopy> out;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (!name.starts_with(kCopying) || !Uuid::parse(std::string_view(name).substr(kCopying.size()))) continue;
    if (auto found = unnamed_copy(it->path() / kCopied, folder)) out.push_back(std::move(*found));
  }
  return out;
}

}  // namespace cusp::storage
