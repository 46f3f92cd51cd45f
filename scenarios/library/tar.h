/// A tar archive (POSIX.1-1988 ustar) of a few small-named files, in memory: what `tar` itself writes and unpacks. Stored, never
/// packed, so that an archive holds no more than its bytes. Any thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "scenarios/format/format_error.h"

namespace cusp::scenarios {

struct TarEntry {
  std::string name;       // without a folder
  std::string_view data;  // in the caller's bytes
};

/// Bytes of an entry's name at most.
inline constexpr std::size_t kMostTarName = 100;

/// The name, or one of kMostTarName bytes at most with the same beginning and the same suffix. UTF-8 is cut between characters.
std::string tar_name(std::string_view name);

/// The same entries give the same bytes. Pre: names of 1 to kMostTarName bytes.
std::string write_tar(const std::vector<TarEntry>& entries);

/// At most `most` regular files with plain names, each once, and nothing behind them. Codes: foreign_file, truncated, damaged,
/// bad_file_name, unnamed_file (a link, a folder, or one file too many). `data` points into `bytes`.
[[nodiscard]] Result<std::vector<TarEntry>, FormatFailure> read_tar(std::string_view bytes, std::size_t most);

}  // namespace cusp::scenarios
