#include <fcntl.h>
#include <linux/magic.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <span>
#include <sstream>
#include <vector>

#include "storage/base/files.h"
#include "storage/base/locked_folder.h"

namespace cusp::storage {
namespace {

// Source: the kernel's file systems; linux/magic.h lacks these.
constexpr unsigned long kCifs = 0xFF534D42, kSmb2 = 0xFE534D42, kLustre = 0x0BD00BD0, kGpfs = 0x47504653,
                        kFuse = 0x65735546;

/// mountinfo writes a space, a tab, a line's end and a backslash as three octal digits. Source: proc(5).
std::string without_octal(const std::string& point) {
  std::string out;
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (point[i] != '\\' || i + 3 >= point.size()) {
      out += point[i];
      continue;
    }
    out += static_cast<char>((point[i + 1] - '0') << 6 | (point[i + 2] - '0') << 3 | (point[i + 3] - '0'));
    i += 3;
  }
  return out;
}

/// FUSE serves local disks too: the mount's type decides ("fuse.sshfs"). The longest mount point above `folder` counts.
bool network_fuse(const std::filesystem::path& folder) {
  std::ifstream mounts("/proc/self/mountinfo");
  const std::string path = folder.string();
  std::string line, type;
  std::size_t longest = 0;
  while (std::getline(mounts, line)) {
    std::istringstream fields(line);
    std::string skipped, point, dash;
    fields >> skipped >> skipped >> skipped >> skipped >> point;
    point = without_octal(point);
    while (fields >> dash && dash != "-") continue;
    std::string kind;
    fields >> kind;
    const bool above =
        path.starts_with(point) && (point.size() == path.size() || point.ends_with('/') || path[point.size()] == '/');
    if (above && point.size() >= longest) {
      longest = point.size();
      type = kind;
    }
  }
  constexpr std::array network = {"fuse.sshfs", "fuse.rclone",     "fuse.glusterfs", "fuse.davfs",
                                  "fuse.s3fs",  "fuse.gvfsd-fuse", "fuse.smbnetfs",  "fuse.curlftpfs"};
  for (const char* name : network) {
    if (type == name) return true;
  }
  return false;
}

StorageFailure failure_now(const std::filesystem::path& file) {
  const int error = errno;
  return {error_from_errno(error), file.string(), std::strerror(error)};
}

/// Writes all of `content` and syncs it.
bool write_through(int descriptor, std::string_view content) {
  for (std::size_t at = 0; at < content.size();) {
    const ssize_t wrote = write(descriptor, content.data() + at, content.size() - at);
    if (wrote > 0) at += static_cast<std::size_t>(wrote);
    if (wrote <= 0 && !(wrote < 0 && errno == EINTR)) return false;
  }
  return fsync(descriptor) == 0;
}

/// -1 if the folder of `file` cannot be opened.
int open_folder_of(const std::filesystem::path& file) {
  std::error_code ignored;
  return open(std::filesystem::absolute(file, ignored).parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

/// Waits until the disk holds the name. A failure changes nothing: the file bears it already.
void sync_folder_of(const std::filesystem::path& file) {
  const int folder = open_folder_of(file);
  if (folder < 0) return;
  fsync(folder);
  close(folder);
}

/// For reading; -1 if there is no file, or something else than a file.
int open_regular(const std::filesystem::path& file) {
  // O_NONBLOCK does not wait for the other end of a pipe.
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return -1;
  struct stat about{};
  if (fstat(descriptor, &about) == 0 && S_ISREG(about.st_mode)) return descriptor;
  close(descriptor);
  errno = S_ISDIR(about.st_mode) ? EISDIR : EINVAL;
  return -1;
}

/// For a drive that knows neither link() nor RENAME_NOREPLACE: asks, then renames. The folder's lock keeps other programs of Cusp out
/// between the two, and ends with its process: one that is killed leaves nothing of the name.
bool rename_if_free(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code ignored;
  // Some network drives lock no folder: then only the moment between the two is open.
  const LockedFolder folder(std::filesystem::absolute(to, ignored).parent_path(), FolderLock::alone);
  struct stat there{};
  if (lstat(to.c_str(), &there) == 0) {
    errno = EEXIST;
    return false;
  }
  return errno == ENOENT && rename(from.c_str(), to.c_str()) == 0;
}

/// Each way fails with EEXIST if another process created `to` meanwhile. A drive that refuses a link for another reason, as FAT each and AFS
/// one between two folders, may still rename.
bool take_name(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (link(from.c_str(), to.c_str()) == 0) {
    unlink(from.c_str());
    return true;
  }
  if (errno == EEXIST) return false;
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  const bool unknown = errno == EINVAL || errno == ENOSYS || errno == EOPNOTSUPP;
  return unknown && rename_if_free(from, to);
}

/// Whether mkostemp() may have named it for write_private_file().
bool is_fresh_name(std::string_view name, std::string_view of_file) {
  if (!name.starts_with(of_file)) return false;
  name.remove_prefix(of_file.size());
  const auto drawn = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  return name.size() == 7 && name.front() == '.' && std::ranges::all_of(name.substr(1), drawn);
}

void remove_if_left(const std::filesystem::path& fresh, const std::filesystem::path& file) {
  const int descriptor = open(fresh.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW);
  if (descriptor < 0) return;
  struct stat left{}, real{};
  const bool own = fstat(descriptor, &left) == 0 && S_ISREG(left.st_mode) && left.st_uid == geteuid();
  // lstat(): if `file` is a link, what it leads to is the only one.
  const bool second_name = own && lstat(file.c_str(), &real) == 0 && real.st_dev == left.st_dev && real.st_ino == left.st_ino;
  // Whoever writes it holds the lock until it has its name.
  if (own && (second_name || left.st_size == 0) && flock(descriptor, LOCK_EX | LOCK_NB) == 0) unlink(fresh.c_str());
  close(descriptor);
}

}  // namespace

std::filesystem::path behind_links(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::path whole = std::filesystem::absolute(file, error);
  // weakly_canonical() keeps a link whose file is not there. Linux follows at most 40 links.
  for (int followed = 0; followed < 40 && std::filesystem::is_symlink(whole, error); ++followed) {
    const std::filesystem::path target = std::filesystem::read_symlink(whole, error);
    if (error) return file;
    whole = whole.parent_path() / target;
  }
  error.clear();
  const std::filesystem::path real = std::filesystem::weakly_canonical(whole, error);
  return error ? file : real;
}

StorageError error_from_errno(int error) noexcept {
  switch (error) {
    case ENOENT:
      return StorageError::not_found;
    case EACCES:
    case EPERM:
    case EROFS:
      return StorageError::read_only;
    case ENOSPC:
      return StorageError::disk_full;
    case EDQUOT:
      return StorageError::quota_exceeded;
    case EFBIG:
      return StorageError::file_too_large;
    case ENOMEM:
      return StorageError::out_of_memory;
    case EEXIST:
      return StorageError::duplicate;
    default:
      return StorageError::io;
  }
}

StorageFailure failure_from(const std::error_code& error, const std::filesystem::path& where) {
  return {error_from_errno(error.value()), where.string(), error.message()};
}

bool on_network_drive(const std::filesystem::path& folder) {
  struct statfs about{};
  if (statfs(folder.c_str(), &about) != 0) return false;
  const auto type = static_cast<unsigned long>(about.f_type) & 0xFFFFFFFFul;
  switch (type) {
    case NFS_SUPER_MAGIC:
    case SMB_SUPER_MAGIC:
    case AFS_SUPER_MAGIC:
    case CODA_SUPER_MAGIC:
    case CEPH_SUPER_MAGIC:
    case OCFS2_SUPER_MAGIC:
    case kCifs:
    case kSmb2:
    case kLustre:
    case kGpfs:
      return true;
    case kFuse:
      return network_fuse(std::filesystem::absolute(folder));
    default:
      return false;
  }
}

bool can_write(const std::filesystem::path& path) { return faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0; }

Stored<void> make_private_file(const std::filesystem::path& file) {
  if (mknod(file.c_str(), S_IFREG | S_IRUSR | S_IWUSR, 0) != 0) return std::unexpected(failure_now(file));
  return {};
}

Stored<void> make_private_folder(const std::filesystem::path& folder) {
  if (mkdir(folder.c_str(), S_IRWXU) != 0) return std::unexpected(failure_now(folder));
  sync_folder_of(folder);
  return {};
}

Stored<void> rename_new(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (!take_name(from, to)) return std::unexpected(failure_now(to));
  sync_folder_of(to);
  return {};
}

Stored<void> write_private_file(const std::filesystem::path& file, const std::string& content) {
  std::string fresh = file.string() + "." + std::string(6, 'X');  // mkostemp replaces the last six
  const int descriptor = mkostemp(fresh.data(), O_CLOEXEC);       // readable by its owner alone
  if (descriptor < 0) return std::unexpected(failure_now(file));
  flock(descriptor, LOCK_EX | LOCK_NB);  // for remove_left_writes(); a drive that locks nothing leaves them
  Stored<void> result;
  if (write_through(descriptor, content)) {
    result = rename_new(fresh, file);
  } else {
    result = std::unexpected(failure_now(file));
  }
  close(descriptor);
  if (!result) unlink(fresh.c_str());
  return result;
}

void remove_left_writes(const std::filesystem::path& file) {
  std::error_code error;
  const std::string name = file.filename().string();
  std::vector<std::filesystem::path> left;
  const std::filesystem::path folder = std::filesystem::absolute(file, error).parent_path();
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (is_fresh_name(it->path().filename().string(), name)) left.push_back(it->path());
  }
  for (const std::filesystem::path& fresh : left) remove_if_left(fresh, file);
}

Stored<void> write_new_file(const std::filesystem::path& file, std::string_view content) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return std::unexpected(failure_now(file));
  Stored<void> result;
  if (!write_through(descriptor, content)) result = std::unexpected(failure_now(file));
  close(descriptor);
  return result;
}

