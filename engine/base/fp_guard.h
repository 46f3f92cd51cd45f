/// Treats denormal numbers as zero during the object's lifetime, on the constructing thread. They cost a hundred times
/// the time of normal ones. Every thread that runs the step holds a guard, so that all compute the same.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace cusp {

class FpGuard {
 public:
#if defined(__SSE2__)
  FpGuard() noexcept : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040u); }  // flush to zero, denormals are zero
  ~FpGuard() { _mm_setcsr(saved_); }
#else
  FpGuard() noexcept = default;
  ~FpGuard() = default;
#endif
  FpGuard(const FpGuard&) = delete;
  FpGuard& operator=(const FpGuard&) = delete;

 private:
#if defined(__SSE2__)
  unsigned saved_;
#endif
};

}  // namespace cusp
