#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "storage/base/locked_folder.h"

namespace cusp::storage {
namespace {

int operation_of(FolderLock lock) noexcept {
  if (lock == FolderLock::shared) return LOCK_SH;
  return lock == FolderLock::alone ? LOCK_EX : LOCK_EX | LOCK_NB;
}

}  // namespace

LockedFolder::LockedFolder(const std::filesystem::path& folder, FolderLock lock)
    : descriptor_{open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)} {
  if (descriptor_ < 0) return;
  int status = flock(descriptor_, operation_of(lock));
  while (status != 0 && errno == EINTR) status = flock(descriptor_, operation_of(lock));
  locked_ = status == 0;
}

LockedFolder::~LockedFolder() {
  const int error = errno;
  if (descriptor_ >= 0) close(descriptor_);
  errno = error;
}

}  // namespace cusp::storage