Stored<void> replace_private_file(const std::filesystem::path& file, const std::string& content) {
  // A fixed name: what a process left that died here goes first. So does a pipe, which would wait for its other end.
  const std::string fresh = file.string() + ".new";
  unlink(fresh.c_str());
  const int descriptor = open(fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (descriptor < 0) return std::unexpected(failure_now(file));
  const bool good = write_through(descriptor, content) && rename(fresh.c_str(), file.c_str()) == 0;
  Stored<void> result;
  if (!good) {
    result = std::unexpected(failure_now(file));
    unlink(fresh.c_str());
  }
  close(descriptor);
  return result;
}

Stored<std::optional<std::string>> read_private_file(const std::filesystem::path& file) {
  const int descriptor = open_regular(file);
  if (descriptor < 0) {
    if (errno == ENOENT) return std::optional<std::string>{};
    return std::unexpected(failure_now(file));
  }
  std::string content;
  std::array<char, 512> part{};
  ssize_t got = 0;
  while ((got = read(descriptor, part.data(), part.size())) > 0 && content.size() < 65536) {
    content.append(part.data(), static_cast<std::size_t>(got));
  }
  Stored<std::optional<std::string>> result{content};
  if (got < 0) result = std::unexpected(failure_now(file));
  close(descriptor);
  return result;
}

Stored<Hash256> hash_of_file(const std::filesystem::path& file) {
  const int descriptor = open_regular(file);
  if (descriptor < 0) return std::unexpected(failure_now(file));
  std::vector<std::byte> block(std::size_t{1} << 20);
  Blake2b hash;
  ssize_t got = 0;
  while ((got = read(descriptor, block.data(), block.size())) > 0) hash.add_part(std::span(block).first(static_cast<std::size_t>(got)));
  Stored<Hash256> result = hash.finish();
  if (got < 0) result = std::unexpected(failure_now(file));
  close(descriptor);
  return result;
}

}  // namespace cusp::storage
