/// What a verb may not write: the records, what it reads, and one file twice. A database and the files that belong to it are written by
/// storage alone.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "ui/text/failure_text.h"

namespace cusp::ui {

/// What a verb may read where a scenario is named: the file, or that of a folder.
std::vector<std::filesystem::path> scenario_files(const std::filesystem::path& named);

/// A message if one of `outputs` is a file of the records, one of `inputs`, which the verb reads, or the same as another. Empty names
/// and "-" are no files; a pipe or a device takes more than one.
std::optional<Message> refuse_outputs(const std::vector<std::filesystem::path>& outputs, const std::filesystem::path& database = {},
                                      const std::vector<std::filesystem::path>& inputs = {});

}  // namespace cusp::ui
