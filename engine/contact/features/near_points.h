/// Which of many points lie within reach of a place, four at a time. Places in voxels, single precision: what passes is
/// asked again exactly by whoever needs it, so `reach` should carry a thousandth of a voxel more than is meant.
/// Wait-free. Thread: any.
#pragma once

#include <bit>
#include <cstdint>

#include "engine/base/lanes.h"
#include "engine/base/vec.h"

namespace cusp::engine {

/// A vector, spread over all lanes.
struct VecLanes {
  VecLanes() = default;
  explicit VecLanes(Vec3f v) noexcept : x(all_lanes(v.x)), y(all_lanes(v.y)), z(all_lanes(v.z)) {}
  Lanes x{}, y{}, z{};
};

/// Places that are tested before the first of them is visited: visits between the tests would take their registers.
inline constexpr int kHitBlock = 64;

/// Calls visit(i) in rising order for each hit i < count. four(i): one bit for each of the four places from i on;
/// it is asked for up to seven places beyond count.
template <class Four, class Visit>
inline void for_hits(int count, Four&& four, Visit&& visit) noexcept {
  for (int first = 0; first < count; first += kHitBlock) {
    const int here = count - first < kHitBlock ? count - first : kHitBlock;
    std::uint64_t hits = 0;
    for (int i = 0; i < here; i += 2 * kLanes)
      hits |= static_cast<std::uint64_t>(four(first + i) | four(first + i + kLanes) << kLanes) << i;
    if (here < kHitBlock) hits &= (std::uint64_t{1} << here) - 1;
    for (; hits != 0; hits &= hits - 1) visit(first + std::countr_zero(hits));
  }
}

/// Calls visit(i) in rising order for each i < count with |(x,y,z)[i] - centre|^2 <= reach2. Seven floats beyond
/// count must be readable.
template <class Visit>
inline void for_near(const float* x, const float* y, const float* z, int count, Vec3f centre, float reach2,
                     Visit&& visit) noexcept {
  const VecLanes at(centre);
  for_hits(count, [&](int i) {
    const Lanes dx = load_lanes(x + i) - at.x, dy = load_lanes(y + i) - at.y, dz = load_lanes(z + i) - at.z;
    return bits_of(dx * dx + dy * dy + dz * dz <= reach2);
  }, visit);
}

/// Two coaxial cylinders, the wider one from `wide_from` on; both from `from` upwards. In the points' own frame.
struct TwoCylinders {
  Vec3f at{0.0f}, axis{0.0f};
  float from = 0.0f, wide_from = 0.0f, to = 0.0f;
  float narrow2 = 0.0f, wide2 = 0.0f;  // squared radii
};

/// The same, spread over all lanes: a page of eight points is too short to spread them for it alone.
struct CylinderLanes {
  explicit CylinderLanes(const TwoCylinders& c) noexcept
      : at(c.at), axis(c.axis), from(all_lanes(c.from)), wide_from(all_lanes(c.wide_from)), to(all_lanes(c.to)),
        narrow2(all_lanes(c.narrow2)), wide2(all_lanes(c.wide2)) {}
  VecLanes at, axis;
  Lanes from, wide_from, to, narrow2, wide2;
};

/// Calls visit(i) in rising order for each point inside; the same promises as for_near.
template <class Visit>
inline void for_inside(const float* x, const float* y, const float* z, int count, const CylinderLanes& c, Visit&& visit) noexcept {
  for_hits(count, [&](int i) {
    const Lanes dx = load_lanes(x + i) - c.at.x, dy = load_lanes(y + i) - c.at.y, dz = load_lanes(z + i) - c.at.z;
    const Lanes t = dx * c.axis.x + dy * c.axis.y + dz * c.axis.z;
    const Lanes off2 = dx * dx + dy * dy + dz * dz - t * t;
    const LaneMask inside = (off2 <= c.narrow2) | ((t >= c.wide_from) & (off2 <= c.wide2));
    return bits_of((t >= c.from) & (t <= c.to) & inside);
  }, visit);
}

/// Largest n . (x, y, z) of the points; -3e38 of none. Only for bounds: the order of the sums is fixed all the same.
inline float highest_along(const float* x, const float* y, const float* z, int count, Vec3f n) noexcept {
  float most = -3.0e38f;
  Lanes high = all_lanes(most);
  int i = 0;
  for (; i + kLanes <= count; i += kLanes)
    high = most_of(high, load_lanes(x + i) * n.x + load_lanes(y + i) * n.y + load_lanes(z + i) * n.z);
  for (int lane = 0; lane < kLanes; ++lane) most = high[lane] > most ? high[lane] : most;
  for (; i < count; ++i) {
    const float height = x[i] * n.x + y[i] * n.y + z[i] * n.z;
    most = height > most ? height : most;
  }
  return most;
}

}  // namespace cusp::engine
