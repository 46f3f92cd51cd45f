/// A loop over pieces of work, shared by the calling thread and one more.
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace cusp::scenarios {

/// Runs work(i) for each i in [0, count) once; `tick(i)` on the calling thread, between its pieces. Stops early, between
/// pieces, once *cancel is true. Pieces must not throw and must not depend on one another.
inline void in_two_threads(int count, const std::function<void(int)>& work, const std::function<void(int)>& tick = {},
                           const std::atomic<bool>* cancel = nullptr) {
  std::atomic<int> next{0};
  const auto stop = [&] { return cancel != nullptr && cancel->load(std::memory_order_relaxed); };
  const auto run = [&](bool first) {
    for (int i = next++; i < count && !stop(); i = next++) {
      work(i);
      if (first && tick) tick(i);
    }
  };
  std::jthread other([&] { run(false); });
  run(true);
}

}  // namespace cusp::scenarios
