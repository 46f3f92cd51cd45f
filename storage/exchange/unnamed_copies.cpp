#include "storage/exchange/unnamed_copies.h"

#include <optional>
#include <string>
#include <system_error>

#include "engine/base/ids.h"
#include "storage/base/files.h"
#include "storage/base/left_folders.h"
#include "storage/base/process.h"
#include "storage/modules.h"

namespace cusp::storage {
namespace {

namespace fs = std::filesystem;

fs::path note_of(const fs::path& copy) { return copy.string() + ".name"; }
/// Locked while the process lives that makes the copy.
fs::path lock_of(const fs::path& copy) { return copy.string() + ".making"; }

/// A second name may be that of the records: the close() after reading drops their locks.
bool is_lone_file(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(fs::symlink_status(file, error)) && fs::hard_link_count(file, error) <= 1;
}

/// nullopt unless the copy is to take the name of a file in `folder` that is not there.
std::optional<UnnamedCopy> unnamed_copy(const fs::path& copy, const fs::path& folder) {
  if (!is_lone_file(copy) || !is_lone_file(note_of(copy))) return std::nullopt;
  const auto note = read_private_file(note_of(copy));
  if (!note || !*note) return std::nullopt;
  const auto line = (*note)->find('\n');
  if (line == std::string::npos || process_runs((*note)->substr(0, line), lock_of(copy))) return std::nullopt;
  // A name may hold a line's end, and nothing follows it.
  const fs::path name = (*note)->substr(line + 1);
  std::error_code error;
  if (name.empty() || name != name.filename() || fs::symlink_status(folder / name, error).type() != fs::file_type::not_found) return std::nullopt;
  return UnnamedCopy{copy, folder / name};
}

/// duplicate if something has the name, also a link that leads nowhere; else why no file can have it, as one that is too long.
Stored<void> check_free(const fs::path& name) {
  std::error_code error;
  const fs::file_status there = fs::symlink_status(name, error);
  if (there.type() == fs::file_type::not_found) return {};
  if (there.type() == fs::file_type::none) return std::unexpected(failure_from(error, name));
  return fail(StorageError::duplicate, name.string());
}

/// Until the copy has its name, its process holds a lock: nobody else gives it one meanwhile.
Stored<void> make_and_name(const fs::path& copy, const fs::path& real, const MakeCopy& make) {
  const ProcessMark mark(lock_of(copy));
  const auto note = [&]() -> Stored<void> {
    if (auto free = check_free(real); !free) return free;
    return replace_private_file(note_of(copy), mark.text() + '\n' + real.filename().string());
  };
  auto done = make(copy, note);
  return done ? rename_new(copy, real) : done;
}

/// People know the name that they gave.
StorageFailure failure_of_copy(const StorageFailure& failure, const fs::path& file) {
  return {failure.code, file.string(), failure.code == StorageError::duplicate ? std::string() : failure.detail};
}

}  // namespace

Stored<void> make_named(const fs::path& file, const MakeCopy& make) {
  std::error_code error;
  const fs::path real = fs::absolute(behind_links(file), error), parent = real.parent_path();
  if (auto free = check_free(real); !free) return std::unexpected(failure_of_copy(free.error(), file));
  if (!fs::is_directory(parent, error)) return fail(StorageError::not_found, parent.string(), "folder");
  remove_left_folders(parent, kCopying, [](std::string_view name) { return name.starts_with(kCopied); });
  const fs::path folder = parent / (std::string(kCopying) + Uuid::v7().text());
  if (auto made = make_private_folder(folder); !made) return std::unexpected(failure_of_copy(made.error(), file));
  const auto done = make_and_name(folder / kCopied, real, make);
  fs::remove_all(folder, error);
  if (done) return done;
  const std::string& where = done.error().where;
  const bool of_copy = where == real.string() || where.starts_with(folder.string());
  return std::unexpected(of_copy ? failure_of_copy(done.error(), file) : done.error());
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
