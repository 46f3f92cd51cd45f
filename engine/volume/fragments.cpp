#include "engine/volume/fragments.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace cusp::engine {

namespace {

constexpr std::uint64_t kLowX = 0x0101010101010101ull, kHighX = kLowX << 7;

std::uint64_t grown_x(std::uint64_t s) noexcept { return s | (s & ~kLowX) >> 1 | (s & ~kHighX) << 1; }
std::uint64_t grown_y(std::uint64_t s) noexcept { return s | s << 8 | s >> 8; }

/// C about a removed voxel, by the distance along each axis (0 to 3 voxels): the outside of a ball. A cell that the
/// ball's surface crosses reads no voxel further away.
struct Stamp {
  static constexpr int kReach = 3;
  static constexpr int kSide = kReach + 1;
  std::array<std::uint16_t, kSide * kSide * kSide> value;
  explicit Stamp(double radius) noexcept {
    for (int z = 0; z < kSide; ++z)
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
          value[place(x, y, z)] = solid_from_distance(radius - std::sqrt(static_cast<double>(x * x + y * y + z * z)));
  }
  static std::size_t place(int x, int y, int z) noexcept { return static_cast<std::size_t>(x + kSide * (y + kSide * z)); }
  std::uint16_t at(int x, int y, int z) const noexcept { return value[place(x, y, z)]; }
};
/// Beside tissue that stays: to the next voxel's centre.
const Stamp kBeside(1.0);
/// Elsewhere: the most that a fragment's surface is from its outermost centres, at a corner.
const Stamp kClear(1.75);

BrickVoxelSet occupied_in(const Specimen& specimen, int brick, const std::uint16_t* cut) noexcept {
  BrickVoxelSet out;
  const std::uint16_t least = specimen.reading() == Reading::filled ? 1 : kHalf;
  const std::uint16_t* base = specimen.s_of(brick);
  if (base == nullptr) {
    if (specimen.s_in(brick, 0) < least) return out;
    if (cut == nullptr) {
      out.slice.fill(~std::uint64_t{0});
      return out;
    }
  }
  std::array<std::uint8_t, kBrickVoxels> occupied{};
  const std::uint16_t* first = base != nullptr ? base : cut;
  for (std::size_t i = 0; i < kBrickVoxels; ++i) occupied[i] = static_cast<std::uint8_t>(first[i] >= least);
  if (base != nullptr && cut != nullptr)
    for (std::size_t i = 0; i < kBrickVoxels; ++i)
      occupied[i] = static_cast<std::uint8_t>(occupied[i] & static_cast<std::uint8_t>(cut[i] >= least));
  for (std::size_t z = 0; z < 8; ++z)
    for (std::size_t y = 0; y < 8; ++y) {
      std::uint64_t row;
      std::memcpy(&row, &occupied[z * 64 + y * 8], 8);
      // Eight bytes of 0 or 1 to eight bits: byte i to bit i.
      const std::uint64_t bits = std::endian::native == std::endian::little ? row * 0x0102040810204080ull >> 56
                                                                           : row * 0x8040201008040201ull >> 56;
      out.slice[z] |= bits << (8 * y);
    }
  return out;
}

/// Whether a voxel about one brick has occupied voxels within one voxel of it: tissue that stays.
class NearTissue {
 public:
  NearTissue(const Volume& volume, IVec3 brick) noexcept : volume_(volume), low_((brick - 1) * kBrickEdge) {
    const Specimen& specimen = volume.specimen();
    std::array<std::uint32_t, kSide * kSide> rows{};  // bits along x
    for (int i = 0; i < 27; ++i) {
      const IVec3 step(i % 3, i / 3 % 3, i / 9);
      const int b = specimen.brick_index(brick + step - 1);
      if (b < 0) continue;
      const BrickVoxelSet set = occupied_in(specimen, b, volume.cut_of(b));
      for (int z = 0; z < kBrickEdge; ++z)
        for (int y = 0; y < kBrickEdge; ++y)
          rows[place(step.y * kBrickEdge + y, step.z * kBrickEdge + z)] |=
              static_cast<std::uint32_t>(set.slice[static_cast<std::size_t>(z)] >> (8 * y) & 0xff) << (step.x * kBrickEdge);
    }
    for (std::uint32_t& row : rows) row |= row << 1 | row >> 1;
    for (int z = 1; z + 1 < kSide; ++z)
      for (int y = 1; y + 1 < kSide; ++y)
        for (int k = 0; k < 9; ++k) beside_[place(y, z)] |= rows[place(y + k % 3 - 1, z + k / 3 - 1)];
  }
  bool operator()(IVec3 v) const noexcept {
    const IVec3 at = v - low_;
    if (glm::all(glm::greaterThan(at, IVec3(0))) && glm::all(glm::lessThan(at, IVec3(kSide - 1))))
      return beside_[place(at.y, at.z)] >> at.x & 1;
    for (int i = 0; i < 27; ++i)  // a crumb that lies across bricks
      if (volume_.occupied(v + IVec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1))) return true;
    return false;
  }

