/// What a writer that was killed leaves beside a file: the part that it would have renamed. Any thread but the haptic one.
#pragma once

#include <filesystem>

namespace cusp::scenarios {

/// Removes the parts of `file` that are a day older than `own`, the part just begun: no writer takes a day. Parts are FILE.ID,
/// FILE.ID.part and FILE.part-DIGITS, with a UUID or its last 12 digits; any other name stays. Failures are ignored.
void remove_left_parts(const std::filesystem::path& file, const std::filesystem::path& own);

}  // namespace cusp::scenarios
