#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "ui/editor/draft_folder.h"

namespace cusp::ui {
namespace {

/// A folder with a lock of the system on it: many may share one, or one has it alone.
class LockedFolder {
 public:
  /// `how`: of flock().
  LockedFolder(const std::filesystem::path& folder, int how) : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0) return;
    int status = flock(descriptor_, how);
    while (status != 0 && errno == EINTR) status = flock(descriptor_, how);
    locked_ = status == 0;
  }
  ~LockedFolder() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  LockedFolder(const LockedFolder&) = delete;
  LockedFolder& operator=(const LockedFolder&) = delete;
  bool locked() const { return locked_; }

 private:
  int descriptor_ = -1;
  bool locked_ = false;
};

}  // namespace

std::shared_ptr<const void> hold_folder(const std::filesystem::path& folder) {
  auto held = std::make_shared<const LockedFolder>(folder, LOCK_SH);
  if (!held->locked()) return nullptr;
  return held;
}

void remove_unheld(const std::filesystem::path& folder, const std::function<bool()>& is_needed) {
  const LockedFolder alone(folder, LOCK_EX | LOCK_NB);
  if (!alone.locked() || is_needed()) return;
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
}

}  // namespace cusp::ui
