/// Files that take their name once they are whole, and copies whose program was killed before that: a note beside each holds its name, and
/// the mark of the process. Within storage only. Thread: any.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "storage/base/error.h"

namespace cusp::storage {

/// The folder, beside the name, in which a copy is made: a UUID follows.
inline constexpr std::string_view kCopying = ".cusp-copy-";
/// The copy there, a database or not; what belongs to it begins with its name.
inline constexpr const char* kCopied = "copy.db";

/// Notes the name that the copy is to take; called once the copy is whole, before the log has its entry. duplicate if something has taken
/// the name meanwhile.
using NoteName = std::function<Stored<void>()>;
/// Makes the copy at a path in a folder of its own.
using MakeCopy = std::function<Stored<void>(const std::filesystem::path& copy, const NoteName& note)>;

/// Makes `file`, which takes its name once `make` has returned: a failure or a crash leaves nothing of that name, and what a program that
/// was killed left in the folder goes a day later. duplicate if the file exists.
Stored<void> make_named(const std::filesystem::path& file, const MakeCopy& make);

struct UnnamedCopy {
  std::filesystem::path made{}, file{};  ///< where it lies; the name that it is to take
};
/// Of `folder`, all with a note whose process has ended and whose name is free. Who names one checks first what it holds: anybody may
/// have put it there.
std::vector<UnnamedCopy> unnamed_copies(const std::filesystem::path& folder);

}  // namespace cusp::storage
