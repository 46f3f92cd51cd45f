#include "ui/session/whole_file.h"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "engine/base/ids.h"
#include "scenarios/import/left_parts.h"
#include "storage/base/files.h"

namespace cusp::ui {

WholeFile::WholeFile(std::filesystem::path file) : file_{std::move(file)}, real_{behind_links(file_)} {
  std::error_code error;
  const std::filesystem::file_status there = std::filesystem::status(file_, error);
  const bool replaces = !std::filesystem::exists(there) || std::filesystem::is_regular_file(there);
  if (replaces) {
    beside_ = real_;
    beside_ += '.' + Uuid::v7().text();
  }
  errno = 0;
  out_.open(replaces ? beside_ : file_, std::ios::binary);
  if (!out_.is_open()) {
    error_ = errno;
    beside_.clear();
    return;
  }
  if (!replaces) return;
  // Before the content: others may not have leave to read it.
  if (std::filesystem::exists(there)) std::filesystem::permissions(beside_, there.permissions(), error);
  remove_left_parts(real_, beside_);
}

WholeFile::~WholeFile() {
  if (beside_.empty()) return;
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(beside_, ignored);
}

Stored<void> WholeFile::failed_with(int error) {
  if (error_ == 0) error_ = error != 0 ? error : EIO;
  return fail(error_from_errno(error_), file_.string(), std::strerror(error_));
}

Stored<void> WholeFile::write(std::string_view piece) {
  errno = 0;
  if (!out_.write(piece.data(), static_cast<std::streamsize>(piece.size()))) return failed_with(errno);
  return {};
}

Stored<void> WholeFile::close() {
  if (closed_) return {};
  errno = 0;
  out_.close();
  if (out_.fail()) return failed_with(errno);
  if (auto synced = beside_.empty() ? Stored<void>{} : sync_file(beside_); !synced) {
    error_ = EIO;
    return fail(synced.error().code, file_.string(), synced.error().detail);
  }
  closed_ = true;
  return {};
}

Stored<void> WholeFile::finish() {
  if (auto done = close(); !done) return done;
  if (beside_.empty()) return {};
  std::error_code error;
  std::filesystem::rename(beside_, real_, error);
  if (error) return failed_with(error.value());
  beside_.clear();
  return {};
}

}  // namespace cusp::ui
