/// Copies rows of this database into a new one, which then leaves the station. Within storage only.
#pragma once

#include <filesystem>
#include <functional>

#include "storage/sqlite/database.h"

namespace cusp::storage {

/// Work on a copy before it has its name.
using OnCopy = std::function<Stored<void>(Database&)>;

/// Makes `file` as make_named() does; while `fill` writes to it, `from` is attached as `source`. One file, without a log beside it; its
/// owner alone may read it. `finish` finds it so, without `source`, and a note of its name beside it: what is left to fail after it is the
/// name. duplicate if the file exists; before `finish` is called, if it does then.
Stored<void> make_copy(const std::filesystem::path& file, const std::filesystem::path& from, const OnCopy& fill, const OnCopy& finish = {});

/// One session with its statements, and what they refer to. A row that is there already stays. False while it runs, and nothing is
/// copied: somebody may have taken it up again since it was chosen.
[[nodiscard]] bool copy_session(Transaction& to, SessionId session);

}  // namespace cusp::storage
