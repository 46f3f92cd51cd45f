/// A folder with a lock of the system on it: many share it, or one has it alone. Any thread.
#pragma once

#include <cstdint>
#include <filesystem>

namespace cusp::storage {

enum class FolderLock : std::uint8_t {
  shared,         // waits for one that has it alone
  alone,          // waits for all others
  alone_at_once,  // not while another has it
};

/// Held until the destructor, which keeps errno, or the end of the process.
class LockedFolder {
 public:
  LockedFolder(const std::filesystem::path& folder, FolderLock lock);
  ~LockedFolder();
  LockedFolder(const LockedFolder&) = delete;
  LockedFolder& operator=(const LockedFolder&) = delete;
  /// False also without such a folder, and on a drive that locks none.
  bool locked() const noexcept { return locked_; }

 private:
  int descriptor_ = -1;
  bool locked_ = false;
};

}  // namespace cusp::storage
