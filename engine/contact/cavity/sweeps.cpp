#include "engine/contact/cavity/sweeps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/volume/volume.h"

namespace cusp::engine {

namespace {
constexpr std::size_t kEntryBytes = 3 * 4 + 1;  // a place as saved
constexpr double kNoWayMm = 1e-12;             // a place so near to a way has no direction to it
constexpr float kRoundedMm = 1e-4f;           // far more than floats round a depth by, of places up to 100 mm from the middle
constexpr float kBeyond = 1e30f;              // mm², further than any sweep
constexpr double kMostRadiusMm = 100.0;       // of a kept sweep: no bur is as wide
constexpr std::int32_t kLast = std::numeric_limits<std::int32_t>::max();  // after every id

/// Calls visit(id) for every id that a voxel keeps.
template <class Visit>
void for_each_name(Volume& volume, Visit&& visit) noexcept {
  for (const std::int32_t brick : volume.cut_bricks()) {
    std::int32_t* ids = volume.sweeps_for_writing(brick);
    if (ids == nullptr) continue;
    for (int o = 0; o < kBrickVoxels; ++o)
      if (ids[o] != Volume::kNoSweep) visit(ids[o]);
  }
}
}  // namespace

Sweeps::Sweeps(Vec3 middle, std::size_t room) : middle_(middle), room_(room) {
  // Four lanes read up to four places beyond a run.
  for (std::vector<float>* axis : {&x_, &y_, &z_}) axis->assign(room + 8, 0.0f);
  by_.assign(room + 8, 0);
  marks_.assign(room / 64 + 1, 0);
  before_.assign(room / 64 + 1, 0);
  radii_.reserve(kMostRadii);
}

std::uint8_t Sweeps::number_of(double radius_mm) noexcept {
  for (std::size_t i = 0; i < radii_.size(); ++i)
    if (radii_[i] == radius_mm) return static_cast<std::uint8_t>(i);
  if (radii_.size() == kMostRadii) return kGap;
  radii_.push_back(radius_mm);
  return static_cast<std::uint8_t>(radii_.size() - 1);
}

std::int32_t Sweeps::add(Vec3 from, Vec3 to, double radius_mm) noexcept {
  const std::uint8_t by = number_of(radius_mm);
  if (by == kGap) return kNone;
  const Vec3f start(from - middle_), end(to - middle_);
  const auto end_at = static_cast<std::size_t>(count_);
  const bool goes_on = open_ && count_ > 0 && by_[end_at - 1] == by && start == Vec3f(x_[end_at], y_[end_at], z_[end_at]);
  if (goes_on && !sealed_) {
    const Sweep last = (*this)[count_ - 1];
    const Sweep longer{last.a, Vec3(end) + middle_, radius_mm};
    const Vec3 off = longer.nearest_on(last.b) - last.b, way = longer.b - longer.a;
    if (glm::dot(way, way) <= kLongestMm * kLongestMm && glm::dot(off, off) <= kStraightMm * kStraightMm) {
      put(end_at, end, by);
      return count_ - 1;
    }
  }
  if (end_at + 2 >= room_) return kNone;
  if (!goes_on) {
    if (count_ > 0) by_[static_cast<std::size_t>(count_++)] = kGap;
    put(static_cast<std::size_t>(count_), start, by);
  }
  by_[static_cast<std::size_t>(count_)] = by;
  ++count_;
  put(static_cast<std::size_t>(count_), end, by);
  open_ = true;
  sealed_ = false;
  settle();
  return count_ - 1;
}

bool Sweeps::wants_room() const noexcept {
  return room_ > 0 && static_cast<std::size_t>(count_) >= room_ / 8 * 7;
}

/// Marks kBeside sweeps to each side of the marked ones, up to the ends of their ways.
void Sweeps::widen_marks() noexcept {
  int more = 0;
  std::uint8_t way = kGap;
  const auto visit = [&](std::int32_t id) {
    const std::uint8_t by = by_[static_cast<std::size_t>(id)];
    if (by != way) more = 0;
    way = by;
    if (marked(id)) {
      more = kBeside;
    } else if (by != kGap && more > 0) {
      --more;
      mark(id);
    }
  };
  for (std::int32_t id = 0; id < count_; ++id) visit(id);
  // What the first pass marked lies behind a marked sweep, so before it nothing more is marked than before that one.
  more = 0;
  way = kGap;
  for (std::int32_t id = count_ - 1; id >= 0; --id) visit(id);
}

void Sweeps::drop_unmarked() noexcept {
  widen_marks();
  std::int32_t left = 0;  // never beyond id: a run of kept sweeps takes one place more than it has, and so it did before
  for (std::int32_t id = 0; id < count_; ++id) {
    const auto i = static_cast<std::size_t>(id);
    if (id % 64 == 0) before_[i / 64] = left > 0 ? left + 1 : 0;
    if (!marked(id)) continue;
    const Vec3f from(x_[i], y_[i], z_[i]), to(x_[i + 1], y_[i + 1], z_[i + 1]);
    const std::uint8_t by = by_[i];
    if (left > 0 && !marked(id - 1)) by_[static_cast<std::size_t>(left++)] = kGap;
    put(static_cast<std::size_t>(left++), from, by);
    put(static_cast<std::size_t>(left), to, by);
  }
  count_ = left;
  open_ = sealed_ = false;
  settled_ = Hash64();
  hashed_ = 0;
  settle();
}

std::int32_t Sweeps::renumbered(std::int32_t id) const noexcept {
  const auto word = static_cast<std::size_t>(id) / 64;
  const std::uint64_t kept = marks_[word], bit = std::uint64_t{1} << (id % 64);
  const std::uint64_t last = word > 0 ? marks_[word - 1] >> 63 : 0;
  const std::uint64_t first_of_run = kept & ~(kept << 1 | last);
  return before_[word] + std::popcount(kept & (bit - 1)) + std::popcount(first_of_run & (bit | (bit - 1))) - 1;
}

SweepRun Sweeps::about(std::int32_t id, int before, int after) const noexcept {
  const std::uint8_t by = by_[static_cast<std::size_t>(id)];
  SweepRun run{id, id};
  while (run.from > 0 && id - run.from < before && by_[static_cast<std::size_t>(run.from) - 1] == by) --run.from;
  while (run.to + 1 < count_ && run.to - id < after && by_[static_cast<std::size_t>(run.to) + 1] == by) ++run.to;
  return run;
}

/// Squared distances of q, seen from the middle, to the ways of four sweeps from i on. The last ones may be beyond the run.
inline Lanes Sweeps::four_distances2(Vec3f q, std::int32_t i) const noexcept {
  const auto load = [](const std::vector<float>& from, std::int32_t at) { return load_lanes(&from[static_cast<std::size_t>(at)]); };
  const Lanes ax = load(x_, i), ay = load(y_, i), az = load(z_, i);
  const Lanes wx = load(x_, i + 1) - ax, wy = load(y_, i + 1) - ay, wz = load(z_, i + 1) - az;
  const Lanes px = q.x - ax, py = q.y - ay, pz = q.z - az;
  Lanes t = (px * wx + py * wy + pz * wz) / (wx * wx + wy * wy + wz * wz + 1e-20f);
  t = most_of(least_of(t, all_lanes(1.0f)), Lanes{});
  const Lanes dx = px - t * wx, dy = py - t * wy, dz = pz - t * wz;
  return dx * dx + dy * dy + dz * dz;
}

/// The sweep of a run that comes nearest to q; d2: its squared distance.
std::int32_t Sweeps::nearest_of(SweepRun run, Vec3f q, float& d2) const noexcept {
  Lanes least = all_lanes(kBeyond);
  LaneMask where{0, 0, 0, 0}, index = LaneMask{0, 1, 2, 3} + run.from;
  const auto take = [&](Lanes distances2) {
    where = distances2 < least ? index : where;
    least = least_of(distances2, least);
    index += kLanes;
  };
  std::int32_t i = run.from;
  for (; i + kLanes - 1 <= run.to; i += kLanes) take(four_distances2(q, i));
  if (i <= run.to) take(index <= run.to ? four_distances2(q, i) : all_lanes(kBeyond));
  d2 = least_lane(least);
  // Of equals the first sweep. Selected and not branched on: which lane it is cannot be predicted.
  where = least == all_lanes(d2) ? where : LaneMask{} + kLast;
  return std::min(std::min(where[0], where[1]), std::min(where[2], where[3]));
}

Sweeps::Nearest Sweeps::nearest(SweepRun run, Vec3 p) const noexcept {
  float d2;
  const std::int32_t sweep = nearest_of(run, Vec3f(p - middle_), d2);
  const Vec3 off = (*this)[sweep].nearest_on(p) - p;
  return {sweep, std::sqrt(glm::dot(off, off))};
}

float Sweeps::distances2(SweepRun run, Vec3 p, float* out) const noexcept {
  const Vec3f q(p - middle_);
  Lanes least = all_lanes(kBeyond);
  for (std::int32_t i = run.from; i <= run.to; i += kLanes, out += kLanes) {
    const Lanes d2 = four_distances2(q, i);
    __builtin_memcpy(out, &d2, sizeof d2);
    const LaneMask index = LaneMask{0, 1, 2, 3} + i;
    least = ((index <= run.to) & (d2 < least)) ? d2 : least;
  }
  return least_lane(least);
}

/// How deep p lies in one sweep.
inline Sweeps::Deepest Sweeps::in_sweep(std::int32_t id, Vec3 p) const noexcept {
  Deepest out;
  const Sweep sweep = (*this)[id];
  out.sweep = id;
  out.on = sweep.nearest_on(p);
  const Vec3 off = out.on - p;
  const double distance = std::sqrt(glm::dot(off, off));
  out.depth_mm = sweep.radius_mm - distance;
  if (distance > kNoWayMm) out.inwards = off / distance;
  return out;
}

/// in_sweep() of two sweeps, element by element.
inline void Sweeps::in_two_sweeps(const std::int32_t (&id)[2], Vec3 p, Deepest* out) const noexcept {
  const auto i = static_cast<std::size_t>(id[0]), j = static_cast<std::size_t>(id[1]);
  const auto place_of = [&](const std::vector<float>& axis, std::size_t after, double middle) {
    return Pair{static_cast<double>(axis[i + after]), static_cast<double>(axis[j + after])} + middle;
  };
  const Pair ax = place_of(x_, 0, middle_.x), ay = place_of(y_, 0, middle_.y), az = place_of(z_, 0, middle_.z);
  const Pair wx = place_of(x_, 1, middle_.x) - ax, wy = place_of(y_, 1, middle_.y) - ay, wz = place_of(z_, 1, middle_.z) - az;
  const Pair square = wx * wx + wy * wy + wz * wz;
  Pair t = ((p.x - ax) * wx + (p.y - ay) * wy + (p.z - az) * wz) / square;
  t = square > 0.0 ? t : Pair{};
  t = t < 0.0 ? Pair{} : t;
  t = t > 1.0 ? both(1.0) : t;
  const Pair x = ax + wx * t, y = ay + wy * t, z = az + wz * t;
  const Pair ox = x - p.x, oy = y - p.y, oz = z - p.z;
  const Pair distance = sqrt_of(ox * ox + oy * oy + oz * oz);
  const Pair nx = ox / distance, ny = oy / distance, nz = oz / distance;
  for (int k = 0; k < 2; ++k) {
    out[k] = {id[k], Vec3(x[k], y[k], z[k]), Vec3(0.0), radius_mm(id[k]) - distance[k]};
    if (distance[k] > kNoWayMm) out[k].inwards = Vec3(nx[k], ny[k], nz[k]);
  }
}

Sweeps::Deepest Sweeps::deepest(SweepRun run, Vec3 p) const noexcept {
  float d2;
  return in_sweep(nearest_of(run, Vec3f(p - middle_), d2), p);
}

Sweeps::Deepest Sweeps::deepest(std::span<const SweepRun> runs, Vec3 p) const noexcept {
  const Vec3f q(p - middle_);
  double most = -1e300;
  std::int32_t deepest = kNone;
  for (const SweepRun& run : runs) {
    float d2;
    const std::int32_t sweep = nearest_of(run, q, d2);
    const double depth = radius_mm(sweep) - std::sqrt(static_cast<double>(d2));
    if (depth <= most) continue;
    most = depth;
    deepest = sweep;
  }
  return deepest == kNone ? Deepest{} : in_sweep(deepest, p);
}

int Sweeps::deepest_each(std::span<const SweepRun> runs, Vec3 p, double within_mm, Deepest* out) const noexcept {
  const Vec3f q(p - middle_);
  std::int32_t id[kMostRuns];
  float depth[kMostRuns];
  float deepest = -kBeyond;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    float d2;
    id[k] = nearest_of(runs[k], q, d2);
    depth[k] = static_cast<float>(radius_mm(id[k])) - std::sqrt(d2);
    deepest = std::max(deepest, depth[k]);
  }
  const float least = deepest - static_cast<float>(within_mm) - kRoundedMm;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    id[kept] = id[k];
    kept += depth[k] >= least;
  }
  std::size_t k = 0;
  for (; k + 2 <= kept; k += 2) in_two_sweeps({id[k], id[k + 1]}, p, out + k);
  if (k < kept) out[k] = in_sweep(id[k], p);
  return static_cast<int>(kept);
}

