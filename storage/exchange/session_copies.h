/// Copies rows of this database into a new one, which then leaves the station. Within storage only.
#pragma once

#include <filesystem>
#include <functional>

#include "storage/sqlite/database.h"

namespace cusp::storage {

/// Makes `file`; while `fill` writes to it, `from` is attached as `source`. One file, without a log beside it; its owner alone may
/// read it. It takes its name once it is whole: a failure or a crash leaves nothing of that name, and what a program that was killed
/// left in the folder goes a day later. duplicate if the file exists.
Stored<void> make_copy(const std::filesystem::path& file, const std::filesystem::path& from,
                       const std::function<Stored<void>(Database&)>& fill);

/// One session with its statements, and what they refer to. A row that is there already stays.
void copy_session(Transaction& to, SessionId session);

}  // namespace cusp::storage
