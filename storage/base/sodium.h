/// libsodium, ready for use. Within storage only.
#pragma once

#include <sodium.h>

#include <cstdlib>

namespace cusp::storage {

/// Call before libsodium; any thread, any number of times. Aborts if the system has no random numbers.
inline void ready_sodium() {
  if (sodium_init() < 0) std::abort();
}

}  // namespace cusp::storage