bool Sweeps::holds(SweepRun run, Vec3 p, double tolerance_mm) const noexcept {
  const Vec3f q(p - middle_);
  const double within = radius_mm(run.from) - tolerance_mm;
  const auto within2 = static_cast<float>(within * within);
  for (std::int32_t i = run.from; i <= run.to; i += kLanes) {
    const LaneMask index = LaneMask{0, 1, 2, 3} + i;
    if (bits_of((four_distances2(q, i) < within2) & (index <= run.to)) != 0) return true;
  }
  return false;
}

void Sweeps::add_to(Hash64& hash, std::size_t i) const noexcept {
  hash.add(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(x_[i])) << 32 | std::bit_cast<std::uint32_t>(y_[i]));
  hash.add(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(z_[i])) << 32 | by_[i]);
}

std::uint64_t Sweeps::hash() const noexcept {
  Hash64 out = settled_;
  const std::size_t places = count_ == 0 ? 0 : static_cast<std::size_t>(count_) + 1;
  for (std::size_t i = hashed_; i < places; ++i) add_to(out, i);
  for (const double radius : radii_) out.add_double(radius);
  out.add((open_ ? 1 : 0) | (sealed_ ? 2 : 0));
  return out.value();
}

std::vector<std::byte> Sweeps::save() const {
  std::vector<std::byte> out;
  const auto put = [&out](std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::byte>(value >> (8 * i)));
  };
  const std::size_t places = count_ == 0 ? 0 : static_cast<std::size_t>(count_) + 1;
  out.reserve(6 + 8 * radii_.size() + kEntryBytes * places);
  put((open_ ? 1 : 0) | (sealed_ ? 2 : 0), 1);
  put(radii_.size(), 1);
  for (const double radius : radii_) put(std::bit_cast<std::uint64_t>(radius), 8);
  put(places, 4);
  for (std::size_t i = 0; i < places; ++i) {
    for (const float value : {x_[i], y_[i], z_[i]}) put(std::bit_cast<std::uint32_t>(value), 4);
    put(by_[i], 1);
  }
  return out;
}