 private:
  static constexpr int kSide = 3 * kBrickEdge;
  static std::size_t place(int y, int z) noexcept { return static_cast<std::size_t>(y + kSide * z); }
  const Volume& volume_;
  IVec3 low_;
  std::array<std::uint32_t, kSide * kSide> beside_{};
};

/// Lowers C of a voxel, whose sweep is no longer what has cut it; unless it is as low already.
void lower(Volume& volume, int brick, std::uint16_t* values, IVec3 at, std::uint16_t s, ChangedBox& out) noexcept {
  const int offset = brick_offset(at.x & 7, at.y & 7, at.z & 7);
  if (s >= values[offset]) return;
  values[offset] = s;
  volume.forget_sweep(brick, offset);
  out.low = out.any ? glm::min(out.low, at) : at;
  out.high = out.any ? glm::max(out.high, at) : at;
  out.any = true;
}

/// C = min(C, stamp) about a row of `length` voxels that begins at v. Pre: all removed voxels are empty.
void stamp_row(Volume& volume, const NearTissue& beside_tissue, IVec3 v, int length, ChangedBox& out) noexcept {
  const Specimen& specimen = volume.specimen();
  const IVec3 size = volume.grid().size;
  const int x0 = std::max(v.x - Stamp::kReach, 0), x1 = std::min(v.x + length - 1 + Stamp::kReach, size.x - 1);
  for (int dz = -Stamp::kReach; dz <= Stamp::kReach; ++dz)
    for (int dy = -Stamp::kReach; dy <= Stamp::kReach; ++dy) {
      const int y = v.y + dy, z = v.z + dz;
      if (y < 0 || z < 0 || y >= size.y || z >= size.z || kClear.at(0, std::abs(dy), std::abs(dz)) == kSolid) continue;
      std::uint16_t* values = nullptr;
      int held = -1;
      bool none = false;
      for (int x = x0; x <= x1; ++x) {
        const int dx = x < v.x ? v.x - x : x > v.x + length - 1 ? x - (v.x + length - 1) : 0;
        std::uint16_t s = kClear.at(dx, std::abs(dy), std::abs(dz));
        if (s == kSolid) continue;
        const int brick = specimen.brick_index({x >> 3, y >> 3, z >> 3});
        if (brick != held) {
          held = brick;
          values = volume.cuttable(brick) ? volume.cut_for_writing(brick) : nullptr;
          none = values == nullptr;
          out.overflow = out.overflow || (none && volume.cuttable(brick));
          if (!none) volume.touched(brick);
        }
        if (none) continue;
        const IVec3 at(x, y, z);
        if (s >= values[brick_offset(x & 7, y & 7, z & 7)]) continue;
        if (beside_tissue(at)) s = kBeside.at(dx, std::abs(dy), std::abs(dz));
        lower(volume, brick, values, at, s, out);
      }
    }
}

}  // namespace

