#include "engine/volume/occupancy.h"

#include <algorithm>
#include <cassert>

namespace cusp::engine {

namespace {

constexpr std::uint64_t kColumn = 0x0101010101010101ull;  // x = 0 of every row
constexpr std::uint64_t kAll = ~std::uint64_t{0};

/// Occupied voxels of a brick, slice by slice.
void read_slices(const Volume& volume, int brick, std::uint64_t* slices) {
  const Specimen& specimen = volume.specimen();
  const std::uint16_t* base = specimen.s_of(brick);
  const std::uint16_t* cut = volume.cut_of(brick);
  const std::uint16_t least = specimen.reading() == Reading::filled ? std::uint16_t{1} : kHalf;
  const std::uint16_t uniform = specimen.s_in(brick, 0);
  for (int z = 0; z < 8; ++z) {
    std::uint64_t bits = 0;
    for (int i = 0; i < 64; ++i) {
      const int o = i | z << 6;
      const std::uint16_t s = std::min(base ? base[o] : uniform, cut ? cut[o] : kSolid);
      bits |= static_cast<std::uint64_t>(s >= least) << i;
    }
    slices[z] = bits;
  }
}

}  // namespace

Occupancy::Occupancy(const Volume& volume) : size_(volume.grid().size), bricks_(volume.specimen().brick_count()) {
  const Specimen& specimen = volume.specimen();
  const int bricks = bricks_.x * bricks_.y * bricks_.z;
  place_.resize(static_cast<std::size_t>(bricks), kEmpty);
  occupied_.assign(16, 0);
  std::fill_n(occupied_.begin() + 8, 8, kAll);
  std::size_t whole = 0;
  for (int b = 0; b < bricks; ++b) {
    std::int32_t& place = place_[static_cast<std::size_t>(b)];
    if (specimen.uniform(b) && !volume.has_cut(b)) {
      place = specimen.s_in(b, 0) > 0 ? kWhole : kEmpty;
    } else {
      std::uint64_t slices[8];
      read_slices(volume, b, slices);
      if (std::all_of(slices, slices + 8, [](std::uint64_t s) { return s == 0; })) {
        place = kEmpty;
      } else if (std::all_of(slices, slices + 8, [](std::uint64_t s) { return s == kAll; })) {
        place = kWhole;
      } else {
        place = used_++;
        occupied_.insert(occupied_.end(), slices, slices + 8);
      }
    }
    whole += place == kWhole;
  }
  const std::size_t room = static_cast<std::size_t>(used_) + std::min(whole, volume.cut_capacity());
  occupied_.reserve(room * 8);
  occupied_.resize(room * 8, 0);
  boundary_.assign(room * 8, 0);
  for (int b = 0; b < bricks; ++b)
    if (place_[static_cast<std::size_t>(b)] > kWhole)
      classify(specimen.brick_at(b), place_[static_cast<std::size_t>(b)]);
}

std::uint64_t Occupancy::inner_slice(IVec3 brick, int z) const noexcept {
  const int bz = brick.z + (z >> 3);
  if (bz < 0 || bz >= bricks_.z) return 0;
  const auto slice = [&](int bx, int by) -> std::uint64_t {
    if (bx < 0 || by < 0 || bx >= bricks_.x || by >= bricks_.y) return 0;
    const IVec3 v = IVec3(bx, by, bz) * kBrickEdge;
    return occupied_[static_cast<std::size_t>(place_[this->brick(v)]) * 8 + static_cast<std::size_t>(z & 7)];
  };
  std::uint64_t along_x[3];
  for (int i = 0; i < 3; ++i) {
    const int by = brick.y + i - 1;
    const std::uint64_t here = slice(brick.x, by);
    const std::uint64_t before = (here & ~(kColumn << 7)) << 1 | (slice(brick.x - 1, by) >> 7 & kColumn);
    const std::uint64_t after = (here >> 1 & ~(kColumn << 7)) | (slice(brick.x + 1, by) & kColumn) << 7;
    along_x[i] = here & before & after;
  }
  return along_x[1] & (along_x[1] << 8 | along_x[0] >> 56) & (along_x[1] >> 8 | along_x[2] << 56);
}

void Occupancy::classify(IVec3 brick, std::int32_t place) noexcept {
  std::uint64_t inner[10];
  for (int z = -1; z <= 8; ++z) inner[z + 1] = inner_slice(brick, z);
  for (std::size_t z = 0; z < 8; ++z) {
    const std::size_t at = static_cast<std::size_t>(place) * 8 + z;
    boundary_[at] = occupied_[at] & ~(inner[z] & inner[z + 1] & inner[z + 2]);
  }
}

VoxelClass Occupancy::of(IVec3 v) const noexcept {
  if (!occupied(v)) return VoxelClass::external;
  const std::int32_t place = place_[brick(v)];
  if (place != kWhole) return boundary_[word(place, v)] & mask(v) ? VoxelClass::boundary : VoxelClass::internal;
  for (int i = 0; i < 27; ++i)
    if (!occupied(v + IVec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1))) return VoxelClass::boundary;
  return VoxelClass::internal;
}

void Occupancy::vanish(IVec3 v) noexcept {
  if (!occupied(v)) return;
  std::int32_t& place = place_[brick(v)];
  if (place == kWhole) {
    assert(static_cast<std::size_t>(used_) * 8 < occupied_.size());
    place = used_++;
    std::fill_n(&occupied_[static_cast<std::size_t>(place) * 8], 8, kAll);
    classify({v.x >> 3, v.y >> 3, v.z >> 3}, place);
  }
  occupied_[word(place, v)] &= ~mask(v);
  boundary_[word(place, v)] &= ~mask(v);
  const IVec3 l(v.x & 7, v.y & 7, v.z & 7);
  if (l.x > 0 && l.x < 7 && l.y > 0 && l.y < 7 && l.z > 0 && l.z < 7) {
    // All neighbours in this brick: three by three bits of three slices.
    const std::uint64_t around = std::uint64_t{0x070707} << (l.x - 1 + (l.y - 1) * 8);
    for (int z = -1; z <= 1; ++z) {
      const std::size_t at = static_cast<std::size_t>(place) * 8 + static_cast<std::size_t>(l.z + z);
      boundary_[at] |= around & occupied_[at];
    }
    return;
  }
  for (int i = 0; i < 27; ++i) {
    const IVec3 n = v + IVec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (!occupied(n)) continue;
    const std::int32_t of_n = place_[brick(n)];
    if (of_n != kWhole) boundary_[word(of_n, n)] |= mask(n);
  }
}

}  // namespace cusp::engine
