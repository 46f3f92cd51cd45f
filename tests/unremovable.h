/// A folder whose files nobody can remove, for as long as this lives. Root is refused by the file system's immutable flag.
#pragma once

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

namespace cusp::test {

class Unremovable {
 public:
  explicit Unremovable(const std::filesystem::path& folder) : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    holds_ = geteuid() == 0 ? set_immutable(true) : fchmod(folder_, S_IRUSR | S_IXUSR) == 0;
  }
  ~Unremovable() {
    if (holds_) static_cast<void>(geteuid() == 0 ? set_immutable(false) : fchmod(folder_, S_IRWXU) == 0);
    if (folder_ >= 0) ::close(folder_);
  }
  Unremovable(const Unremovable&) = delete;
  Unremovable& operator=(const Unremovable&) = delete;

  /// False on a file system without the flag.
  bool holds() const { return holds_; }

 private:
  bool set_immutable(bool on) const {
    int flags = 0;
    if (ioctl(folder_, FS_IOC_GETFLAGS, &flags) != 0) return false;
    flags = on ? flags | FS_IMMUTABLE_FL : flags & ~FS_IMMUTABLE_FL;
    return ioctl(folder_, FS_IOC_SETFLAGS, &flags) == 0;
  }
  int folder_;
  bool holds_ = false;
};

}  // namespace cusp::test