BrickVoxelSet occupied_in(const Volume& volume, int brick) noexcept {
  return occupied_in(volume.specimen(), brick, volume.cut_of(brick));
}
BrickVoxelSet occupied_in(const Specimen& specimen, int brick) noexcept { return occupied_in(specimen, brick, nullptr); }

BrickVoxelSet reached(const BrickVoxelSet& within, const BrickVoxelSet& seeds) noexcept {
  BrickVoxelSet now;
  for (std::size_t z = 0; z < 8; ++z) now.slice[z] = seeds.slice[z] & within.slice[z];
  for (;;) {
    std::array<std::uint64_t, 8> flat;
    for (std::size_t z = 0; z < 8; ++z) flat[z] = grown_y(grown_x(now.slice[z]));
    BrickVoxelSet next;
    for (std::size_t z = 0; z < 8; ++z) {
      std::uint64_t grown = flat[z];
      if (z > 0) grown |= flat[z - 1];
      if (z < 7) grown |= flat[z + 1];
      next.slice[z] = grown & within.slice[z];
    }
    if (next == now) return now;
    now = next;
  }
}

BrickVoxelSet touching(const BrickVoxelSet& set, IVec3 step) noexcept {
  std::array<std::uint64_t, 8> flat;
  for (std::size_t z = 0; z < 8; ++z) {
    std::uint64_t s = set.slice[z];
    s = step.x > 0 ? (s & kHighX) >> 7 : step.x < 0 ? (s & kLowX) << 7 : grown_x(s);
    s = step.y > 0 ? s >> 56 : step.y < 0 ? s << 56 : grown_y(s);
    flat[z] = s;
  }
  BrickVoxelSet out;
  if (step.z > 0) {
    out.slice[0] = flat[7];
  } else if (step.z < 0) {
    out.slice[7] = flat[0];
  } else {
    for (std::size_t z = 0; z < 8; ++z) {
      out.slice[z] = flat[z];
      if (z > 0) out.slice[z] |= flat[z - 1];
      if (z < 7) out.slice[z] |= flat[z + 1];
    }
  }
  return out;
}

bool crumb_at(const Volume& volume, IVec3 voxel, Crumb& out) noexcept {
  out.size = 0;
  if (!volume.occupied(voxel)) return false;
  out.voxel[0] = voxel;
  out.size = 1;
  for (int next = 0; next < out.size; ++next) {
    const IVec3 v = out.voxel[static_cast<std::size_t>(next)];
    for (int i = 0; i < 27; ++i) {
      const IVec3 n = v + IVec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      if (i == 13 || !volume.occupied(n)) continue;
      bool known = false;
      for (int k = 0; k < out.size && !known; ++k) known = out.voxel[static_cast<std::size_t>(k)] == n;
      if (known) continue;
      if (out.size == kCrumbVoxels - 1) return false;
      out.voxel[static_cast<std::size_t>(out.size++)] = n;
    }
  }
  return true;
}

ChangedBox remove_voxels(Volume& volume, std::span<const IVec3> voxels) noexcept {
  ChangedBox out;
  // The voxels themselves first: an occupied voxel beside them then is tissue that stays.
  for (const IVec3& v : voxels) {
    const int brick = volume.specimen().brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
    std::uint16_t* values = volume.cut_for_writing(brick);
    if (values == nullptr) continue;
    lower(volume, brick, values, v, kBeside.at(0, 0, 0), out);
  }
  if (voxels.empty()) return out;
  const NearTissue beside_tissue(volume, {voxels[0].x >> 3, voxels[0].y >> 3, voxels[0].z >> 3});
  for (std::size_t i = 0; i < voxels.size();) {
    std::size_t end = i + 1;
    while (end < voxels.size() && voxels[end] == voxels[end - 1] + IVec3(1, 0, 0)) ++end;
    stamp_row(volume, beside_tissue, voxels[i], static_cast<int>(end - i), out);
    i = end;
  }
  return out;
}

