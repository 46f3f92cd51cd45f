#include "engine/volume/volume.h"

#include <algorithm>

#include "engine/volume/hash.h"

namespace cusp {

Volume::Volume(std::shared_ptr<const Specimen> specimen) : specimen_(std::move(specimen)) {
  const IVec3 n = specimen_->brick_count();
  const auto bricks = static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z);
  slot_.assign(bricks, -1);
  revision_.assign(bricks, 0);
  // A burr cuts tissue, and its band reaches one brick further.
  cuttable_.assign(bricks, 0);
  for (int b = 0; b < static_cast<int>(bricks); ++b) {
    if (specimen_->uniform(b) && specimen_->s_in(b, 0) == 0) continue;
    const IVec3 at = specimen_->brick_at(b);
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          const int i = specimen_->brick_index(at + IVec3(x, y, z));
          if (i >= 0) cuttable_[static_cast<std::size_t>(i)] = 1;
        }
  }
  capacity_ = static_cast<std::size_t>(std::count(cuttable_.begin(), cuttable_.end(), 1));
  cut_.assign(capacity_ * kBrickVoxels, kSolid);
  cut_order_.reserve(capacity_);
}

std::uint16_t* Volume::cut_for_writing(int brick) noexcept {
  std::int32_t& slot = slot_[static_cast<std::size_t>(brick)];
  if (slot < 0) {
    if (cuttable_[static_cast<std::size_t>(brick)] == 0 || cut_order_.size() == capacity_) return nullptr;
    slot = static_cast<std::int32_t>(cut_order_.size());
    cut_order_.push_back(brick);
    if (specimen_->reading() == Reading::filled) {
      for (int o = 0; o < kBrickVoxels; ++o)
        cut_[static_cast<std::size_t>(slot) * kBrickVoxels + static_cast<std::size_t>(o)] = specimen_->s_in(brick, o);
    }
  }
  return &cut_[static_cast<std::size_t>(slot) * kBrickVoxels];
}

namespace {
std::vector<std::int32_t> sorted(std::span<const std::int32_t> order) {
  std::vector<std::int32_t> out(order.begin(), order.end());
  std::sort(out.begin(), out.end());
  return out;
}
}  // namespace

std::uint64_t Volume::hash() const noexcept {
  // A sum over bricks, so that the order of cutting does not matter and nothing needs sorting.
  std::uint64_t sum = 0;
  for (const std::int32_t brick : cut_order_) {
    Hash64 h;
    h.add(static_cast<std::uint64_t>(brick));
    h.add_u16({cut_of(brick), static_cast<std::size_t>(kBrickVoxels)});
    sum += h.value();
  }
  Hash64 h;
  h.add(specimen_->hash());
  h.add(sum);
  return h.value();
}

std::size_t Volume::bytes() const noexcept {
  return slot_.size() * sizeof(std::int32_t) + revision_.size() * sizeof(std::uint32_t) +
         cut_.size() * sizeof(std::uint16_t) + capacity_ * sizeof(std::int32_t) + cuttable_.size();
}

VoxelVolume Volume::dense() const {
  VoxelVolume out = specimen_->dense();
  for (const std::int32_t brick : cut_order_) {
    const IVec3 corner = specimen_->brick_at(brick) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
      if (!out.grid.contains(v)) continue;
      const std::size_t i = out.grid.index(v);
      out.s[i] = std::min(out.s[i], cut_in(brick, o));
      if (out.s[i] == 0) out.tissue[i] = Tissue::empty;
    }
  }
  return out;
}

std::vector<std::byte> Volume::save_cuts() const {
  std::vector<std::byte> out;
  out.reserve(4 + cut_order_.size() * (4 + 2 * kBrickVoxels));
  const auto put = [&out](std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::byte>(value >> (8 * i)));
  };
  put(static_cast<std::uint32_t>(cut_order_.size()), 4);
  for (const std::int32_t brick : sorted(cut_order_)) {
    put(static_cast<std::uint32_t>(brick), 4);
    const std::uint16_t* values = cut_of(brick);
    for (int o = 0; o < kBrickVoxels; ++o) put(values[o], 2);
  }
  return out;
}

bool Volume::load_cuts(std::span<const std::byte> bytes) {
  const auto get = [&bytes](std::size_t at, int n) {
    std::uint32_t value = 0;
    for (int i = 0; i < n; ++i) value |= static_cast<std::uint32_t>(bytes[at + static_cast<std::size_t>(i)]) << (8 * i);
    return value;
  };
  if (bytes.size() < 4) return false;
  const std::size_t count = get(0, 4);
  constexpr std::size_t kEach = 4 + 2 * kBrickVoxels;
  if (count > capacity_ || bytes.size() != 4 + count * kEach) return false;
  std::int64_t last = -1;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t brick = get(4 + i * kEach, 4);
    if (brick <= last || brick >= static_cast<std::int64_t>(slot_.size())) return false;
    last = brick;
  }
  std::fill(slot_.begin(), slot_.end(), -1);
  std::fill(cut_.begin(), cut_.end(), kSolid);
  cut_order_.clear();
  for (auto& r : revision_) ++r;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint16_t* values = cut_for_writing(static_cast<int>(get(4 + i * kEach, 4)));
    for (std::size_t o = 0; o < kBrickVoxels; ++o)
      values[o] = static_cast<std::uint16_t>(get(8 + i * kEach + 2 * o, 2));
  }
  return true;
}

}  // namespace cusp
