/// The void that balls have cut, at a place: how deep it lies in what the sweeps have swept that the voxels about it name, 32
/// at most. It keeps the sweeps of 4,096 cells, a mask a brick, and cells of the specimen's field. Frame: specimen, mm. Thread: haptic. Wait-free; the constructor takes all memory.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/contact/cavity/sweeps.h"
#include "engine/volume/cell_field.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

/// State of the cutting: sweeps that are not carved yet, and the end of those that are.
struct Cutting {
  SweepRun uncarved{0, -1};
  std::int32_t end = 0;
  bool any() const noexcept { return uncarved.to >= uncarved.from; }
};

/// The sweeps that the voxels between `cell` and cell + 1 name. False if one names none.
bool sweeps_of_cell(const Volume& volume, IVec3 cell, std::int32_t (&ids)[8]) noexcept;

/// Sweeps about a cell.
struct SweptRuns {
  static constexpr int kMost = 16;
  SweepRun run[kMost];
  int count = 0;
  IVec3 cell{1 << 30};             // between the voxels `cell` and cell + 1
  std::int32_t end = -1;           // they are made of the sweeps before this; -1: nothing is made
  std::int32_t newest = -1;        // that its voxels name
  bool known = false;              // each of its voxels names a sweep, and the specimen has tissue here
  bool near_base = false;          // the specimen's own surface passes the cell or a neighbour
};

class SweptVoid {
 public:
  /// sweeps outlives this.
  SweptVoid(const Volume& volume, const Sweeps& sweeps);

  /// A place that lies deeper than this is void. 2 nm: the rounding of the sweeps' places.
  static constexpr double kTakenMm = 2e-6;
  static constexpr double kBaseTakenMm = 1e-5;  // of the specimen's field, which is less exact than sweeps

  /// The sweeps that are carved about the cell of p. Valid until the next call.
  const SweptRuns& runs_at(const Volume& volume, Vec3 p, std::int32_t end) noexcept;
  /// Runs of sweeps that the voxels about p name, in the air, too. Their number, at most 8.
  int near(const Volume& volume, Vec3 p, std::int32_t end, SweepRun (&run)[8]) const noexcept;
  /// Distance in mm from p to what is left by the voxels about it alone, positive in the void: off by less than kOffMm.
  static constexpr double kOffMm = 0.015;
  double about_mm(const Volume& volume, Vec3 p) const noexcept;

  /// Distance to the specimen's own surface, positive outside the tissue; mm, a bound beyond the band.
  FieldPoint base(const Volume& volume, Vec3 p) noexcept { return base_.at(volume, Field::base, p); }

  /// Of the cells whose lower corner lies in a brick, a bit each as in brick_offset: all voxels name a sweep, and the specimen
  /// has no point of its own in it. Sweeps alone say what such a cell holds.
  struct Known {
    std::uint64_t slice[8];
    bool has(int cell) const noexcept { return (slice[cell >> 6] >> (cell & 63) & 1) != 0; }
  };
  /// Pre: volume.has_cut(brick).
  const Known& known(const Volume& volume, int brick) noexcept;

  /// Voxels low..high (inclusive) have changed.
  void changed(const Volume& volume, IVec3 low, IVec3 high) noexcept;
  void forget() noexcept;

 private:
  void find_known(const Volume& volume, IVec3 at, Known& out) const noexcept;
  static constexpr int kNames = 32;  // voxels that name sweeps: a cell's own and those beyond its faces
  int names_about(const Volume& volume, IVec3 cell, std::int32_t (&ids)[kNames]) const noexcept;
  int collect(const std::int32_t* ids, int names, std::int32_t end, SweepRun (&run)[kNames]) const noexcept;
  void trim(const SweepRun* all, int count, SweptRuns& out) const noexcept;
  void make(const Volume& volume, SweptRuns& out) const noexcept;
  static constexpr std::size_t kCells = 4096;

  const Sweeps& sweeps_;
  double voxel_mm_;
  Vec3 origin_mm_;
  FieldCells base_;
  std::vector<SweptRuns> cells_;           // by the cell's low bits
  std::vector<Known> known_;               // [slot]
  std::vector<std::uint8_t> known_valid_;  // [slot]
};

}  // namespace cusp::engine
