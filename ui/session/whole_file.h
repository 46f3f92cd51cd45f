/// A file that is written beside its name and takes the name at the end: the old one stays, or the whole new one. Thread: one.
#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

#include "storage/base/error.h"
#include "ui/modules.h"

namespace cusp::ui {

/// Goes where links lead to; a file that is there keeps its permissions. Writes straight to a pipe or a device.
class WholeFile {
 public:
  /// Begins it, and removes what a program that was killed left of the same name (scenarios/import/left_parts.h). Whether that went
  /// well says the first write(), or finish().
  explicit WholeFile(std::filesystem::path file);
  /// Removes what was not finished.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// The failures of these name the file, and the system's reason.
  Stored<void> write(std::string_view piece);
  /// All of it is on the disk, under no name yet: what is left to fail is the name.
  Stored<void> close();
  /// Closes it at need, and gives it its name.
  Stored<void> finish();

 private:
  /// Keeps the reason of the first failure.
  Stored<void> failed_with(int error);

  std::filesystem::path file_, real_, beside_;  // as named; behind links; as it is written: empty for a pipe or a device
  std::ofstream out_;
  bool closed_ = false;
  int error_ = 0;  // an errno
};

}  // namespace cusp::ui
