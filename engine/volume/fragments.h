/// Fragments: connected components of occupied voxels that cutting has severed. Voxels connect over the 26 neighbours, so that a
/// thin oblique wall holds. Components that were apart at the start are no fragments of each other.
///
/// A *crumb* is a component of less than kCrumbVoxels; the tick that severs it removes it: for_crumbs() searches about the cut.
/// A larger *fragment* is found off the haptic thread (find_severed_fragments) and named to the step by one of its voxels in the
/// recorded inputs. The step removes it, at most a brick a tick (FragmentRemoval), the same in every replay.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/volume/occupancy.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

inline constexpr int kCrumbVoxels = 27;

/// Which voxels of a brick: bit x | y << 3 of slice z.
struct BrickVoxelSet {
  std::array<std::uint64_t, 8> slice{};

  bool empty() const noexcept {
    std::uint64_t any = 0;
    for (const std::uint64_t s : slice) any |= s;
    return any == 0;
  }
  int count() const noexcept {
    int sum = 0;
    for (const std::uint64_t s : slice) sum += std::popcount(s);
    return sum;
  }
  bool has(int offset) const noexcept { return (slice[static_cast<std::size_t>(offset >> 6)] >> (offset & 63) & 1) != 0; }
  void add(int offset) noexcept { slice[static_cast<std::size_t>(offset >> 6)] |= std::uint64_t{1} << (offset & 63); }
  /// Lowest offset. Pre: not empty.
  int first() const noexcept {
    int z = 0;
    while (slice[static_cast<std::size_t>(z)] == 0) ++z;
    return z << 6 | std::countr_zero(slice[static_cast<std::size_t>(z)]);
  }
  friend bool operator==(const BrickVoxelSet&, const BrickVoxelSet&) = default;
};

/// Occupied voxels of a brick. Thread: the volume's owner; wait-free.
BrickVoxelSet occupied_in(const Volume& volume, int brick) noexcept;
/// The same before anything was cut.
BrickVoxelSet occupied_in(const Specimen& specimen, int brick) noexcept;
/// Everything of `within` that `seeds` reaches over the 26 neighbours, inside the brick.
BrickVoxelSet reached(const BrickVoxelSet& within, const BrickVoxelSet& seeds) noexcept;
/// What touches `set` from the brick that lies by `step` (-1, 0, 1 each) beside its own: voxels of that brick.
BrickVoxelSet touching(const BrickVoxelSet& set, IVec3 step) noexcept;

/// A crumb's voxels.
struct Crumb {
  std::array<IVec3, kCrumbVoxels - 1> voxel;
  int size = 0;
  std::span<const IVec3> voxels() const noexcept { return {voxel.data(), static_cast<std::size_t>(size)}; }
};

/// The component of a voxel if it is a crumb; false if it is larger or the voxel is empty.
/// Reads at most kCrumbVoxels voxels, each with its 26 neighbours. Haptic thread; wait-free.
bool crumb_at(const Volume& volume, IVec3 voxel, Crumb& out) noexcept;

/// Haptic thread; wait-free. Calls gone(const Crumb&) for every crumb that touches a changed voxel, in order of bricks and
/// voxels; gone() has to remove it. low..high: voxels that may have changed, inclusive; for_boxes(mark) calls
/// mark(low, high) for boxes that together hold them. Reads each brick that they touch once, 0.1 to 0.5 us.
template <class ForBoxes, class Gone>
void for_crumbs(const Volume& volume, IVec3 low, IVec3 high, ForBoxes&& for_boxes, Gone&& gone) noexcept {
  const Specimen& specimen = volume.specimen();
  const auto brick_of = [](IVec3 v) { return IVec3(v.x >> 3, v.y >> 3, v.z >> 3); };
  const IVec3 last = volume.grid().size - 1;
  const IVec3 from = brick_of(glm::max(low - 1, IVec3(0))), to = brick_of(glm::min(high + 1, last));
  // One bit a brick, where there is room for so many: else all of the box are looked at.
  constexpr int kMarks = 4096;
  const IVec3 n = to - from + 1;
  const bool marks = static_cast<std::int64_t>(n.x) * n.y * n.z <= kMarks;
  std::array<std::uint64_t, kMarks / 64> marked{};
  const auto place = [&](IVec3 brick) { return brick.x - from.x + n.x * (brick.y - from.y + n.y * (brick.z - from.z)); };
  if (marks)
    for_boxes([&](IVec3 a, IVec3 b) {
      const IVec3 first = brick_of(glm::max(a - 1, IVec3(0))), end = brick_of(glm::min(b + 1, last));
      for (int z = first.z; z <= end.z; ++z)
        for (int y = first.y; y <= end.y; ++y)
          for (int x = first.x; x <= end.x; ++x) {
            const int at = place({x, y, z});
            marked[static_cast<std::size_t>(at >> 6)] |= std::uint64_t{1} << (at & 63);
          }
    });
  Crumb crumb;
  IVec3 at;
  for (at.z = from.z; at.z <= to.z; ++at.z)
    for (at.y = from.y; at.y <= to.y; ++at.y)
      for (at.x = from.x; at.x <= to.x; ++at.x) {
        const int mark = place(at);
        if (marks && (marked[static_cast<std::size_t>(mark >> 6)] >> (mark & 63) & 1) == 0) continue;
        const int brick = specimen.brick_index(at);
        if (brick < 0 || !volume.cuttable(brick)) continue;
        BrickVoxelSet left = occupied_in(volume, brick);
        while (!left.empty()) {
          BrickVoxelSet seed;
          const int o = left.first();
          seed.add(o);
          const BrickVoxelSet part = reached(left, seed);
          for (std::size_t z = 0; z < 8; ++z) left.slice[z] &= ~part.slice[z];
          if (part.count() >= kCrumbVoxels) continue;
          if (crumb_at(volume, at * kBrickEdge + IVec3(o & 7, o >> 3 & 7, o >> 6), crumb)) gone(crumb);
        }
      }
}

