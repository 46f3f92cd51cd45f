/// A file that is written beside its name and takes the name at the end: the old one stays, or the whole new one, also after a power
/// cut. Thread: one, not the haptic one.
#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include "engine/base/result.h"

namespace cusp::scenarios {

/// Goes where links lead to; a file that is there keeps its permissions. Writes straight to a pipe or a device.
class WholeFile {
 public:
  /// Begins FILE.cusp-part-DIGITS, which no other program writes, and removes what one that was killed left in the folder (left_parts.h).
  /// If that fails, the first write() or close() does.
  explicit WholeFile(const std::filesystem::path& file);
  /// Removes what was not finished.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  // Each of these fails with the system's reason for the first failure.
  Result<void, std::error_code> write(std::string_view piece);
  /// For what writes to streams: close() fails if the stream has refused anything.
  std::ostream& stream() { return out_; }
  /// All of it is on the disk, under no name yet: what is left to fail is the name.
  Result<void, std::error_code> close();
  /// Closes it at need, and gives it its name.
  Result<void, std::error_code> finish();

 private:
  std::unexpected<std::error_code> failed_with(int error);

  std::filesystem::path real_, part_;  // behind links; as it is written: empty for a pipe or a device
  std::ofstream out_;
  int descriptor_ = -1;  // of the part, to sync it; its permissions may let nobody open it again
  int error_ = 0;        // an errno
  bool closed_ = false;
};

/// A WholeFile of these bytes.
Result<void, std::error_code> write_whole_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace cusp::scenarios
