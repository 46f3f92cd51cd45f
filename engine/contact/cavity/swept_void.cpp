#include "engine/contact/cavity/swept_void.h"

#include <algorithm>
#include <cmath>

#include "engine/volume/changed_voxels.h"

namespace cusp::engine {

namespace {

/// A cell's surface lies within its box: sweeps that hold its middle less deep than the deepest by twice this own none.
constexpr double kReach = 1.0;  // voxels: half the diagonal of a cell, 0.87, and a little more
constexpr int kBefore = 5, kAfter = 5;  // sweeps before and after a named one that can own surface in its cell
/// Of the specimen's own voxels: all beyond the first, and a cell lies in the air; all within the second, deep in the tissue.
const std::uint16_t kAir = solid_from_distance(1.0), kDeep = solid_from_distance(-1.8);

std::size_t place_of(IVec3 cell) noexcept {
  return static_cast<std::size_t>((cell.x & 15) | (cell.y & 15) << 4 | (cell.z & 15) << 8);
}

/// kSide voxels along each axis, from `low` on: their bricks and offsets. Where a brick ends cannot be predicted, so nothing
/// branches on it.
template <int kSide>
class Window {
 public:
  Window(const Specimen& specimen, IVec3 low) noexcept {
    const IVec3 bricks = specimen.brick_count(), stride(1, bricks.x, bricks.x * bricks.y);
    for (int axis = 0; axis < 3; ++axis)
      for (int k = 0; k < kSide; ++k) {
        const int v = low[axis] + k, at = v >> 3;
        brick_[axis][k] = at < 0 || at >= bricks[axis] ? kOutside : at * stride[axis];
        offset_[axis][k] = (v & 7) << 3 * axis;
      }
  }
  /// What of(brick) has for a voxel; `none` outside or without of(brick).
  template <class T, class Of>
  T at(int x, int y, int z, T none, Of&& of) const noexcept {
    const int brick = brick_[0][x] + brick_[1][y] + brick_[2][z];
    const auto* values = brick < 0 ? nullptr : of(brick);
    return values == nullptr ? none : values[offset_[0][x] | offset_[1][y] | offset_[2][z]];
  }