/// Voxels whose values changed, inclusive; valid when any.
struct ChangedBox {
  bool any = false;
  bool overflow = false;  // a brick had no room: what lies there stays
  IVec3 low{0}, high{0};
};
/// Haptic thread; wait-free. Removes voxels of a banded volume: C = min(C, outside of a ball about each). The ball's radius is one
/// voxel beside tissue that stays, else 1.75: a fragment's surface stands off its outermost centres by up to that at corners.
/// No other occupied voxel is lost unless it touches them.
ChangedBox take_away(Volume& volume, std::span<const IVec3> voxels) noexcept;
/// The same for a filled volume. False if there was no room for some.
bool take_away(Volume& volume, Occupancy& occupancy, std::span<const IVec3> voxels) noexcept;

/// Name of a voxel in the recorded inputs: brick and offset in 30 bits, sent as two halves of 15. Bricks beyond the
/// two millionth (1024^3 voxels) have none.
inline constexpr int kMostNamedBricks = 1 << 21;
constexpr std::uint32_t voxel_name(int brick, int offset) noexcept {
  return static_cast<std::uint32_t>(brick) << 9 | static_cast<std::uint32_t>(offset);
}

/// Removal of named fragments, a brick a tick at most and a full brick in parts, so that a tick's work is bounded. An entry is a
/// brick still to visit, with the voxels that the fragment enters it by, or that are left of it there. What finds no room is
/// found, and named, again. Part of the step's state. Thread: haptic; memory is taken at construction.
class FragmentRemoval {
 public:
  static constexpr int kMostBricks = 512;
  static constexpr int kVoxelsPerTick = 192;  // and up to one slice of 64 more: slices go whole
  struct Entry {
    std::int32_t brick = 0;
    BrickVoxelSet voxels;
  };

  FragmentRemoval() { entries_.reserve(kMostBricks); }

  /// A half of a name, as StepInput::fragment has it: bit 15 marks the first (higher) half; 0 is nothing.
  void receive(const Volume& volume, std::uint16_t half) noexcept;
  bool active() const noexcept { return !entries_.empty(); }
  /// Removes the fragment's voxels in the brick that has waited longest, kVoxelsPerTick at most: calls
  /// gone(std::span<const IVec3>) if there are any.
  template <class Gone>
  void advance(const Volume& volume, Gone&& gone) noexcept {
    if (entries_.empty()) return;
    std::array<IVec3, kBrickVoxels> voxels;
    const int count = next(volume, voxels);
    if (count > 0) gone(std::span<const IVec3>(voxels.data(), static_cast<std::size_t>(count)));
  }

  /// For saving: the first half of a name that waits for its second (0: none), and the entries in order.
  std::uint16_t half() const noexcept { return half_; }
  std::span<const Entry> entries() const noexcept { return entries_; }
  /// False, and unchanged, if there are too many entries or a brick is not below `bricks`.
  bool load(std::uint16_t half, std::span<const Entry> entries, int bricks) noexcept;

 private:
  int next(const Volume& volume, std::array<IVec3, kBrickVoxels>& voxels) noexcept;
  void enter(int brick, const BrickVoxelSet& voxels) noexcept;

  std::vector<Entry> entries_;
  std::uint16_t half_ = 0;
};

/// Off the haptic thread. Names of the fragments of each component of the specimen, all but the largest; empty if all still
/// hangs together. changed_bricks: since the last call, else a fragment may be missed. Cost: the changed bricks, and the
/// smaller fragments' voxels.
std::vector<std::uint32_t> find_severed_fragments(const Volume& volume, std::span<const std::int32_t> changed_bricks);

}  // namespace cusp::engine
