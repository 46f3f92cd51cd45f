#include "storage/sqlite/log_replay.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace cusp::storage {
namespace {

constexpr std::size_t kLogHeader = 32, kFrameHeader = 24;
constexpr std::uint32_t kMagic = 0x377F0682, kVersion = 3'007'000;  // the magic's last bit: checksums are big-endian

std::uint32_t big_endian(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
  return value;
}

/// Two running checksums, from the log's header through every frame.
struct Sums {
  bool big = false;
  std::uint32_t a = 0, b = 0;

  void add(std::span<const std::byte> bytes) {
    const auto word = [&](std::size_t at) {
      const std::uint32_t value = big_endian(bytes, at);
      return big ? value : std::byteswap(value);
    };
    for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
      a += word(at) + b;
      b += word(at + 4) + a;
    }
  }
  bool equal(std::span<const std::byte> bytes, std::size_t at) const {
    return a == big_endian(bytes, at) && b == big_endian(bytes, at + 4);
  }
};

}  // namespace

CommittedLog read_log(std::span<const std::byte> log) {
  CommittedLog out;
  if (log.size() < kLogHeader) return out;
  const std::uint32_t magic = big_endian(log, 0), page_size = big_endian(log, 8);
  if ((magic & ~1u) != kMagic || big_endian(log, 4) != kVersion) return out;
  if (!std::has_single_bit(page_size) || page_size < 512 || page_size > 65536) return out;
  Sums sums{.big = (magic & 1) != 0};
  sums.add(log.first(24));
  if (!sums.equal(log, 24)) return out;

  std::map<std::uint32_t, std::size_t> pending;  // since the last commit
  for (std::size_t at = kLogHeader; at + kFrameHeader + page_size <= log.size(); at += kFrameHeader + page_size) {
    const auto frame = log.subspan(at, kFrameHeader + page_size);
    const bool same_log = std::ranges::equal(frame.subspan(8, 8), log.subspan(16, 8));  // the salts
    const std::uint32_t page = big_endian(frame, 0), pages = big_endian(frame, 4);
    sums.add(frame.first(8));
    sums.add(frame.subspan(kFrameHeader));
    if (!same_log || page == 0 || !sums.equal(frame, 16)) break;
    pending[page] = at + kFrameHeader;
    if (pages == 0) continue;
    for (const auto& [number, place] : std::exchange(pending, {})) out.places[number] = place;
    out.page_size = page_size;
    out.pages = pages;
  }
  return out;
}

void lay_over(const CommittedLog& log, std::span<const std::byte> bytes, std::span<std::byte> image) {
  for (const auto& [page, place] : log.places) {
    if (page > log.pages) continue;  // the file has become smaller since
    const std::size_t to = std::size_t{page - 1} * log.page_size;
    std::ranges::copy(bytes.subspan(place, log.page_size), image.subspan(to).begin());
  }
}

}  // namespace cusp::storage
