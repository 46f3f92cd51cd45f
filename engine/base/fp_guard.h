/// Denormal numbers count as zero while this object lives, on the thread that made it: they cost a hundred times a normal
/// one's time, and every thread that runs the step must treat them alike. Every driver of the step holds one.
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
