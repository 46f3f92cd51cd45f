#include <fcntl.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "storage/files.h"

namespace cusp::storage {
namespace {

// From the kernel's sources where linux/magic.h leaves them out.
constexpr unsigned long kCifs = 0xFF534D42, kSmb2 = 0xFE534D42, kLustre = 0x0BD00BD0, kGpfs = 0x47504653,
                        kFuse = 0x65735546;

/// FUSE carries local disks too: the mount's type tells ("fuse.sshfs"). The longest mount point above `folder` counts.
bool network_fuse(const std::filesystem::path& folder) {
  std::ifstream mounts("/proc/self/mountinfo");
  const std::string path = folder.string();
  std::string line, type;
  std::size_t longest = 0;
  while (std::getline(mounts, line)) {
    std::istringstream words(line);
    std::string word, point, dash;
    words >> word >> word >> word >> word >> point;
    while (words >> dash && dash != "-") continue;
    std::string kind;
    words >> kind;
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
  StorageError code = StorageError::io;
  if (error == ENOENT || error == ENOTDIR) code = StorageError::not_found;
  if (error == EACCES || error == EPERM || error == EROFS) code = StorageError::read_only;
  if (error == ENOSPC || error == EDQUOT) code = StorageError::disk_full;
  if (error == EEXIST) code = StorageError::duplicate;
  return {code, file.string(), std::strerror(error)};
}

/// All of it, on the disk.
bool write_through(int descriptor, const std::string& content) {
  for (std::size_t at = 0; at < content.size();) {
    const ssize_t wrote = write(descriptor, content.data() + at, content.size() - at);
    if (wrote > 0) at += static_cast<std::size_t>(wrote);
    if (wrote <= 0 && !(wrote < 0 && errno == EINTR)) return false;
  }
  return fsync(descriptor) == 0;
}

}  // namespace

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

Stored<void> write_private_file(const std::filesystem::path& file, const std::string& content) {
  std::string fresh = file.string() + "." + std::string(6, 'X');  // mkstemp fills the last six in
  const int descriptor = mkstemp(fresh.data());                   // made readable by its owner alone
  if (descriptor < 0) return std::unexpected(failure_now(file));
  bool good = write_through(descriptor, content);
  // link() and not rename(): it refuses to replace a file that came in between.
  good = good && link(fresh.c_str(), file.c_str()) == 0;
  Stored<void> result;
  if (!good) result = std::unexpected(failure_now(file));
  close(descriptor);
  unlink(fresh.c_str());
  if (good) {
    const auto folder = std::filesystem::absolute(file).parent_path();
    if (const int d = open(folder.c_str(), O_RDONLY | O_DIRECTORY); d >= 0) {
      fsync(d);
      close(d);
    }
  }
  return result;
}

Stored<void> replace_private_file(const std::filesystem::path& file, const std::string& content) {
  // One name, so that a process that dies here leaves one file and the next one writes over it.
  const std::string fresh = file.string() + ".new";
  const int descriptor = open(fresh.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR);
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
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    if (errno == ENOENT) return std::optional<std::string>{};
    return std::unexpected(failure_now(file));
  }
  std::string content;
  std::array<char, 512> piece{};
  ssize_t got = 0;
  while ((got = read(descriptor, piece.data(), piece.size())) > 0 && content.size() < 65536) {
    content.append(piece.data(), static_cast<std::size_t>(got));
  }
  Stored<std::optional<std::string>> result{content};
  if (got < 0) result = std::unexpected(failure_now(file));
  close(descriptor);
  return result;
}

}  // namespace cusp::storage
