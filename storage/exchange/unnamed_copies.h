/// Copies whose program was killed before they had their name: a note beside each holds it, and the mark of the process. Within storage
/// only. Thread: any.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "storage/base/error.h"

namespace cusp::storage {

/// The folder, beside the name, in which a copy is made: a UUID follows.
inline constexpr std::string_view kCopying = ".cusp-copy-";
/// The copy there; what belongs to it begins with its name.
inline constexpr const char* kCopied = "copy.db";

/// Locked while the process lives that makes the copy.
std::filesystem::path lock_of_copy(const std::filesystem::path& copy);
/// Notes the name that the copy is to take. `process`: ProcessMark::text().
Stored<void> note_name(const std::filesystem::path& copy, const std::filesystem::path& file, const std::string& process);

struct UnnamedCopy {
  std::filesystem::path made{}, file{};  ///< where it lies; the name that it is to take
};
/// Of `folder`, all with a note whose process has ended and whose name is free. Who names one checks first what it holds: anybody may
/// have put it there.
std::vector<UnnamedCopy> unnamed_copies(const std::filesystem::path& folder);

}  // namespace cusp::storage
