/// The ways of all balls that have cut: one store of straight sweeps in the order of time. Each voxel near a cut keeps the id
/// of its nearest sweep (Volume::sweeps_of). make_room() forgets what owns no wall. What is cut once the store is full has no id.
/// Frame: specimen, mm. Thread: haptic. Wait-free; the constructor takes all memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/lanes.h"
#include "engine/base/vec.h"
#include "engine/volume/hash.h"

namespace cusp::engine {

class Volume;

/// A ball that moved from a to b.
struct Sweep {
  Vec3 a{0.0}, b{0.0};
  double radius_mm = 0.0;
  /// The place of its way that is nearest to p.
  Vec3 nearest_on(Vec3 p) const noexcept {
    const Vec3 way = b - a;
    const double square = glm::dot(way, way);
    double t = square > 0.0 ? glm::dot(p - a, way) / square : 0.0;
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    return a + way * t;
  }
};

/// Sweeps that follow each other without a gap, by ids; both ends belong to it.
struct SweepRun {
  std::int32_t from = 0, to = -1;
};

class Sweeps {
 public:
  static constexpr std::int32_t kNone = -1;
  static constexpr std::size_t kMost = std::size_t{1} << 20;  // a hand makes 150 to 660 a second of cutting
  static constexpr double kStraightMm = 5e-5;  // a way is lengthened while it stays straight to this
  static constexpr double kLongestMm = 0.1;

  /// middle: places are kept as floats relative to it, so within 8 mm to 0.5 nm.
  /// room: sweeps at most.
  Sweeps(Vec3 middle, std::size_t room);

  /// A ball has cut from `from` to `to`. Lengthens the newest sweep, or begins another. Returns its id, or kNone if full.
  std::int32_t add(Vec3 from, Vec3 to, double radius_mm) noexcept;
  /// The next add() begins another way.
  void break_path() noexcept { open_ = false; }
  /// The newest sweep is not lengthened any more. The way goes on.
  void seal() noexcept { sealed_ = true; }

  std::int32_t size() const noexcept { return count_; }
  Sweep operator[](std::int32_t id) const noexcept {
    const auto i = static_cast<std::size_t>(id);
    return {place(i), place(i + 1), radius_mm(id)};
  }
  double radius_mm(std::int32_t id) const noexcept { return radii_[by_[static_cast<std::size_t>(id)]]; }
  /// An id of the gap between two ways is no sweep.
  bool gap(std::int32_t id) const noexcept { return by_[static_cast<std::size_t>(id)] == kGap; }

  /// True if seven eighths of the store are used: the rest takes a stroke of 200 s at 660 sweeps a second.
  bool wants_room() const noexcept;
  void clear_marks() noexcept { std::ranges::fill(marks_, 0); }
  /// drop_unmarked() keeps this sweep, and kBeside to each side of it along its way.
  void mark(std::int32_t id) noexcept { marks_[static_cast<std::size_t>(id) / 64] |= std::uint64_t{1} << (id % 64); }
  static constexpr int kBeside = 16;  // CavityWalls looks so far along a way; tests/engine/step/state.cpp compares answers
  /// Forgets the others. The next add() begins another way.
  void drop_unmarked() noexcept;
  /// What the id of a kept sweep has become. Valid until clear_marks().
  std::int32_t renumbered(std::int32_t id) const noexcept;

  /// The run of at most so many sweeps before and after one.
  SweepRun about(std::int32_t id, int before, int after) const noexcept;

  struct Nearest {
    std::int32_t sweep = kNone;
    double distance_mm = 0.0;
  };
  /// The sweep of a run that comes nearest to p. Pre: the run is not empty.
  Nearest nearest(SweepRun run, Vec3 p) const noexcept;
  struct Deepest {
    std::int32_t sweep = kNone;
    Vec3 on{0.0};             // of its way
    Vec3 inwards{0.0};        // unit, to there; 0 on the way itself
    double depth_mm = -1e300; // negative in what is left
  };
  /// How deep p lies in what a run, or runs, have swept. Pre: no run is empty.
  Deepest deepest(SweepRun run, Vec3 p) const noexcept;
  Deepest deepest(std::span<const SweepRun> runs, Vec3 p) const noexcept;
  static constexpr std::size_t kMostRuns = 20;
  /// The same of each run apart, in order, but for those that p lies less deep in than in the deepest, by within_mm and some
  /// micrometres at least. How many; out holds as many as there are runs, at most kMostRuns.
  int deepest_each(std::span<const SweepRun> runs, Vec3 p, double within_mm, Deepest* out) const noexcept;
  /// Squared distances of p to the ways of a run's sweeps, in order, four at a time; the least of them.
  float distances2(SweepRun run, Vec3 p, float* out) const noexcept;
  /// True if a run holds p deeper than tolerance_mm.
  bool holds(SweepRun run, Vec3 p, double tolerance_mm) const noexcept;

  /// Of all that save() keeps, kept up with each add().
  std::uint64_t hash() const noexcept;
  /// Little-endian: whether the way goes on, and in another sweep; radii, places.
  std::vector<std::byte> save() const;
  /// False, and empty, if the bytes are no store or one with more than the room.
  bool load(std::span<const std::byte> bytes);

 private:
  static constexpr std::size_t kMostRadii = 64;
  static constexpr std::uint8_t kGap = 255;

  Lanes four_distances2(Vec3f q, std::int32_t i) const noexcept;
  std::int32_t nearest_of(SweepRun run, Vec3f q, float& d2) const noexcept;
  Deepest in_sweep(std::int32_t id, Vec3 p) const noexcept;
  void in_two_sweeps(const std::int32_t (&id)[2], Vec3 p, Deepest* out) const noexcept;
  Vec3 place(std::size_t i) const noexcept { return Vec3(x_[i], y_[i], z_[i]) + middle_; }
  void put(std::size_t i, Vec3f p, std::uint8_t by) noexcept {
    x_[i] = p.x;
    y_[i] = p.y;
    z_[i] = p.z;
    by_[i] = by;
  }
  bool marked(std::int32_t id) const noexcept { return (marks_[static_cast<std::size_t>(id) / 64] >> (id % 64) & 1) != 0; }
  void widen_marks() noexcept;
  void settle() noexcept;
  void add_to(Hash64& hash, std::size_t i) const noexcept;
  std::uint8_t number_of(double radius_mm) noexcept;

  Vec3 middle_;
  std::vector<float> x_, y_, z_;    // [id]: where a sweep begins, and the one before it ends
  std::vector<std::uint8_t> by_;    // [id]: number of its radius, or kGap
  std::vector<double> radii_;
  std::size_t room_;
  std::int32_t count_ = 0;          // sweeps and gaps
  std::vector<std::uint64_t> marks_;     // [id / 64], a bit each
  std::vector<std::int32_t> before_;     // [id / 64]: sweeps kept before these, and their runs
  Hash64 settled_;                  // of all entries that no add() changes any more
  std::size_t hashed_ = 0;          // how many those are
  bool open_ = false;               // the way goes on
  bool sealed_ = false;             // but in another sweep
};

/// Forgets the sweeps that no voxel names, but for Sweeps::kBeside beside a named one, if the store wants room. True if it did:
/// ids have changed, in the volume and for whoever keeps one. Some milliseconds for a full store, so the step calls it while the
/// bur touches nothing.
bool make_room(Sweeps& sweeps, Volume& volume) noexcept;

}  // namespace cusp::engine
