/// A specimen and its cuts, as two fields. The base B is the specimen's, shared and immutable; the cut C is stored in
/// the bricks that a bur has reached. A voxel's solid fraction is s = min(B, C). A filled reading's C holds the worn
/// fraction. One writer thread. The constructor takes all memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/volume/specimen.h"

namespace cusp::engine {

/// Most bricks that a volume reserves cut memory for: 17 MB. They hold 537 mm3 of cuts at voxels of 0.04 mm and 8,400
/// mm3 at 0.1 mm, more than any preparation. A scene of fewer bricks reserves for all of them.
inline constexpr std::size_t kMostCutBricks = 16384;

class Volume {
 public:
  /// Reserves memory for every brick that holds tissue and for its neighbours, kMostCutBricks at most.
  explicit Volume(std::shared_ptr<const Specimen> specimen);

  const Specimen& specimen() const noexcept { return *specimen_; }
  const std::shared_ptr<const Specimen>& specimen_ptr() const noexcept { return specimen_; }
  const Grid& grid() const noexcept { return specimen_->grid(); }

  /// Solid fraction now: min(B, C).
  std::uint16_t s(IVec3 v) const noexcept {
    const int b = specimen_->brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
    if (b < 0) return 0;
    const int o = brick_offset(v.x & 7, v.y & 7, v.z & 7);
    const std::uint16_t base = specimen_->s_in(b, o);
    const std::uint16_t cut = cut_in(b, o);
    return base < cut ? base : cut;
  }
  /// The cut field alone: kSolid where nothing was cut.
  std::uint16_t cut(IVec3 v) const noexcept {
    const int b = specimen_->brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
    return b < 0 ? kSolid : cut_in(b, brick_offset(v.x & 7, v.y & 7, v.z & 7));
  }
  std::uint16_t cut_in(int brick, int offset) const noexcept {
    const int slot = slot_[static_cast<std::size_t>(brick)];
    return slot < 0 ? kSolid : cut_[static_cast<std::size_t>(slot) * kBrickVoxels + static_cast<std::size_t>(offset)];
  }
  /// The voxel's tissue at the start: removal does not change it.
  Tissue tissue(IVec3 v) const noexcept { return specimen_->tissue(v); }
  bool occupied(IVec3 v) const noexcept {
    const std::uint16_t value = s(v);
    return specimen_->reading() == Reading::filled ? value > 0 : value >= kHalf;
  }

  /// Bricks with a cut field, in the order in which they were first cut.
  std::span<const std::int32_t> cut_bricks() const noexcept { return cut_order_; }
  /// Place of a brick's cut values, dense from 0 in the order of first cutting; -1 where nothing was cut.
  int cut_slot(int brick) const noexcept { return std::max<int>(slot_[static_cast<std::size_t>(brick)], kUncut); }
  std::size_t cut_capacity() const noexcept { return capacity_; }
  /// False for a brick that no tissue is within a brick of.
  bool cuttable(int brick) const noexcept { return slot_[static_cast<std::size_t>(brick)] != kOutOfReach; }
  bool has_cut(int brick) const noexcept { return slot_[static_cast<std::size_t>(brick)] >= 0; }
  /// The 512 cut values of a brick, nullptr where nothing was cut.
  const std::uint16_t* cut_of(int brick) const noexcept {
    const int slot = slot_[static_cast<std::size_t>(brick)];
    return slot < 0 ? nullptr : &cut_[static_cast<std::size_t>(slot) * kBrickVoxels];
  }
  /// Rises with each change of the brick's surface; 0 before the first. For drawing and for caches.
  std::uint32_t revision(int brick) const noexcept {
    const int slot = slot_[static_cast<std::size_t>(brick)];
    return slot < 0 ? loaded_ : revision_[static_cast<std::size_t>(slot)];
  }

  /// Haptic thread. The cut values of a brick, for writing. The first call for a brick fills them: solid, or the base
  /// of a filled reading. nullptr if the reserved memory is used up: the step reports an overflow, and tests expect
  /// none.
  std::uint16_t* cut_for_writing(int brick) noexcept;
  /// Id of the ball's sweep that comes nearest to a voxel, beside the cut field, for a scene whose contact reads it.
  /// kNoSweep: nothing was cut here, or the last to cut here was no ball.
  static constexpr std::int32_t kNoSweep = -1;
  /// Not on the haptic thread: takes the memory for them.
  void keep_sweeps();
  bool keeps_sweeps() const noexcept { return !sweep_.empty(); }
  /// The 512 ids of a brick; nullptr where nothing was cut and where no ids are kept.
  const std::int32_t* sweeps_of(int brick) const noexcept {
    const int slot = slot_[static_cast<std::size_t>(brick)];
    return slot < 0 || sweep_.empty() ? nullptr : &sweep_[static_cast<std::size_t>(slot) * kBrickVoxels];
  }
  /// Haptic thread. A voxel that something other than a ball's sweep has lowered. Pre: has_cut(brick).
  void forget_sweep(int brick, int offset) noexcept {
    if (std::int32_t* ids = sweeps_for_writing(brick)) ids[offset] = kNoSweep;
  }
  /// Haptic thread. The ids of a brick, for writing.
  std::int32_t* sweeps_for_writing(int brick) noexcept { return const_cast<std::int32_t*>(sweeps_of(brick)); }

  /// Haptic thread. To be called once after each write that moves the surface of a brick. Pre: has_cut(brick).
  void touched(int brick) noexcept { ++revision_[static_cast<std::size_t>(slot_[static_cast<std::size_t>(brick)])]; }

  /// The same on every machine for the same specimen and the same cuts, whatever their order.
  std::uint64_t hash() const noexcept;
  std::size_t bytes() const noexcept;

  /// Specimen and cuts in the dense form, s = min(B, C), tissue empty where s = 0.
  VoxelVolume dense() const;

  /// The cuts alone, as bytes: count, then brick index and 512 values each, in index order, little-endian.
  std::vector<std::byte> save_cuts() const;
  /// Replaces the cuts. False, and unchanged, if the bytes do not fit this specimen.
  bool load_cuts(std::span<const std::byte> bytes);

  /// The ids alone, as bytes: 512 of 4 bytes for each cut brick, in index order, little-endian.
  std::vector<std::byte> save_sweeps() const;
  /// Replaces the ids of the bricks that are cut. False, and unchanged, if the bytes do not fit, or an id is not below `count`.
  bool load_sweeps(std::span<const std::byte> bytes, std::int32_t count);
  std::uint64_t sweeps_hash() const noexcept;

 private:
  std::shared_ptr<const Specimen> specimen_;
  static constexpr std::int16_t kUncut = -1, kOutOfReach = -2;
  static_assert(kMostCutBricks <= 32768, "a slot's number is kept in 16 bits");

  std::vector<std::int16_t> slot_;       // [brick]: place in cut_, kUncut, or kOutOfReach of any tissue
  std::vector<std::uint16_t> cut_;       // [slot][512]
  std::vector<std::int32_t> sweep_;      // [slot][512]; empty unless kept
  std::vector<std::uint32_t> revision_;  // [slot]
  std::vector<std::int32_t> cut_order_;  // [slot]: its brick; capacity reserved
  std::size_t capacity_ = 0;             // slots
  std::uint32_t loaded_ = 0;             // revision of all bricks since the last load
};

}  // namespace cusp::engine
