/// The Falcon's firmware file, checked before upload. Cusp ships none: the user names a file of the maker's software, under
/// that software's licence. Source: facts 1.6 and 1.7.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace cusp::device::falcon {

enum class ImageError : std::uint8_t {
  unreadable,        // no such file, no permission
  too_small,         // under 4 KiB
  too_large,         // over 36 KiB
  odd_size,          // not whole 16-bit words
  not_a_boot_image,  // another key, or the reserved words are not zero
  truncated,         // a block, or the mark that ends the image, is missing
  bad_address,       // a block lies outside the processor's memory
  trailing_bytes,    // there is more after the end mark
};
/// `where` names the file or the word (counted from 0) that was refused.
using ImageFailure = Failure<ImageError>;
std::string_view key_of(ImageError error) noexcept;  // "truncated": for logs and --json

/// A checked image. Immutable.
class FirmwareImage {
 public:
  static constexpr std::size_t kMinBytes = 4 * 1024, kMaxBytes = 36 * 1024;

  static Result<FirmwareImage, ImageFailure> from_bytes(std::vector<std::uint8_t> bytes);
  static Result<FirmwareImage, ImageFailure> from_file(const std::filesystem::path& file);

  std::span<const std::uint8_t> bytes() const noexcept { return bytes_; }
  int blocks() const noexcept { return blocks_; }
  std::uint32_t entry() const noexcept { return entry_; }
  /// SHA-256 as 64 lower-case digits: identifies the file in settings and on screen.
  const std::string& sha256() const noexcept { return sha256_; }
  /// "nvent", "test", "novint-t0", "novint-t2" for an image that is known to circulate; else empty.
  std::string_view known_as() const noexcept;

 private:
  FirmwareImage() = default;
  std::vector<std::uint8_t> bytes_;
  std::string sha256_;
  std::uint32_t entry_ = 0;
  int blocks_ = 0;
};

}  // namespace cusp::device::falcon
