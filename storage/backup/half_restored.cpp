#include "storage/backup/half_restored.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <system_error>
#include <vector>

#include "engine/base/ids.h"
#include "storage/base/files.h"
#include "storage/base/left_folders.h"
#include "storage/base/process.h"
#include "storage/modules.h"
#include "storage/sqlite/hold_alone.h"

namespace cusp::storage {
namespace {

namespace fs = std::filesystem;

/// What a restore makes, by what follows the database's name.
constexpr std::array<const char*, 3> kRestored = {"", ".key", ".key-counter"};
/// What a database may have beside its own name. SQLite would lay a log or journal that is left over onto another database.
constexpr std::array<const char*, 6> kBeside = {"", "-wal", "-shm", "-journal", ".key", ".key-counter"};
constexpr const char *kNote = ".aside", *kLock = ".restoring";

Stored<void> move_all(const fs::path& from, const fs::path& to, const std::array<const char*, 6>& endings) {
  for (std::size_t i = 0; i < endings.size(); ++i) {
    std::error_code error;
    if (!fs::exists(from.string() + endings[i], error)) continue;
    fs::rename(from.string() + endings[i], to.string() + endings[i], error);
    if (!error) continue;
    const StorageFailure failure = failure_from(error, from.string() + endings[i]);
    for (std::size_t moved = i; moved-- > 0;) fs::rename(to.string() + endings[moved], from.string() + endings[moved], error);
    return std::unexpected(failure);
  }
  return {};
}

struct Note {
  std::string process;
  fs::path aside;                    // the database's name there; empty: nothing stood at the name
  std::vector<std::string> endings;  // of what stood at the name
};

/// nullopt without a note, or with one that nobody here has written.
std::optional<Note> read_note(const fs::path& folder, const fs::path& file) {
  const auto content = read_private_file(folder / (file.filename().string() + kNote));
  if (!content || !*content) return std::nullopt;
  std::istringstream in(**content);
  Note note;
  std::string ending;
  if (!std::getline(in, note.process) || !std::getline(in, ending) || !(ending.empty() || ending.starts_with(kAside))) return std::nullopt;
  if (ending.empty()) return note;
  note.aside = folder.parent_path() / (file.filename().string() + ending) / file.filename();
  while (std::getline(in, ending)) note.endings.push_back(ending);
  return note;
}

/// Whether all of the copy is in its database: SQLite keeps its log if closing could not write all of it there.
bool is_whole(const fs::path& fresh) {
  std::error_code error;
  return fs::exists(fresh, error) && !fs::exists(fresh.string() + "-wal", error);
}

/// Whether key or counter of the copy has its name, and neither name is another file's.
bool has_begun_naming(const fs::path& from, const fs::path& to) {
  bool begun = false;
  for (std::size_t i = 1; i < kRestored.size(); ++i) {
    const fs::path made = from.string() + kRestored[i], name = to.string() + kRestored[i];
    std::error_code error;
    if (!fs::exists(name, error)) continue;
    if (fs::exists(made, error) && !fs::equivalent(made, name, error)) return false;
    begun = true;
  }
  return begun;
}

/// A process that is killed while a name is taken may leave two links to one file.
Stored<void> name_rest(const fs::path& from, const fs::path& to) {
  for (std::size_t i = kRestored.size(); i-- > 0;) {
    const fs::path made = from.string() + kRestored[i], name = to.string() + kRestored[i];
    std::error_code error;
    if (!fs::exists(made, error)) continue;
    if (fs::equivalent(made, name, error)) {
      fs::remove(made, error);
    } else if (auto done = rename_new(made, name); !done) {
      return done;
    }
  }
  return {};
}

/// Those of any database beside this one in which a restore makes its copy.
std::vector<fs::path> restore_folders(const fs::path& file) {
  std::vector<fs::path> out;
  std::error_code error;
  for (fs::directory_iterator it(fs::absolute(file, error).parent_path(), error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.starts_with(kRestoring) && Uuid::parse(std::string_view(name).substr(kRestoring.size()))) out.push_back(it->path());
  }
  return out;
}

/// Whether the copy has its names now.
Stored<bool> carry_out(const Note& note, const fs::path& folder, const fs::path& file) {
  const fs::path fresh = folder / file.filename();
  if (process_runs(note.process, lock_of_half_done(fresh))) return fail(StorageError::busy, file.string());
  // Of two programs that start at once, one carries it out.
  const auto alone = hold_alone(note.aside.empty() ? fresh : note.aside);
  if (!alone) return fail(StorageError::busy, file.string());
  if (!is_half_done(folder, file)) return false;
  std::error_code error;
  for (const std::string& ending : note.endings) {
    const fs::path from = file.string() + ending, to = note.aside.string() + ending;
    // What is in the folder is the old one: the file at the name is the copy's.
    if (fs::exists(to, error) || !fs::exists(from, error)) continue;
    fs::rename(from, to, error);
    if (error) return std::unexpected(failure_from(error, from));
  }
  const bool whole = note.aside.empty() || is_whole(fresh);
  if (auto done = whole ? name_rest(fresh, file) : move_home(note.aside, file); !done) return std::unexpected(done.error());
  take_note_back(fresh);
  fs::remove_all(folder, error);
  return whole;
}

}  // namespace

Stored<void> nothing_beside(const fs::path& file) {
  std::error_code ignored;
  for (const char* ending : kBeside) {
    if (fs::exists(file.string() + ending, ignored)) return fail(StorageError::duplicate, file.string() + ending);
  }
  return {};
}

Stored<void> move_away(const fs::path& file, const fs::path& to) { return move_all(file, to, kBeside); }

Stored<void> move_home(const fs::path& from, const fs::path& file) {
  auto endings = kBeside;
  std::ranges::reverse(endings);
  return move_all(from, file, endings);
}

Stored<void> name_restored(const fs::path& from, const fs::path& to) {
  std::error_code error;
  // SQLite keeps its log if closing could not write all of it into the database.
  if (fs::exists(from.string() + "-wal", error)) return fail(StorageError::io, to.string());
  std::vector<fs::path> named;
  for (std::size_t i = kRestored.size(); i-- > 0;) {
    const fs::path made = from.string() + kRestored[i], name = to.string() + kRestored[i];
    if (!fs::exists(made, error)) continue;
    if (auto done = rename_new(made, name); !done) {
      for (const fs::path& own : named) fs::remove(own, error);
      return done;
    }
    named.push_back(name);
  }
  return {};
}

fs::path lock_of_half_done(const fs::path& fresh) { return fresh.string() + kLock; }

Stored<void> note_half_done(const fs::path& fresh, const fs::path& file, const fs::path& aside, const std::string& process) {
  if (aside.empty()) return replace_private_file(fresh.string() + kNote, process + "\n\n");
  std::error_code error;
  std::string text = process + '\n' + aside.filename().string().substr(file.filename().string().size()) + '\n';
  for (std::size_t i = 1; i < kBeside.size(); ++i)
    if (fs::exists(file.string() + kBeside[i], error)) text += std::string(kBeside[i]) + '\n';
  return replace_private_file(fresh.string() + kNote, text);
}

void take_note_back(const fs::path& fresh) {
  std::error_code ignored;
  fs::remove(fresh.string() + kNote, ignored);
}

bool is_half_done(const fs::path& folder, const fs::path& file) {
  std::error_code error;
  if (fs::exists(file, error)) return false;
  const auto note = read_note(folder, file);
  if (!note) return false;
  if (!note->aside.empty()) return fs::exists(note->aside, error);
  const fs::path fresh = folder / file.filename();
  return is_whole(fresh) && has_begun_naming(fresh, file);
}

void remove_left_restores(const fs::path& file) {
  std::error_code error;
  // The files of "a.db.old" begin with "a.db", too, and may be all that there is of it.
  const auto is_content = [name = file.filename().string()](std::string_view content) {
    if (!content.starts_with(name)) return false;
    content.remove_prefix(name.size());
    constexpr std::array made = {"-wal", "-shm", "-journal", ".key", ".running", ".states", kNote, kLock};
    return content.empty() || std::ranges::any_of(made, [content](const char* ending) { return content.starts_with(ending); });
  };
  for (const fs::path& folder : restore_folders(file)) {
    // A second name of the database itself: a restore was killed after its last one. Nobody would look there for what is to be erased.
    if (fs::equivalent(folder / file.filename(), file, error)) fs::remove(folder / file.filename(), error);
    if (is_left_folder(folder, is_content)) fs::remove_all(folder, error);
  }
}

Stored<bool> finish_half_done(const fs::path& file) {
  std::error_code error;
  if (file.empty() || fs::exists(file, error)) return false;
  std::vector<fs::path> due;
  for (fs::path& folder : restore_folders(file)) {
    if (is_half_done(folder, file)) due.push_back(std::move(folder));
  }
  if (due.empty()) return false;
  // UUIDs of version 7 sort by time: an older note was left where another restore took the name.
  const fs::path folder = *std::ranges::max_element(due);
  const auto note = read_note(folder, file);
  return note ? carry_out(*note, folder, file) : false;
}

}  // namespace cusp::storage
