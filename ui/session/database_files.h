/// The files of a database, which storage alone writes. Opens none. Thread: any.
#pragma once

#include <filesystem>
#include <optional>

#include "ui/modules.h"

namespace cusp::ui {

/// Whether both name one file, behind links and "..". Neither need be there.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// The database whose file `file` is, or whose log, key, counter, lock file, folder of key states or file in that folder.
/// Known by its key's file beside it; `database` is the one that the caller itself opens, and need not be there yet.
std::optional<std::filesystem::path> database_of_file(const std::filesystem::path& file, const std::filesystem::path& database = {});

}  // namespace cusp::ui
