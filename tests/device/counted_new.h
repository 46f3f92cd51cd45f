/// Counts what a thread takes from the heap while it is armed. Included by one file of a program: it replaces the global
/// operators new and delete.
#pragma once

#include <cstdlib>
#include <new>

namespace cusp::test {

inline thread_local bool armed = false;
inline thread_local int allocations = 0;
#ifdef CUSP_SANITIZED_THREADS
inline constexpr bool kCounts = false;  // clang's runtime for threads has its own operators
#else
inline constexpr bool kCounts = true;
#endif

inline void* counted_or_null(std::size_t bytes) noexcept {
  if (armed) ++allocations;
  return std::malloc(bytes == 0 ? 1 : bytes);
}
inline void* counted(std::size_t bytes) {
  if (void* memory = counted_or_null(bytes)) return memory;
  throw std::bad_alloc();
}

}  // namespace cusp::test

#ifndef CUSP_SANITIZED_THREADS
// g++ inlines one half of a pair and then finds std::malloc beside operator delete.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
#endif

void* operator new(std::size_t bytes) { return cusp::test::counted(bytes); }
void* operator new[](std::size_t bytes) { return cusp::test::counted(bytes); }
// AddressSanitizer has nothrow forms of its own, which go past these and do not fit the operators delete below.
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept { return cusp::test::counted_or_null(bytes); }
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept { return cusp::test::counted_or_null(bytes); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
#endif