bool Sweeps::load(std::span<const std::byte> bytes) {
  std::size_t at = 0;
  const auto left = [&] { return bytes.size() - at; };
  const auto get = [&](int n) {
    std::uint64_t value = 0;
    for (int i = 0; i < n; ++i) value |= static_cast<std::uint64_t>(bytes[at++]) << (8 * i);
    return value;
  };
  count_ = 0;
  open_ = sealed_ = false;
  radii_.clear();
  settled_ = Hash64();
  hashed_ = 0;
  if (left() < 2) return false;
  const std::uint64_t open = get(1), radii = get(1);
  if (open > 3 || radii > kMostRadii || left() < 8 * radii + 4) return false;
  for (std::uint64_t i = 0; i < radii; ++i) {
    radii_.push_back(std::bit_cast<double>(get(8)));
    if (!(radii_.back() > 0.0 && radii_.back() < kMostRadiusMm)) return false;
  }
  const std::size_t places = get(4);
  if (places == 1 || places > room_ || left() != kEntryBytes * places) return false;
  for (std::size_t i = 0; i < places; ++i) {
    Vec3f p(0.0f);
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::bit_cast<float>(static_cast<std::uint32_t>(get(4)));
    const auto by = static_cast<std::uint8_t>(get(1));
    if (!(glm::dot(p, p) < 1e12f) || (by != kGap && by >= radii)) return false;
    put(i, p, by);
  }
  count_ = places == 0 ? 0 : static_cast<std::int32_t>(places) - 1;
  open_ = (open & 1) != 0;
  sealed_ = (open & 2) != 0;
  settle();
  return true;
}

/// The newest sweep's end may still move: all places before it are settled.
void Sweeps::settle() noexcept {
  for (; hashed_ + 1 < static_cast<std::size_t>(count_); ++hashed_) add_to(settled_, hashed_);
}

bool make_room(Sweeps& sweeps, Volume& volume) noexcept {
  if (!sweeps.wants_room()) return false;
  sweeps.clear_marks();
  for_each_name(volume, [&](std::int32_t id) { sweeps.mark(id); });
  sweeps.drop_unmarked();
  for_each_name(volume, [&](std::int32_t& id) { id = sweeps.renumbered(id); });
  return true;
}

}  // namespace cusp::engine
