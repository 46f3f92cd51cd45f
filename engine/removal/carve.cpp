#include "engine/removal/carve.h"

#include <algorithm>
#include <cmath>

#include "engine/base/lanes.h"

namespace cusp::engine {

namespace {

constexpr double kRounding = 1e-4;      // voxels: more than a cut value's quantum
constexpr double kHalfDiagonal = 6.07;  // voxels from a brick's middle to its farthest voxel, and a little more

/// A ball's sweep in voxels, four voxels of a row at a time. Single precision: 2e-6 of a voxel, a fortieth of a quantum.
class BallSweep {
 public:
  BallSweep() = default;
  BallSweep(const Grid& grid, Vec3 a, Vec3 b, double radius_mm, std::int32_t of = Volume::kNoSweep) noexcept
      : id(of), p_((a - grid.origin_mm) / grid.voxel_mm), r_(radius_mm / grid.voxel_mm), far_(r_ + kBandVoxels) {
    along_ = (b - a) / grid.voxel_mm;
    const double square = glm::dot(along_, along_);
    inverse_ = square > 1e-24 ? 1.0 / square : 0.0;
    const Vec3 q = p_ + along_;
    low = glm::max(IVec3(glm::floor(glm::min(p_, q) - far_)), IVec3(0));
    high = glm::min(IVec3(glm::ceil(glm::max(p_, q) + far_)), grid.size - 1);
  }

  double distance2(Vec3 voxel) const noexcept {
    const Vec3 v = voxel - p_;
    double t = glm::dot(v, along_) * inverse_;
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    const Vec3 d = v - along_ * t;
    return glm::dot(d, d);
  }
  bool reaches_brick(IVec3 corner) const noexcept {
    const double reach = far_ + kHalfDiagonal;
    return distance2(Vec3(corner) + 3.5) <= reach * reach;
  }
  std::int32_t id = Volume::kNoSweep;
  /// Of the middle of a brick's row of voxels, half a row from its ends: one further is not lowered.
  double row_reach() const noexcept { return far_ + 3.6; }
  Vec3 begin() const noexcept { return p_; }
  Vec3 end() const noexcept { return p_ + along_; }
  /// The way as seen from a brick's first voxel.
  struct Way {
    Vec3f from{0.0f}, along{0.0f};
    float inverse = 0.0f;
    /// Squared distances of four voxels from `first` on along x.
    Lanes distances2(Vec3f first) const noexcept {
      const Vec3f v = first - from;
      const Lanes x = v.x + Lanes{0.0f, 1.0f, 2.0f, 3.0f};
      Lanes t = (x * along.x + (v.y * along.y + v.z * along.z)) * inverse;
      t = most_of(least_of(t, all_lanes(1.0f)), Lanes{});
      const Lanes dx = x - along.x * t, dy = v.y - along.y * t, dz = v.z - along.z * t;
      return dx * dx + dy * dy + dz * dz;
    }
  };
  Way way_from(IVec3 corner) const noexcept { return {Vec3f(p_ - Vec3(corner)), Vec3f(along_), static_cast<float>(inverse_)}; }
  /// Cut values at distances from the way, voxels.
  LaneMask solid_at(Lanes distances) const noexcept { return solid_from_distances(distances - static_cast<float>(r_)); }

  IVec3 low{0}, high{0};  // voxels within the band, inclusive

