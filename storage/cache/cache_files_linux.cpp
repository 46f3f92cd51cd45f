#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "storage/base/files.h"
#include "storage/cache/cache_files.h"

namespace cusp::storage {

Stored<void> write_cache_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  std::string fresh = file.string() + "." + std::string(6, 'X');  // mkostemp replaces the last six
  const int descriptor = mkostemp(fresh.data(), O_CLOEXEC);       // readable by its owner alone
  bool good = descriptor >= 0;
  for (std::size_t at = 0; good && at < bytes.size();) {
    const ssize_t wrote = write(descriptor, bytes.data() + at, bytes.size() - at);
    if (wrote > 0) at += static_cast<std::size_t>(wrote);
    good = wrote > 0 || (wrote < 0 && errno == EINTR);
  }
  good = good && fdatasync(descriptor) == 0 && std::rename(fresh.c_str(), file.c_str()) == 0;
  const int error = errno;
  if (descriptor >= 0) close(descriptor);
  if (good) return {};
  if (descriptor >= 0) unlink(fresh.c_str());
  return fail(error_from_errno(error), file.string(), std::strerror(error));
}

std::optional<std::vector<std::byte>> read_cache_file(const std::filesystem::path& file, std::size_t most_bytes) {
  // O_NOFOLLOW refuses links; O_NONBLOCK does not wait for the other end of a pipe.
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return std::nullopt;
  struct stat about{};
  bool good = fstat(descriptor, &about) == 0 && S_ISREG(about.st_mode) &&
              static_cast<std::uint64_t>(about.st_size) <= most_bytes;
  std::vector<std::byte> bytes(good ? static_cast<std::size_t>(about.st_size) : 0);
  for (std::size_t at = 0; good && at < bytes.size();) {
    const ssize_t got = read(descriptor, bytes.data() + at, bytes.size() - at);
    if (got > 0) at += static_cast<std::size_t>(got);
    good = got > 0 || (got < 0 && errno == EINTR);
  }
  close(descriptor);
  if (!good) return std::nullopt;
  return bytes;
}

}  // namespace cusp::storage
