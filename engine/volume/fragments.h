/// Pieces that cutting has severed. Pieces are of occupied voxels joined over the 26 neighbours (so that a thin oblique
/// wall holds), never of what lay apart already at the start.
///
/// A *crumb* (under kCrumbVoxels) goes in the tick that severs it: for_crumbs() looks round what was just cut. A *loose
/// piece* is found off the thread (find_loose_pieces) and named to the step by one of its voxels in the recorded inputs;
/// the step then takes it away, at most a brick a tick (LeavingPiece), the same in every replay.
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

/// The whole piece that a voxel belongs to when it is a crumb; false when it is larger, or the voxel is empty.
/// At most kCrumbVoxels voxels are looked at, each with its 26 neighbours. Haptic thread; wait-free.
bool crumb_at(const Volume& volume, IVec3 voxel, Crumb& out) noexcept;

/// Haptic thread; wait-free. Calls gone(const Crumb&) for every crumb that touches a changed voxel, in order of bricks and
/// voxels; gone() has to take it away. low..high: voxels that may have changed, inclusive; tell(mark) calls
/// mark(low, high) for boxes that together hold them. Reads each brick that they touch once, 0.1 to 0.5 us.
template <class Tell, class Gone>
void for_crumbs(const Volume& volume, IVec3 low, IVec3 high, Tell&& tell, Gone&& gone) noexcept {
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
    tell([&](IVec3 a, IVec3 b) {
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
          const BrickVoxelSet piece = reached(left, seed);
          for (std::size_t z = 0; z < 8; ++z) left.slice[z] &= ~piece.slice[z];
          if (piece.count() >= kCrumbVoxels) continue;
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
/// Haptic thread; wait-free. Takes voxels of a banded volume away: C = min(C, a ball of one voxel's radius about each),
/// of 1.75 where no tissue that stays is beside: a piece's own surface stands off its outermost centres by that much at its
/// corners, and would still be felt. Nothing that does not touch them loses an occupied voxel.
ChangedBox take_away(Volume& volume, std::span<const IVec3> voxels) noexcept;
/// The same of a filled one. False when there was no room for some.
bool take_away(Volume& volume, Occupancy& occupancy, std::span<const IVec3> voxels) noexcept;

/// Name of a voxel in the recorded inputs: brick and offset in 30 bits, sent as two halves of 15. Bricks beyond the
/// two millionth (1024^3 voxels) have none.
inline constexpr int kMostNamedBricks = 1 << 21;
constexpr std::uint32_t voxel_name(int brick, int offset) noexcept {
  return static_cast<std::uint32_t>(brick) << 9 | static_cast<std::uint32_t>(offset);
}

/// A piece on its way out: bricks still to be visited, with the voxels that it enters them by, or that are left of it there.
/// A brick a tick at most, of a full one a part, so that a tick's work is bounded; what finds no room is found again, and named again, by whoever looks for loose pieces.
/// Part of the step's state. Thread: haptic; memory is taken at construction.
class LeavingPiece {
 public:
  static constexpr int kMostBricks = 512;
  static constexpr int kVoxelsATick = 192;  // and at most a slice of 64 more
  struct Entry {
    std::int32_t brick = 0;
    BrickVoxelSet voxels;
  };

  LeavingPiece() { entries_.reserve(kMostBricks); }

  /// A half of a name, as StepInput::loose has it: bit 15 marks the first (higher) half; 0 is nothing.
  void hear(const Volume& volume, std::uint16_t half) noexcept;
  bool active() const noexcept { return !entries_.empty(); }
  /// Takes away what the piece has in the brick that has waited longest, or as much of it as a tick has time for. Calls gone(std::span<const IVec3>) where there is any.
  template <class Gone>
  void advance(const Volume& volume, Gone&& gone) noexcept {
    if (entries_.empty()) return;
    std::array<IVec3, kBrickVoxels> voxels;
    const int count = next(volume, voxels);
    if (count > 0) gone(std::span<const IVec3>(voxels.data(), static_cast<std::size_t>(count)));
  }

  /// For saving: a half that waits for its second (0: none), and the entries in order.
  std::uint16_t half() const noexcept { return half_; }
  std::span<const Entry> entries() const noexcept { return entries_; }
  /// False (and unchanged) when it cannot be.
  bool load(std::uint16_t half, std::span<const Entry> entries, int bricks) noexcept;

 private:
  int next(const Volume& volume, std::array<IVec3, kBrickVoxels>& voxels) noexcept;
  void enter(int brick, const BrickVoxelSet& voxels) noexcept;

  std::vector<Entry> entries_;
  std::uint16_t half_ = 0;
};

/// Off the haptic thread. Voxel names of the pieces that the changed bricks' pieces have fallen into, one for each but
/// the largest of what hung together at the start; nothing where all still hangs together. Cheap then; else as much work as
/// the smaller pieces are large. Changed bricks: since the last call, else a piece may be missed.
std::vector<std::uint32_t> find_loose_pieces(const Volume& volume, std::span<const std::int32_t> changed_bricks);

}  // namespace cusp::engine