 private:
  Vec3 p_{0.0}, along_{0.0};
  double r_ = 0.0, far_ = 0.0, inverse_ = 0.0;
};

/// Some sweeps of one ball that follow each other and are carved together.
struct BallSweeps {
  BallSweep sweep[kMostAtOnce];
  int count = 0;
  IVec3 low{0}, high{0};
  BallSweep chord;    // from where they begin to where they end
  double bend = 0.0;  // voxels: none of them goes further from the chord
  void add(const BallSweep& one) noexcept {
    low = count == 0 ? one.low : glm::min(low, one.low);
    high = count == 0 ? one.high : glm::max(high, one.high);
    sweep[count++] = one;
  }
  /// After the last add().
  void close(const Grid& grid, Vec3 a, Vec3 b, double radius_mm) noexcept {
    chord = BallSweep(grid, a, b, radius_mm);
    double bend2 = 0.0;
    for (int k = 0; k < count; ++k) bend2 = std::max({bend2, chord.distance2(sweep[k].begin()), chord.distance2(sweep[k].end())});
    bend = std::sqrt(bend2);
  }
};

/// Lowers the voxels of a brick to what is swept. False if the volume has no room.
bool carve_brick(Volume& volume, const BallSweeps& all, int brick, IVec3 corner, ChangedVoxels& changed) noexcept {
  const IVec3 from = glm::max(all.low - corner, IVec3(0));
  const IVec3 to = glm::min(all.high - corner, IVec3(7));
  const unsigned meant = (0xffu << from.x) & (0xffu >> (7 - to.x));  // of a row, voxels within low..high
  const double reach = all.chord.row_reach() + all.bend;
  BallSweep::Way way[kMostAtOnce];
  for (int k = 0; k < all.count; ++k) way[k] = all.sweep[k].way_from(corner);
  const BallSweep::Way chord = all.chord.way_from(corner);
  const auto closer = static_cast<float>(all.bend + kRounding);
  const std::uint16_t* known = volume.cut_of(brick);
  std::uint16_t* values = nullptr;
  std::int32_t* ids = nullptr;
  for (int z = from.z; z <= to.z; ++z)
    for (int y = from.y; y <= to.y; ++y) {
      if (all.chord.distance2(Vec3(corner + IVec3(0, y, z)) + Vec3(3.5, 0.0, 0.0)) > reach * reach) continue;
      for (int x = from.x & 4; x <= to.x; x += kLanes) {
        const int o = brick_offset(x, y, z);
        std::uint64_t four = ~std::uint64_t{0};
        if (known != nullptr) __builtin_memcpy(&four, known + o, sizeof four);
        if (four == 0) continue;
        const LaneMask before = from_memory(four);
        const Vec3f first(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
        // No sweep is nearer than their chord, less their bend.
        if (all.count > 1) {
          const Lanes least = most_of(sqrt_of(chord.distances2(first)) - closer, Lanes{});
          if ((bits_of(all.chord.solid_at(least) < before) & meant >> x) == 0) continue;
        }
        Lanes nearest = way[0].distances2(first);
        LaneMask by = LaneMask{} + all.sweep[0].id;
        for (int k = 1; k < all.count; ++k) {
          const Lanes square = way[k].distances2(first);
          const LaneMask nearer = square < nearest;
          nearest = nearer ? square : nearest;
          by = nearer ? (LaneMask{} + all.sweep[k].id) : by;
        }
        const LaneMask now = all.sweep[0].solid_at(sqrt_of(nearest));
        const unsigned less = bits_of(now < before) & meant >> x;
        if (less == 0) continue;
        if (values == nullptr) {
          values = volume.cut_for_writing(brick);
          if (values == nullptr) return false;
          ids = volume.sweeps_for_writing(brick);
          known = values;
        }
        for (int i = 0; i < kLanes; ++i) {
          if ((less >> i & 1u) == 0) continue;
          values[o + i] = static_cast<std::uint16_t>(now[i]);
          if (ids != nullptr) ids[o + i] = by[i];
        }
        changed.add_row(y, z, less << x);
      }
    }
  return true;
}

Carved carve(Volume& volume, const BallSweeps& all) noexcept {
  Carved out;
  for_bricks_within(all.low, all.high, [&](IVec3 at) {
    const int brick = volume.specimen().brick_index(at);
    const IVec3 corner = at * kBrickEdge;
    if (brick < 0 || !volume.cuttable(brick)) return;
    bool reaches = false;
    for (int k = 0; k < all.count && !reaches; ++k) reaches = all.sweep[k].reaches_brick(corner);
    if (!reaches) return;
    ChangedVoxels changed;
    if (!carve_brick(volume, all, brick, corner, changed)) out.overflow = true;
    if (!changed.close(corner)) return;
    volume.touched(brick);
    out.add(changed);
  });
  return out;
}

}  // namespace

Carved carve_sweep(Volume& volume, Vec3 a, Vec3 b, double radius_mm) noexcept {
  BallSweeps all;
  all.add(BallSweep(volume.grid(), a, b, radius_mm));
  all.close(volume.grid(), a, b, radius_mm);
  return carve(volume, all);
}

Carved carve_run(Volume& volume, const Sweeps& sweeps, SweepRun run) noexcept {
  BallSweeps all;
  for (std::int32_t id = run.from; id <= run.to && all.count < kMostAtOnce; ++id) {
    const Sweep sweep = sweeps[id];
    all.add(BallSweep(volume.grid(), sweep.a, sweep.b, sweep.radius_mm, id));
  }
  all.close(volume.grid(), sweeps[run.from].a, sweeps[run.from + all.count - 1].b, sweeps[run.from].radius_mm);
  return carve(volume, all);
}

}  // namespace cusp::engine
