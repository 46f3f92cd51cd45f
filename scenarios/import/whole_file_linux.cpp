#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "engine/base/ids.h"
#include "scenarios/import/left_parts.h"
#include "scenarios/import/whole_file.h"

namespace cusp::scenarios {
namespace {

namespace fs = std::filesystem;

/// What links lead to, also if it is not there yet.
fs::path behind_file_links(fs::path file) {
  std::error_code error;
  // Linux follows at most 40 links.
  for (int followed = 0; followed < 40 && fs::is_symlink(file, error); ++followed) {
    const fs::path target = fs::read_symlink(file, error);
    if (error) break;
    file = file.parent_path() / target;
  }
  return file;
}

/// Waits until the disk holds the content. A file system that cannot sync is no failure.
bool sync_content(int descriptor) { return fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS || errno == ENOSYS; }

/// Waits until the disk holds the file's name. A failure changes nothing: the file bears the name already.
void sync_name(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

}  // namespace

WholeFile::WholeFile(const fs::path& file) : real_{behind_file_links(file)} {
  std::error_code error;
  const fs::file_status there = fs::status(real_, error);
  const bool replaces = !fs::exists(there) || fs::is_regular_file(there);
  if (replaces) {
    part_ = real_;
    part_ += std::string(kPartMark) + Uuid::v7().text().substr(24);  // 12 random digits
    constexpr int usual_mode = 0666;  // less what the umask takes
    descriptor_ = open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, usual_mode);
    if (descriptor_ < 0) {
      error_ = errno;
      part_.clear();
      return;
    }
  }
  errno = 0;
  out_.open(replaces ? part_ : real_, std::ios::binary);
  if (!out_.is_open()) {
    failed_with(errno);
    return;
  }
  if (replaces) {
    // Before the content: others may not have leave to read it.
    if (fs::exists(there)) fs::permissions(part_, there.permissions(), error);
    remove_left_parts(real_, part_);
  }
  errno = 0;
}

WholeFile::~WholeFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (part_.empty()) return;
  std::error_code ignored;
  fs::remove(part_, ignored);
}

std::unexpected<std::error_code> WholeFile::failed_with(int error) {
  if (error_ == 0) error_ = error != 0 ? error : EIO;
  return std::unexpected(std::error_code(error_, std::generic_category()));
}

Result<void, std::error_code> WholeFile::write(std::string_view piece) {
  if (error_ != 0) return failed_with(error_);
  errno = 0;
  if (!out_.write(piece.data(), static_cast<std::streamsize>(piece.size()))) return failed_with(errno);
  return {};
}

Result<void, std::error_code> WholeFile::close() {
  if (closed_) return {};
  // A stream that has refused something left its reason there.
  if (out_.good()) errno = 0;
  out_.close();
  if (error_ != 0 || out_.fail()) return failed_with(errno);
  if (descriptor_ >= 0 && !sync_content(descriptor_)) return failed_with(errno);
  closed_ = true;
  return {};
}

Result<void, std::error_code> WholeFile::finish() {
  if (auto done = close(); !done) return done;
  if (part_.empty()) return {};
  std::error_code error;
  fs::rename(part_, real_, error);
  if (error) return failed_with(error.value());
  part_.clear();
  sync_name(real_);
  return {};
}

Result<void, std::error_code> write_whole_file(const fs::path& file, std::string_view bytes) {
  WholeFile whole(file);
  if (auto begun = whole.write(bytes); !begun) return begun;
  return whole.finish();
}

}  // namespace cusp::scenarios