bool remove_voxels(Volume& volume, Occupancy& occupancy, std::span<const IVec3> voxels) noexcept {
  bool room = true;
  for (const IVec3& v : voxels) {
    const int brick = volume.specimen().brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
    std::uint16_t* values = volume.cut_for_writing(brick);
    if (values == nullptr) {
      room = false;
      continue;
    }
    values[brick_offset(v.x & 7, v.y & 7, v.z & 7)] = 0;
    volume.touched(brick);
    occupancy.vanish(v);
  }
  return room;
}

void FragmentRemoval::enter(int brick, const BrickVoxelSet& voxels) noexcept {
  for (Entry& entry : entries_)
    if (entry.brick == brick) {
      for (std::size_t z = 0; z < 8; ++z) entry.voxels.slice[z] |= voxels.slice[z];
      return;
    }
  if (entries_.size() < kMostBricks) entries_.push_back({brick, voxels});
}

void FragmentRemoval::receive(const Volume& volume, std::uint16_t half) noexcept {
  if (half == 0) return;
  if (half & 0x8000u) {
    half_ = half;
    return;
  }
  if (half_ == 0) return;
  const std::uint32_t name = static_cast<std::uint32_t>(half_ & 0x7fffu) << 15 | half;
  half_ = 0;
  const IVec3 n = volume.specimen().brick_count();
  const auto brick = static_cast<int>(name >> 9);
  if (static_cast<std::int64_t>(brick) >= static_cast<std::int64_t>(n.x) * n.y * n.z) return;
  BrickVoxelSet seed;
  seed.add(static_cast<int>(name & 511u));
  enter(brick, seed);
}

int FragmentRemoval::next(const Volume& volume, std::array<IVec3, kBrickVoxels>& voxels) noexcept {
  const Entry entry = entries_.front();
  const BrickVoxelSet part = reached(occupied_in(volume, entry.brick), entry.voxels);
  // Whole slices, up to kVoxelsPerTick; the next tick takes the rest.
  BrickVoxelSet rest = part;
  int count = 0;
  for (std::size_t z = 0; z < 8 && count < kVoxelsPerTick; ++z) {
    count += std::popcount(part.slice[z]);
    rest.slice[z] = 0;
  }
  if (rest.empty()) {
    entries_.erase(entries_.begin());
  } else {
    entries_.front().voxels = rest;
  }
  if (part.empty()) return 0;
  const Specimen& specimen = volume.specimen();
  const IVec3 at = specimen.brick_at(entry.brick);
  for (int i = 0; i < 27; ++i) {
    const IVec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (i == 13) continue;
    const int brick = specimen.brick_index(at + step);
    if (brick < 0 || !volume.cuttable(brick)) continue;
    BrickVoxelSet there = touching(part, step);
    if (there.empty()) continue;
    const BrickVoxelSet occupied = occupied_in(volume, brick);
    for (std::size_t z = 0; z < 8; ++z) there.slice[z] &= occupied.slice[z];
    if (!there.empty()) enter(brick, there);
  }
  count = 0;
  for (int o = 0; o < kBrickVoxels; ++o)
    if (part.has(o) && !rest.has(o))
      voxels[static_cast<std::size_t>(count++)] = at * kBrickEdge + IVec3(o & 7, o >> 3 & 7, o >> 6);
  return count;
}

bool FragmentRemoval::load(std::uint16_t half, std::span<const Entry> entries, int bricks) noexcept {
  if (entries.size() > kMostBricks) return false;
  for (const Entry& entry : entries)
    if (entry.brick < 0 || entry.brick >= bricks) return false;
  half_ = half;
  entries_.assign(entries.begin(), entries.end());
  return true;
}

}  // namespace cusp::engine
