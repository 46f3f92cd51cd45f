/// libsodium, ready for use. Within storage only.
#pragma once

#include <sodium.h>

#include <cstdlib>

namespace cusp::storage {

/// Before the first call into libsodium; any thread, any number of times. There is no going on without randomness.
inline void ready_sodium() {
  if (sodium_init() < 0) std::abort();
}

}  // namespace cusp::storage
