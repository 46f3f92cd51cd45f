#include "storage/sqlite/main_file.h"

#include <algorithm>

namespace cusp::storage {

int read_at(sqlite3_file* file, std::span<std::byte> to, std::int64_t at) noexcept {
  constexpr std::size_t kMost = std::size_t{1} << 24;  // of one call: its length is an int
  while (!to.empty()) {
    const std::size_t now = std::min(to.size(), kMost);
    if (const int status = file->pMethods->xRead(file, to.data(), static_cast<int>(now), at); status != SQLITE_OK) {
      return status;
    }
    at += static_cast<std::int64_t>(now);
    to = to.subspan(now);
  }
  return SQLITE_OK;
}

std::optional<std::int64_t> size_of(sqlite3_file* file) noexcept {
  sqlite3_int64 size = 0;
  if (file->pMethods->xFileSize(file, &size) != SQLITE_OK) return std::nullopt;
  return size;
}

MainFile::MainFile(sqlite3* database) noexcept {
  sqlite3_file* found = nullptr;
  if (sqlite3_file_control(database, "main", SQLITE_FCNTL_FILE_POINTER, &found) != SQLITE_OK) return;
  if (found != nullptr && found->pMethods != nullptr) file_ = found;
}

int MainFile::lock_shared() noexcept {
  const int status = file_->pMethods->xLock(file_, SQLITE_LOCK_SHARED);
  locked_ = status == SQLITE_OK;
  return status;
}

int MainFile::lock_exclusive() noexcept { return file_->pMethods->xLock(file_, SQLITE_LOCK_EXCLUSIVE); }

void MainFile::unlock() noexcept {
  if (locked_) file_->pMethods->xUnlock(file_, SQLITE_LOCK_NONE);
  locked_ = false;
}

}  // namespace cusp::storage
