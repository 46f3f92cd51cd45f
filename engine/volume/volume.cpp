#include "engine/volume/volume.h"

#include <algorithm>

#include "engine/volume/hash.h"

namespace cusp::engine {

Volume::Volume(std::shared_ptr<const Specimen> specimen) : specimen_(std::move(specimen)) {
  const IVec3 n = specimen_->brick_count();
  const auto bricks = static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z);
  // A bur cuts tissue, and its band reaches one brick further.
  slot_.assign(bricks, kOutOfReach);
  for (int b = 0; b < static_cast<int>(bricks); ++b) {
    if (specimen_->uniform(b) && specimen_->s_in(b, 0) == 0) continue;
    const IVec3 at = specimen_->brick_at(b);
    const IVec3 low = glm::max(at - 1, IVec3(0));
    const IVec3 high = glm::min(at + 1, n - 1);
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y) {
        const auto row = static_cast<std::size_t>(specimen_->brick_index({0, y, z}));
        for (int x = low.x; x <= high.x; ++x) slot_[row + static_cast<std::size_t>(x)] = kUncut;
      }
  }
  capacity_ = std::min(kMostCutBricks, static_cast<std::size_t>(std::count(slot_.begin(), slot_.end(), kUncut)));
  cut_.assign(capacity_ * kBrickVoxels, kSolid);
  revision_.assign(capacity_, 0);
  cut_order_.reserve(capacity_);
}

void Volume::keep_sweeps() { sweep_.assign(capacity_ * kBrickVoxels, kNoSweep); }

std::uint16_t* Volume::cut_for_writing(int brick) noexcept {
  std::int16_t& slot = slot_[static_cast<std::size_t>(brick)];
  if (slot < 0) {
    if (slot == kOutOfReach || cut_order_.size() == capacity_) return nullptr;
    slot = static_cast<std::int16_t>(cut_order_.size());
    revision_[cut_order_.size()] = loaded_;
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
  // The sum over bricks does not depend on the order of cutting, and needs no sorting.
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
  return slot_.size() * sizeof(std::int16_t) + cut_.size() * sizeof(std::uint16_t) + sweep_.size() * sizeof(std::int32_t) +
         capacity_ * (sizeof(std::uint32_t) + sizeof(std::int32_t));
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
    if (brick <= last || brick >= static_cast<std::int64_t>(slot_.size()) || !cuttable(static_cast<int>(brick)))
      return false;
    last = brick;
  }
  for (const std::int32_t brick : cut_order_) {
    loaded_ = std::max(loaded_, revision(brick));
    slot_[static_cast<std::size_t>(brick)] = kUncut;
  }
  ++loaded_;
  std::fill(cut_.begin(), cut_.end(), kSolid);
  std::fill(sweep_.begin(), sweep_.end(), kNoSweep);
  cut_order_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    std::uint16_t* values = cut_for_writing(static_cast<int>(get(4 + i * kEach, 4)));
    for (std::size_t o = 0; o < kBrickVoxels; ++o)
      values[o] = static_cast<std::uint16_t>(get(8 + i * kEach + 2 * o, 2));
  }
  return true;
}

std::vector<std::byte> Volume::save_sweeps() const {
  std::vector<std::byte> out;
  if (!keeps_sweeps()) return out;
  out.reserve(cut_order_.size() * kBrickVoxels * sizeof(std::int32_t));
  for (const std::int32_t brick : sorted(cut_order_)) {
    const std::int32_t* ids = sweeps_of(brick);
    for (int o = 0; o < kBrickVoxels; ++o)
      for (int i = 0; i < 4; ++i) out.push_back(static_cast<std::byte>(static_cast<std::uint32_t>(ids[o]) >> (8 * i)));
  }
  return out;
}

bool Volume::load_sweeps(std::span<const std::byte> bytes, std::int32_t count) {
  const std::size_t wanted = keeps_sweeps() ? cut_order_.size() * kBrickVoxels : 0;
  if (bytes.size() != 4 * wanted) return false;
  std::vector<std::int32_t> ids(wanted);
  for (std::size_t k = 0; k < wanted; ++k) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(bytes[4 * k + i]) << (8 * i);
    ids[k] = static_cast<std::int32_t>(value);
    if (ids[k] < kNoSweep || ids[k] >= count) return false;
  }
  const std::int32_t* from = ids.data();
  for (const std::int32_t brick : sorted(cut_order_)) {
    if (wanted == 0) break;
    std::copy(from, from + kBrickVoxels, sweeps_for_writing(brick));
    from += kBrickVoxels;
  }
  return true;
}

std::uint64_t Volume::sweeps_hash() const noexcept {
  std::uint64_t sum = 0;
  if (!keeps_sweeps()) return sum;
  for (const std::int32_t brick : cut_order_) {
    Hash64 h;
    h.add(static_cast<std::uint64_t>(brick));
    const std::int32_t* ids = sweeps_of(brick);
    for (int o = 0; o < kBrickVoxels; o += 2)
      h.add(static_cast<std::uint64_t>(static_cast<std::uint32_t>(ids[o])) << 32 | static_cast<std::uint32_t>(ids[o + 1]));
    sum += h.value();
  }
  return sum;
}

}  // namespace cusp::engine
