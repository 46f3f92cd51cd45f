#include "device/falcon/firmware_image.h"

#include <sodium.h>

#include <fstream>

namespace cusp::device::falcon {

namespace {

constexpr std::uint32_t kImageKey = 0x08AA;
constexpr std::size_t kReservedWords = 8;
constexpr std::uint32_t kMemoryWords = 0x400000;  // 22 address lines: 0x000000 to 0x3FFFFF

/// Reads 16-bit words, little-endian. Pre: left() before each read.
class WordReader {
 public:
  explicit WordReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool left(std::size_t words) const noexcept { return (bytes_.size() - at_) / 2 >= words; }
  std::size_t index() const noexcept { return at_ / 2; }
  std::uint32_t word() noexcept {
    const std::uint32_t value = bytes_[at_] | static_cast<std::uint32_t>(bytes_[at_ + 1]) << 8;
    at_ += 2;
    return value;
  }
  std::uint32_t high_first() noexcept {
    const std::uint32_t high = word();
    return high << 16 | word();
  }
  void skip(std::size_t words) noexcept { at_ += 2 * words; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

std::string sha256_of(std::span<const std::uint8_t> bytes) {
  std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
  crypto_hash_sha256(hash.data(), bytes.data(), bytes.size());
  std::string out;
  for (const unsigned char byte : hash) {
    constexpr char kDigits[] = "0123456789abcdef";
    out += kDigits[byte >> 4];
    out += kDigits[byte & 15];
  }
  return out;
}

std::unexpected<ImageFailure> refuse(ImageError error, std::size_t word) { return fail(error, std::to_string(word)); }

}  // namespace

std::string_view key_of(ImageError error) noexcept {
  switch (error) {
    case ImageError::unreadable:
      return "unreadable";
    case ImageError::too_small:
      return "too_small";
    case ImageError::too_large:
      return "too_large";
    case ImageError::odd_size:
      return "odd_size";
    case ImageError::not_a_boot_image:
      return "not_a_boot_image";
    case ImageError::truncated:
      return "truncated";
    case ImageError::bad_address:
      return "bad_address";
    case ImageError::trailing_bytes:
      return "trailing_bytes";
  }
  return "unreadable";
}

Result<FirmwareImage, ImageFailure> FirmwareImage::from_bytes(std::vector<std::uint8_t> bytes) {
  if (bytes.size() < kMinBytes) return refuse(ImageError::too_small, 0);
  if (bytes.size() > kMaxBytes) return refuse(ImageError::too_large, 0);
  if (bytes.size() % 2 != 0) return refuse(ImageError::odd_size, 0);
  FirmwareImage image;
  WordReader words(bytes);
  if (words.word() != kImageKey) return refuse(ImageError::not_a_boot_image, 0);
  for (std::size_t i = 0; i < kReservedWords; ++i) {
    if (words.word() != 0) return refuse(ImageError::not_a_boot_image, words.index() - 1);
  }
  image.entry_ = words.high_first();
  if (image.entry_ >= kMemoryWords) return refuse(ImageError::bad_address, words.index() - 2);
  for (;;) {
    if (!words.left(1)) return refuse(ImageError::truncated, words.index());
    const std::uint32_t size = words.word();
    if (size == 0) break;
    if (!words.left(2 + size)) return refuse(ImageError::truncated, words.index());
    const std::uint32_t to = words.high_first();
    if (to >= kMemoryWords || kMemoryWords - to < size) return refuse(ImageError::bad_address, words.index() - 2);
    words.skip(size);
    ++image.blocks_;
  }
  if (words.left(1)) return refuse(ImageError::trailing_bytes, words.index());
  if (image.blocks_ == 0) return refuse(ImageError::truncated, words.index());
  image.sha256_ = sha256_of(bytes);
  image.bytes_ = std::move(bytes);
  return image;
}

Result<FirmwareImage, ImageFailure> FirmwareImage::from_file(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return fail(ImageError::unreadable, file.string());
  const auto size = std::filesystem::file_size(file, error);
  if (error) return fail(ImageError::unreadable, file.string());
  if (size > kMaxBytes) return fail(ImageError::too_large, file.string());
  std::ifstream in(file, std::ios::binary);
  std::vector<std::uint8_t> bytes(kMaxBytes + 1);  // one byte too many is enough to be refused
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!in.is_open() || in.bad()) return fail(ImageError::unreadable, file.string());
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  auto image = from_bytes(std::move(bytes));
  if (!image) return fail(image.error().code, file.string(), image.error().where);
  return image;
}

std::string_view FirmwareImage::known_as() const noexcept {
  struct Known {
    std::string_view hash, name;
  };
  // The first 16 digits of the SHA-256 of images that are known to circulate.
  constexpr std::array<Known, 4> kKnown = {{{"1119e39c39fab1f3", "nvent"},
                                            {"b2700d5cd5ca217e", "test"},
                                            {"ae838730af34b582", "novint-t0"},
                                            {"e0ae3598670fa1c8", "novint-t2"}}};
  for (const Known& known : kKnown) {
    if (std::string_view(sha256_).starts_with(known.hash)) return known.name;
  }
  return {};
}

}  // namespace cusp::device::falcon