 private:
  static constexpr int kOutside = -(1 << 29);  // three of them are no overflow
  int brick_[3][kSide], offset_[3][kSide];
};

auto sweeps_in(const Volume& volume) noexcept {
  return [&volume](int brick) { return volume.sweeps_of(brick); };
}

}  // namespace

bool sweeps_of_cell(const Volume& volume, IVec3 cell, std::int32_t (&ids)[8]) noexcept {
  const Window<2> window(volume.specimen(), cell);
  bool all = true;
  for (int i = 0; i < 8; ++i) {
    ids[i] = window.at(i & 1, i >> 1 & 1, i >> 2, Volume::kNoSweep, sweeps_in(volume));
    all = all && ids[i] >= 0;
  }
  return all;
}

SweptVoid::SweptVoid(const Volume& volume, const Sweeps& sweeps)
    : sweeps_(sweeps),
      voxel_mm_(volume.grid().voxel_mm),
      origin_mm_(volume.grid().origin_mm),
      cells_(kCells),
      known_(volume.cut_capacity()),
      known_valid_(volume.cut_capacity(), 0) {}

void SweptVoid::forget() noexcept {
  std::fill(known_valid_.begin(), known_valid_.end(), std::uint8_t{0});
  std::fill(cells_.begin(), cells_.end(), SweptRuns{});
  base_ = FieldCells();
}

void SweptVoid::changed(const Volume& volume, IVec3 low, IVec3 high) noexcept {
  if (sweeps_.size() == 0) return;  // no voxel names one
  const IVec3 from = glm::max(low - 1, IVec3(0));
  for_bricks_of(from, high, [&](const ChangedVoxels& part) {
    const int brick = volume.specimen().brick_index(part.low >> 3);
    const int slot = brick < 0 ? -1 : volume.cut_slot(brick);
    if (slot >= 0) known_valid_[static_cast<std::size_t>(slot)] = 0;
  });
  // A cell's sweeps are named by voxels beyond its faces, too.
  for (int z = from.z - 1; z <= high.z + 1; ++z)
    for (int y = from.y - 1; y <= high.y + 1; ++y)
      for (int x = from.x - 1; x <= high.x + 1; ++x) cells_[place_of({x, y, z})].end = -1;
}

const SweptVoid::Known& SweptVoid::known(const Volume& volume, int brick) noexcept {
  const auto slot = static_cast<std::size_t>(volume.cut_slot(brick));
  if (known_valid_[slot] == 0) {
    known_valid_[slot] = 1;
    find_known(volume, volume.specimen().brick_at(brick), known_[slot]);
  }
  return known_[slot];
}

void SweptVoid::find_known(const Volume& volume, IVec3 at, Known& out) const noexcept {
  const Specimen& specimen = volume.specimen();
  int brick[8];
  for (int i = 0; i < 8; ++i) brick[i] = specimen.brick_index(at + IVec3(i & 1, i >> 1 & 1, i >> 2));
  // [z][y]: nine voxels in a row that name a sweep.
  unsigned known[9][9];
  for (int z = 0; z < 9; ++z)
    for (int y = 0; y < 9; ++y) {
      known[z][y] = 0;
      for (int over = 0; over < 2; ++over) {
        const int b = brick[over | (y >> 3) << 1 | (z >> 3) << 2];
        const std::int32_t* ids = b < 0 ? nullptr : volume.sweeps_of(b);
        if (ids == nullptr) continue;
        const int row = brick_offset(0, y & 7, z & 7);
        for (int x = 0; x < (over == 0 ? 8 : 1); ++x)
          if (ids[row + x] >= 0) known[z][y] |= 1u << (8 * over + x);
      }
    }
  for (int z = 0; z < 8; ++z) {
    out.slice[z] = 0;
    for (int y = 0; y < 8; ++y) {
      const unsigned four = known[z][y] & known[z][y + 1] & known[z + 1][y] & known[z + 1][y + 1];
      out.slice[z] |= static_cast<std::uint64_t>(four & four >> 1 & 0xffu) << (8 * y);
    }
  }
  const BasePoints points = specimen.surface().in(specimen.brick_index(at));
  for (int i = 0; i < points.count; ++i) {
    const int cell = points.normal[i].cell();
    out.slice[cell >> 6] &= ~(std::uint64_t{1} << (cell & 63));
  }
}

double SweptVoid::about_mm(const Volume& volume, Vec3 p) const noexcept {
  const Vec3 x = (p - origin_mm_) / voxel_mm_;
  const IVec3 cell = cell_of_voxels(x);
  const Window<2> window(volume.specimen(), cell);
  int values[8];
  for (int i = 0; i < 8; ++i)
    values[i] = window.at(i & 1, i >> 1 & 1, i >> 2, kSolid, [&volume](int brick) { return volume.cut_of(brick); });
  const Vec3 f = x - Vec3(cell);
  // Both slices at once.
  const auto slices = [&](int i) { return Pair{static_cast<double>(values[i]), static_cast<double>(values[i + 4])}; };
  const Pair v0 = slices(0), v2 = slices(2);
  const Pair a = v0 + f.x * (slices(1) - v0), b = v2 + f.x * (slices(3) - v2);
  const Pair low = a + f.y * (b - a);
  return (kBandVoxels - (low[0] + f.z * (low[1] - low[0])) * (2.0 * kBandVoxels / 65535.0)) * voxel_mm_;
}

/// Adds those of the voxels beyond its faces to the ids of a cell's own voxels. Their number.
int SweptVoid::names_about(const Volume& volume, IVec3 cell, std::int32_t (&ids)[kNames]) const noexcept {
  const Window<4> window(volume.specimen(), cell - 1);
  int names = 8;
  for (int axis = 0; axis < 3; ++axis)
    for (const int beyond : {0, 3})
      for (int i = 0; i < 4; ++i) {
        IVec3 v(1);
        v[axis] = beyond;
        v[(axis + 1) % 3] += i & 1;
        v[(axis + 2) % 3] += i >> 1;
        const std::int32_t id = window.at(v.x, v.y, v.z, Volume::kNoSweep, sweeps_in(volume));
        if (id >= 0) ids[names++] = id;
      }
  return names;
}

/// The runs about ids, in order and apart. Their number.
int SweptVoid::collect(const std::int32_t* ids, int names, std::int32_t end, SweepRun (&run)[kNames]) const noexcept {
  std::int32_t apart[kNames];  // in order, each once: most voxels name what their neighbours name
  int different = 0;
  for (int i = 0; i < names; ++i) {
    int at = different;
    while (at > 0 && apart[at - 1] > ids[i]) --at;
    if (at > 0 && apart[at - 1] == ids[i]) continue;
    std::copy_backward(apart + at, apart + different, apart + different + 1);
    apart[at] = ids[i];
    ++different;
  }
  int count = 0;
  for (int i = 0; i < different; ++i) {
    const SweepRun about = sweeps_.about(apart[i], kBefore, std::clamp(end - 1 - apart[i], 0, kAfter));
    if (count > 0 && about.from <= run[count - 1].to)
      run[count - 1].to = std::max(run[count - 1].to, about.to);
    else
      run[count++] = about;
  }
  return count;
}

/// Leaves out sweeps that are too shallow at the cell's middle to own surface in it.
void SweptVoid::trim(const SweepRun* all, int count, SweptRuns& out) const noexcept {
  float squares[kNames * (kBefore + 1 + kAfter + kLanes)];
  float* square[kNames];
  const Vec3 middle = origin_mm_ + voxel_mm_ * (Vec3(out.cell) + 0.5);
  float* end = squares;
  double deepest = -1e300;
  for (int k = 0; k < count; ++k) {
    square[k] = end;
    const float least = sweeps_.distances2(all[k], middle, end);
    deepest = std::max(deepest, sweeps_.radius_mm(all[k].from) - std::sqrt(static_cast<double>(least)));
    end += (all[k].to - all[k].from + kLanes) / kLanes * kLanes;
  }
  const double least = deepest - 2.0 * kReach * voxel_mm_;
  for (int k = 0; k < count; ++k) {
    const double within = sweeps_.radius_mm(all[k].from) - least;
    const auto within2 = static_cast<float>(within * within);
    SweepRun owning{all[k].to + 1, all[k].from - 1};
    for (std::int32_t id = all[k].from; id <= all[k].to; ++id) {
      if (within <= 0.0 || square[k][id - all[k].from] > within2) continue;
      owning = {std::min(owning.from, id), id};
    }
    if (owning.to >= owning.from && out.count < SweptRuns::kMost) out.run[out.count++] = owning;
  }
}

const SweptRuns& SweptVoid::runs_at(const Volume& volume, Vec3 p, std::int32_t end) noexcept {
  const IVec3 cell = cell_of_voxels((p - origin_mm_) / voxel_mm_);
  SweptRuns& out = cells_[place_of(cell)];
  // Runs reach kAfter beyond what a voxel names, if that is carved.
  if (cell == out.cell && out.end >= 0 && (end == out.end || out.newest + kAfter < std::min(end, out.end))) return out;
  out.cell = cell;
  out.end = end;
  make(volume, out);
  return out;
}

int SweptVoid::near(const Volume& volume, Vec3 p, std::int32_t end, SweepRun (&run)[8]) const noexcept {
  std::int32_t ids[8];
  sweeps_of_cell(volume, cell_of_voxels((p - origin_mm_) / voxel_mm_), ids);
  int count = 0;
  for (const std::int32_t id : ids) {
    bool held = id < 0;
    for (int k = 0; k < count; ++k) held = held || (id >= run[k].from && id <= run[k].to);
    if (!held) run[count++] = sweeps_.about(id, kBefore, std::clamp(end - 1 - id, 0, kAfter));
  }
  return count;
}

void SweptVoid::make(const Volume& volume, SweptRuns& out) const noexcept {
  const IVec3 cell = out.cell;
  out.count = 0;
  out.known = out.near_base = false;
  out.newest = -1 - kAfter;
  std::int32_t ids[8];
  if (!sweeps_of_cell(volume, cell, ids)) return;
  const Specimen& specimen = volume.specimen();
  const int brick = specimen.brick_index({cell.x >> 3, cell.y >> 3, cell.z >> 3});
  const bool solid = (cell.x & 7) < 7 && (cell.y & 7) < 7 && (cell.z & 7) < 7 && specimen.s_of(brick) == nullptr;
  std::uint16_t least = kSolid, most = 0;
  for (int i = 0; i < (solid ? 1 : 8); ++i) {
    const std::uint16_t s = specimen.s(cell + IVec3(i & 1, i >> 1 & 1, i >> 2));
    least = std::min(least, s);
    most = std::max(most, s);
  }
  if (most < kAir) return;
  out.near_base = least < kDeep;
  out.known = true;
  std::int32_t named[kNames];
  std::copy(ids, ids + 8, named);
  SweepRun run[kNames];
  const int names = names_about(volume, cell, named);
  out.newest = *std::max_element(named, named + names);
  trim(run, collect(named, names, out.end, run), out);
}

}  // namespace cusp::engine
