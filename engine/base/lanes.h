/// Four floats or two doubles at a time. The vector build and the portable build compute the same bits, element by element.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace cusp {

using Lanes = float __attribute__((vector_size(16)));
using LaneMask = int __attribute__((vector_size(16)));  // all bits of a lane, or none
inline constexpr int kLanes = 4;

inline Lanes all_lanes(float v) noexcept { return Lanes{v, v, v, v}; }
inline Lanes load_lanes(const float* from) noexcept {
  Lanes out;
  __builtin_memcpy(&out, from, sizeof out);
  return out;
}

inline Lanes sqrt_of(Lanes v) noexcept {
#if defined(__SSE2__)
  return _mm_sqrt_ps(v);
#else
  for (int i = 0; i < kLanes; ++i) v[i] = __builtin_sqrtf(v[i]);
  return v;
#endif
}

inline Lanes least_of(Lanes a, Lanes b) noexcept {
#if defined(__SSE2__)
  return _mm_min_ps(a, b);
#else
  return a < b ? a : b;
#endif
}
inline Lanes most_of(Lanes a, Lanes b) noexcept {
#if defined(__SSE2__)
  return _mm_max_ps(a, b);
#else
  return a > b ? a : b;
#endif
}

/// The least lane.
inline float least_lane(Lanes v) noexcept {
#if defined(__SSE2__)
  const __m128 two = _mm_min_ps(v, _mm_movehl_ps(v, v));
  return _mm_cvtss_f32(_mm_min_ss(two, _mm_shuffle_ps(two, two, 1)));
#else
  const float a = v[0] < v[2] ? v[0] : v[2], b = v[1] < v[3] ? v[1] : v[3];
  return a < b ? a : b;
#endif
}

/// Four 16-bit values in memory order.
inline LaneMask from_memory(std::uint64_t four) noexcept {
#if defined(__SSE2__)
  const __m128i values = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(&four));
  return reinterpret_cast<LaneMask>(_mm_unpacklo_epi16(values, _mm_setzero_si128()));
#else
  std::uint16_t values[kLanes];
  __builtin_memcpy(values, &four, sizeof values);
  return LaneMask{values[0], values[1], values[2], values[3]};
#endif
}

using Pair = double __attribute__((vector_size(16)));
using PairMask = decltype(Pair{} < Pair{});  // all bits of a lane, or none

inline Pair both(double v) noexcept { return Pair{v, v}; }
inline Pair load_pair(const double* from) noexcept {
  Pair out;
  __builtin_memcpy(&out, from, sizeof out);
  return out;
}
inline Pair sqrt_of(Pair v) noexcept {
#if defined(__SSE2__)
  return _mm_sqrt_pd(v);
#else
  for (int i = 0; i < 2; ++i) v[i] = __builtin_sqrt(v[i]);
  return v;
#endif
}
inline unsigned bits_of(PairMask m) noexcept {
#if defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(m)));
#else
  return static_cast<unsigned>(m[0] != 0) | static_cast<unsigned>(m[1] != 0) << 1;
#endif
}

/// One bit per lane; the first lane is the lowest bit.
inline unsigned bits_of(LaneMask m) noexcept {
#if defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(m)));
#else
  unsigned out = 0;
  for (int i = 0; i < kLanes; ++i) out |= static_cast<unsigned>(m[i] != 0) << i;
  return out;
#endif
}

}  // namespace cusp
