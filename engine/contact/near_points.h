/// Which of many points lie within reach of a place, eight at a time. Places in voxels, single precision: what passes is
/// asked again exactly by whoever needs it, so `reach` should carry a thousandth of a voxel more than is meant.
/// Wait-free. Thread: any.
#pragma once

#include "engine/base/lanes.h"
#include "engine/base/vec.h"

namespace cusp::engine {

/// Calls visit(i) in rising order for each i < count with |(x,y,z)[i] - centre|^2 <= reach2. Seven floats beyond count
/// must be readable.
template <class Visit>
inline void for_near(const float* x, const float* y, const float* z, int count, Vec3f centre, float reach2,
                     Visit&& visit) noexcept {
  const auto four = [&](int i) {
    const Lanes dx = load_lanes(x + i) - centre.x, dy = load_lanes(y + i) - centre.y, dz = load_lanes(z + i) - centre.z;
    return bits_of(dx * dx + dy * dy + dz * dz <= reach2);
  };
  for (int i = 0; i < count; i += 8) {
    unsigned hit = four(i) | four(i + 4) << 4;
    if (count - i < 8) hit &= (1u << (count - i)) - 1u;
    for (; hit != 0; hit &= hit - 1) visit(i + __builtin_ctz(hit));
  }
}

/// Two coaxial cylinders, the wider one from `wide_from` on; both from `from` upwards. In the points' own frame.
struct TwoCylinders {
  Vec3f at{0.0f}, axis{0.0f};
  float from = 0.0f, wide_from = 0.0f, to = 0.0f;
  float narrow2 = 0.0f, wide2 = 0.0f;  // squared radii
};

/// Calls visit(i) in rising order for each point inside; the same promises as for_near.
template <class Visit>
inline void for_inside(const float* x, const float* y, const float* z, int count, TwoCylinders c,
                       Visit&& visit) noexcept {
  for (int i = 0; i < count; i += kLanes) {
    const Lanes dx = load_lanes(x + i) - c.at.x, dy = load_lanes(y + i) - c.at.y, dz = load_lanes(z + i) - c.at.z;
    const Lanes t = dx * c.axis.x + dy * c.axis.y + dz * c.axis.z;
    const Lanes off2 = dx * dx + dy * dy + dz * dz - t * t;
    const LaneMask inside = (off2 <= c.narrow2) | ((t >= c.wide_from) & (off2 <= c.wide2));
    unsigned hit = bits_of((t >= c.from) & (t <= c.to) & inside);
    if (count - i < kLanes) hit &= (1u << (count - i)) - 1u;
    for (; hit != 0; hit &= hit - 1) visit(i + __builtin_ctz(hit));
  }
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
