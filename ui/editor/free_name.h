/// The name of a volume beside a draft. Windows of several programs write to one folder. Thread: any.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "storage/base/error.h"
#include "ui/modules.h"

namespace cusp::ui {

struct VolumeWriter {
  /// Whether a file that has the name already is this volume: then nothing is written. Null: none is.
  std::function<bool(const std::filesystem::path& there)> is_it;
  /// Writes a new file, whose name is not yet the volume's.
  std::function<Stored<void>(const std::filesystem::path& file)> write;
};

/// Writes a volume as NAME, NAME-2, NAME-3, …, each with the suffix of `wanted`, and returns the first name that nobody else has. The
/// volume takes its name whole, by a rename that replaces nothing: two windows never replace each other's volume, and after a failure, or
/// a program that is killed, the name is free. A failure to write names the file as it would be called. Pre: the folder is there.
Stored<std::string> write_under_free_name(const std::filesystem::path& folder, const std::string& wanted, const VolumeWriter& volume);

/// Whether both files can be read and hold the same bytes.
bool hold_the_same(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace cusp::ui
