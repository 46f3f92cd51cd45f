#include "ui/session/specimen_blob.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace cusp::ui {

namespace {

constexpr std::uint64_t kMagic = 0x314E4D4350535543u;  // "CUSPCMN1" as bytes
constexpr std::int32_t kMostVoxelsAnEdge = 4096;

class Writer {
 public:
  void u64(std::uint64_t value) {
    for (int i = 0; i < 8; ++i) out.push_back(static_cast<std::byte>(value >> (8 * i)));
  }
  void real(double value) { u64(std::bit_cast<std::uint64_t>(value)); }
  std::vector<std::byte> out;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : left_(bytes) {}
  std::uint64_t u64() {
    const auto b = take(8);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < b.size(); ++i) value |= static_cast<std::uint64_t>(b[i]) << (8 * i);
    return value;
  }
  double real() { return std::bit_cast<double>(u64()); }
  std::span<const std::byte> take(std::size_t n) {
    if (n > left_.size()) {
      ok_ = false;
      return {};
    }
    const auto part = left_.first(n);
    left_ = left_.subspan(n);
    return part;
  }
  bool ok() const { return ok_; }
  bool at_end() const { return ok_ && left_.empty(); }
  std::size_t left() const { return left_.size(); }

 private:
  std::span<const std::byte> left_;
  bool ok_ = true;
};

}  // namespace

std::vector<std::byte> specimen_bytes(const VoxelVolume& volume) {
  Writer w;
  w.out.reserve(128 + volume.s.size() * 3);
  w.u64(kMagic);
  for (int i = 0; i < 3; ++i) w.u64(static_cast<std::uint64_t>(volume.grid.size[i]));
  w.real(volume.grid.voxel_mm);
  for (int i = 0; i < 3; ++i) w.real(volume.grid.origin_mm[i]);
  w.u64(volume.names.size());
  for (const auto& [code, name] : volume.names) {
    w.u64(code);
    w.u64(name.size());
    for (const char c : name) w.out.push_back(static_cast<std::byte>(c));
  }
  const std::size_t head = w.out.size(), voxels = volume.s.size();
  w.out.resize(head + 3 * voxels);
  static_assert(sizeof(Tissue) == 1);
  std::memcpy(w.out.data() + head, volume.tissue.data(), voxels);
  // Low bytes, then high bytes: runs of equal bytes compress.
  std::byte *low = w.out.data() + head + voxels, *high = low + voxels;
  for (std::size_t i = 0; i < voxels; ++i) {
    low[i] = static_cast<std::byte>(volume.s[i] & 0xFF);
    high[i] = static_cast<std::byte>(volume.s[i] >> 8);
  }
  return std::move(w.out);
}

std::optional<VoxelVolume> specimen_from_bytes(std::span<const std::byte> bytes) {
  Reader r(bytes);
  if (r.u64() != kMagic) return std::nullopt;
  Grid grid;
  for (int i = 0; i < 3; ++i) {
    const std::uint64_t n = r.u64();
    if (n == 0 || n > kMostVoxelsAnEdge) return std::nullopt;
    grid.size[i] = static_cast<std::int32_t>(n);
  }
  grid.voxel_mm = r.real();
  for (int i = 0; i < 3; ++i) grid.origin_mm[i] = r.real();
  if (!(grid.voxel_mm > 0.0)) return std::nullopt;
  std::map<std::uint8_t, std::string> names;
  const std::uint64_t count = r.u64();
  if (count > kTissueCodes) return std::nullopt;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t code = r.u64();
    const std::uint64_t length = r.u64();
    if (code >= kTissueCodes || length > 1000) return std::nullopt;
    const auto text = r.take(static_cast<std::size_t>(length));
    names[static_cast<std::uint8_t>(code)] = std::string(reinterpret_cast<const char*>(text.data()), text.size());
  }
  if (!r.ok() || r.left() != grid.voxels() * 3) return std::nullopt;
  VoxelVolume out(grid);
  out.names = std::move(names);
  const auto tissue = r.take(grid.voxels());
  const auto low = r.take(grid.voxels());
  const auto high = r.take(grid.voxels());
  for (std::size_t i = 0; i < grid.voxels(); ++i) {
    const auto code = static_cast<std::uint8_t>(tissue[i]);
    if (code >= kTissueCodes) return std::nullopt;
    out.tissue[i] = static_cast<Tissue>(code);
    out.s[i] = static_cast<std::uint16_t>(static_cast<unsigned>(low[i]) | static_cast<unsigned>(high[i]) << 8);
  }
  return out;
}

}  // namespace cusp::ui
