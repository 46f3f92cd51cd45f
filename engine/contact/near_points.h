/// Which of many points lie within reach of a place, eight at a time. Places in voxels, single precision: what passes is
/// asked again exactly by whoever needs it, so `reach` should carry a thousandth of a voxel more than is meant.
/// Wait-free; the SSE2 and the portable path do the same arithmetic. Thread: any.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "engine/base/vec.h"

namespace cusp::engine {

/// Calls visit(i) in rising order for each i < count with |(x,y,z)[i] - centre|^2 <= reach2. Seven floats beyond count
/// must be readable.
template <class Visit>
inline void for_near(const float* x, const float* y, const float* z, int count, Vec3f centre, float reach2,
                     Visit&& visit) noexcept {
#if defined(__SSE2__)
  const __m128 cx = _mm_set1_ps(centre.x), cy = _mm_set1_ps(centre.y), cz = _mm_set1_ps(centre.z);
  const __m128 most = _mm_set1_ps(reach2);
  const auto four = [&](int i) {
    const __m128 dx = _mm_sub_ps(_mm_loadu_ps(x + i), cx);
    const __m128 dy = _mm_sub_ps(_mm_loadu_ps(y + i), cy);
    const __m128 dz = _mm_sub_ps(_mm_loadu_ps(z + i), cz);
    const __m128 d2 = _mm_add_ps(_mm_add_ps(_mm_mul_ps(dx, dx), _mm_mul_ps(dy, dy)), _mm_mul_ps(dz, dz));
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(d2, most)));
  };
#endif
  for (int i = 0; i < count; i += 8) {
#if defined(__SSE2__)
    unsigned hit = four(i) | four(i + 4) << 4;
#else
    unsigned hit = 0;
    for (int j = 0; j < 8; ++j) {
      const float dx = x[i + j] - centre.x, dy = y[i + j] - centre.y, dz = z[i + j] - centre.z;
      hit |= static_cast<unsigned>(dx * dx + dy * dy + dz * dz <= reach2) << j;
    }
#endif
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
inline void for_inside(const float* x, const float* y, const float* z, int count, const TwoCylinders& c,
                       Visit&& visit) noexcept {
#if defined(__SSE2__)
  const __m128 cx = _mm_set1_ps(c.at.x), cy = _mm_set1_ps(c.at.y), cz = _mm_set1_ps(c.at.z);
  const __m128 ax = _mm_set1_ps(c.axis.x), ay = _mm_set1_ps(c.axis.y), az = _mm_set1_ps(c.axis.z);
  const __m128 from = _mm_set1_ps(c.from), wide_from = _mm_set1_ps(c.wide_from), to = _mm_set1_ps(c.to);
  const __m128 narrow2 = _mm_set1_ps(c.narrow2), wide2 = _mm_set1_ps(c.wide2);
  for (int i = 0; i < count; i += 4) {
    const __m128 dx = _mm_sub_ps(_mm_loadu_ps(x + i), cx);
    const __m128 dy = _mm_sub_ps(_mm_loadu_ps(y + i), cy);
    const __m128 dz = _mm_sub_ps(_mm_loadu_ps(z + i), cz);
    const __m128 t = _mm_add_ps(_mm_add_ps(_mm_mul_ps(dx, ax), _mm_mul_ps(dy, ay)), _mm_mul_ps(dz, az));
    const __m128 d2 = _mm_add_ps(_mm_add_ps(_mm_mul_ps(dx, dx), _mm_mul_ps(dy, dy)), _mm_mul_ps(dz, dz));
    const __m128 off2 = _mm_sub_ps(d2, _mm_mul_ps(t, t));
    const __m128 along = _mm_and_ps(_mm_cmpge_ps(t, from), _mm_cmple_ps(t, to));
    const __m128 narrow = _mm_cmple_ps(off2, narrow2);
    const __m128 wide = _mm_and_ps(_mm_cmpge_ps(t, wide_from), _mm_cmple_ps(off2, wide2));
    auto hit = static_cast<unsigned>(_mm_movemask_ps(_mm_and_ps(along, _mm_or_ps(narrow, wide))));
    if (count - i < 4) hit &= (1u << (count - i)) - 1u;
    for (; hit != 0; hit &= hit - 1) visit(i + __builtin_ctz(hit));
  }
#else
  for (int i = 0; i < count; ++i) {
    const float dx = x[i] - c.at.x, dy = y[i] - c.at.y, dz = z[i] - c.at.z;
    const float t = dx * c.axis.x + dy * c.axis.y + dz * c.axis.z;
    const float off2 = dx * dx + dy * dy + dz * dz - t * t;
    if (t >= c.from && t <= c.to && (off2 <= c.narrow2 || (t >= c.wide_from && off2 <= c.wide2))) visit(i);
  }
#endif
}

/// Largest n . (x, y, z) of the points; -3e38 of none. Only for bounds: the order of the sums is fixed all the same.
inline float highest_along(const float* x, const float* y, const float* z, int count, Vec3f n) noexcept {
  float most = -3.0e38f;
#if defined(__SSE2__)
  const __m128 nx = _mm_set1_ps(n.x), ny = _mm_set1_ps(n.y), nz = _mm_set1_ps(n.z);
  __m128 high = _mm_set1_ps(most);
  int i = 0;
  for (; i + 4 <= count; i += 4)
    high = _mm_max_ps(high, _mm_add_ps(_mm_add_ps(_mm_mul_ps(_mm_loadu_ps(x + i), nx), _mm_mul_ps(_mm_loadu_ps(y + i), ny)),
                                       _mm_mul_ps(_mm_loadu_ps(z + i), nz)));
  float lanes[4];
  _mm_storeu_ps(lanes, high);
  for (const float lane : lanes) most = lane > most ? lane : most;
#else
  int i = 0;
#endif
  for (; i < count; ++i) {
    const float height = x[i] * n.x + y[i] * n.y + z[i] * n.z;
    most = height > most ? height : most;
  }
  return most;
}

}  // namespace cusp::engine
