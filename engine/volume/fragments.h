/// Fragments: connected components of occupied voxels that cutting has severed. Voxels connect over the 26 neighbours,
/// so a thin oblique wall is connected. Components that were apart at the start are no fragments of each other.
///
/// A *crumb* is a component of less than kCrumbVoxels. The tick that severs a crumb removes it: for_crumbs() searches
/// about the cut. find_severed_fragments() finds larger fragments off the haptic thread. The recorded inputs name a
/// fragment by one of its voxels; the step removes it, at most a brick a tick (FragmentRemoval), the same in every
/// replay.
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
/// A larger part stays: its root or a vice holds it. A molar's crown has 300 mm³, a cusp less than 60 [M].
inline constexpr double kMostFragmentMm3 = 150.0;

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
/// Voxels of `within` that are connected to `seeds` inside the brick.
BrickVoxelSet reached(const BrickVoxelSet& within, const BrickVoxelSet& seeds) noexcept;
/// Voxels of the neighbour brick at `step` (-1, 0, 1 each) that touch `set`.
BrickVoxelSet touching(const BrickVoxelSet& set, IVec3 step) noexcept;

/// A crumb's voxels.
struct Crumb {
  std::array<IVec3, kCrumbVoxels - 1> voxel;
  int size = 0;
  std::span<const IVec3> voxels() const noexcept { return {voxel.data(), static_cast<std::size_t>(size)}; }
};

/// The component of a voxel. False if it is no crumb, or the voxel is empty.
/// Reads at most kCrumbVoxels voxels, each with its 26 neighbours. Haptic thread; wait-free.
bool crumb_at(const Volume& volume, IVec3 voxel, Crumb& out) noexcept;

/// Haptic thread; wait-free. Calls remove(const Crumb&) for every crumb that touches a changed voxel, in order of
/// bricks and voxels. low..high: voxels that may have changed, inclusive. for_boxes(mark) calls mark(low, high) for
/// boxes that together contain them. Reads each brick that they touch once, 0.1 to 0.5 us.
template <class ForBoxes, class Remove>
void for_crumbs(const Volume& volume, IVec3 low, IVec3 high, ForBoxes&& for_boxes, Remove&& remove) noexcept {
  const Specimen& specimen = volume.specimen();
  const auto brick_of = [](IVec3 v) { return IVec3(v.x >> 3, v.y >> 3, v.z >> 3); };
  const IVec3 last = volume.grid().size - 1;
  const IVec3 from = brick_of(glm::max(low - 1, IVec3(0))), to = brick_of(glm::min(high + 1, last));
  // One bit a brick. If the box has more bricks than bits, all of them are read.
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
          if (crumb_at(volume, at * kBrickEdge + IVec3(o & 7, o >> 3 & 7, o >> 6), crumb)) remove(crumb);
        }
      }
}

/// Voxels whose values changed, inclusive; valid if any.
struct ChangedBox {
  bool any = false;
  bool overflow = false;  // a brick had no memory, so its voxels stay
  IVec3 low{0}, high{0};
};
/// Haptic thread; wait-free. Removes voxels of a banded volume: C = min(C, outside of a ball about each). The ball's
/// radius is one voxel beside tissue that stays, else 1.75. At corners the surface is up to that far from the outermost
/// centres. An occupied voxel that touches none of them stays.
ChangedBox remove_voxels(Volume& volume, std::span<const IVec3> voxels) noexcept;
/// The same for a filled volume. False if a brick had no memory.
bool remove_voxels(Volume& volume, Occupancy& occupancy, std::span<const IVec3> voxels) noexcept;

/// Name of a voxel in the recorded inputs: brick and offset in 30 bits, sent as two halves of 15. Bricks from
/// kMostNamedBricks (1024^3 voxels) have none.
inline constexpr int kMostNamedBricks = 1 << 21;
constexpr std::uint32_t voxel_name(int brick, int offset) noexcept {
  return static_cast<std::uint32_t>(brick) << 9 | static_cast<std::uint32_t>(offset);
}

/// Removal of named fragments. To bound a tick's work, it removes at most a brick a tick, and a full brick in parts. An
/// entry is a brick still to visit, with the voxels that the fragment enters it by, or its remaining voxels there. If
/// the list is full, the rest stays; the next search finds and names it again. Part of the step's state. Thread:
/// haptic; the constructor takes all memory.
class FragmentRemoval {
 public:
  static constexpr int kMostBricks = 512;
  static constexpr int kVoxelsPerTick = 192;  // plus up to 64: a slice is removed whole
  struct Entry {
    std::int32_t brick = 0;
    BrickVoxelSet voxels;
  };

  FragmentRemoval() { entries_.reserve(kMostBricks); }

  /// A half of a name, from StepInput::fragment: bit 15 marks the first (higher) half; 0 is none.
  void receive(const Volume& volume, std::uint16_t half) noexcept;
  bool active() const noexcept { return !entries_.empty(); }
  /// Takes the fragment's voxels in the first brick of the list, kVoxelsPerTick at most, and calls
  /// remove(std::span<const IVec3>) if there are any.
  template <class Remove>
  void advance(const Volume& volume, Remove&& remove) noexcept {
    if (entries_.empty()) return;
    std::array<IVec3, kBrickVoxels> voxels;
    const int count = next(volume, voxels);
    if (count > 0) remove(std::span<const IVec3>(voxels.data(), static_cast<std::size_t>(count)));
  }

  /// For a key state: the first half of a name whose second has not come (0: none), and the entries in order.
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

/// Off the haptic thread. Names of the fragments of each component of the specimen: all but the largest, and none above
/// kMostFragmentMm3. Empty if nothing is severed. changed_bricks: all since the last call; if one is left out, a fragment may be missed. Cost: the
/// changed bricks, and the smaller fragments' voxels.
std::vector<std::uint32_t> find_severed_fragments(const Volume& volume, std::span<const std::int32_t> changed_bricks);

}  // namespace cusp::engine
