/// What a writer that was killed leaves beside a file: the part that it would have renamed (whole_file.h). Any thread but the haptic one.
#pragma once

#include <filesystem>

namespace cusp::scenarios {

/// Removes the parts of `file` that are a day older than `own`, the part just begun: no writer takes a day. A WholeFile's part is
/// FILE.part-DIGITS, with the last 12 digits of a UUID; FILE.ID and FILE.ID.part, with all of it, are other versions' parts. Any other
/// name stays. Failures are ignored.
void remove_left_parts(const std::filesystem::path& file, const std::filesystem::path& own);

}  // namespace cusp::scenarios
