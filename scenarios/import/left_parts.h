/// What a writer that was killed leaves beside a file: the part that it would have renamed (whole_file.h). Any thread but the haptic one.
#pragma once

#include <filesystem>
#include <string_view>

namespace cusp::scenarios {

/// A WholeFile's part is named FILE, this and the last 12 digits of a UUID. Nobody else gives a file such a name.
inline constexpr std::string_view kPartMark = ".cusp-part-";

/// Removes the parts beside `file` that are a day older than `own`, the part just begun: no writer takes a day. Of another FILE they go
/// too: who was killed may never write that one again. FILE.part-DIGITS, FILE.ID and FILE.ID.part are parts of other versions, which
/// somebody else's file may resemble: they go with the same FILE. Any other name stays. Failures are ignored.
void remove_left_parts(const std::filesystem::path& file, const std::filesystem::path& own);

}  // namespace cusp::scenarios
