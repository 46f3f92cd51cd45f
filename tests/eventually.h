/// Waits for what another thread comes to do, never for a length of time.
#pragma once

#include <chrono>
#include <thread>

namespace cusp::test {

/// True as soon as `condition` holds; false when it never did in a minute, and then something is wrong.
template <class Condition>
bool eventually(Condition&& condition) {
  for (int i = 0; i < 60'000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

}  // namespace cusp::test
