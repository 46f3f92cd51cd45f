#include "ui/session/file_bytes.h"

#include <cerrno>
#include <fstream>
#include <span>
#include <system_error>

#include "storage/base/files.h"

namespace cusp::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPieceBytes = 1 << 16;

std::unexpected<StorageFailure> cannot_read(int error, const fs::path& file) {
  return std::unexpected(failure_from({error, std::generic_category()}, file));
}

}  // namespace

// read() reports what the disk refuses: an iterator of the stream's buffer throws it, and << of the buffer reports none once a part
// is written.
Stored<void> for_pieces(const fs::path& file, std::uintmax_t most_bytes, const std::function<Stored<void>(std::string_view piece)>& visit) {
  std::error_code error;
  const fs::file_status about = fs::status(file, error);
  if (!fs::exists(about)) return cannot_read(about.type() == fs::file_type::not_found ? ENOENT : error.value(), file);
  if (!fs::is_regular_file(about)) return cannot_read(fs::is_directory(about) ? EISDIR : EINVAL, file);
  if (const std::uintmax_t length = fs::file_size(file, error); !error && length > most_bytes) return cannot_read(EFBIG, file);
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) return cannot_read(errno != 0 ? errno : EIO, file);
  std::string piece(kPieceBytes, '\0');
  for (std::uintmax_t length = 0; in.read(piece.data(), static_cast<std::streamsize>(piece.size())) || in.gcount() > 0;) {
    const auto got = static_cast<std::size_t>(in.gcount());
    length += got;
    if (length > most_bytes) return cannot_read(EFBIG, file);  // it grew meanwhile, or the system gives it no length
    if (auto taken = visit(std::string_view(piece).substr(0, got)); !taken) return taken;
  }
  if (in.bad()) return cannot_read(errno != 0 ? errno : EIO, file);
  return {};
}

Stored<std::vector<std::byte>> bytes_of(const fs::path& file, std::uintmax_t most_bytes) {
  std::vector<std::byte> out;
  const auto read = for_pieces(file, most_bytes, [&out](std::string_view piece) -> Stored<void> {
    const auto bytes = std::as_bytes(std::span(piece));
    out.insert(out.end(), bytes.begin(), bytes.end());
    return {};
  });
  if (!read) return std::unexpected(read.error());
  return out;
}

Stored<std::string> text_of_file(const fs::path& file, std::uintmax_t most_bytes) {
  std::string out;
  const auto read = for_pieces(file, most_bytes, [&out](std::string_view piece) -> Stored<void> {
    out += piece;
    return {};
  });
  if (!read) return std::unexpected(read.error());
  return out;
}

ImportFailure import_failure_of(const StorageFailure& failure) {
  switch (failure.code) {
    case StorageError::not_found: return {ImportError::missing_file, failure.where, {}};
    case StorageError::file_too_large: return {ImportError::too_large, failure.where, {}};
    default: return {ImportError::io, failure.where, failure.detail};
  }
}

}  // namespace cusp::ui
