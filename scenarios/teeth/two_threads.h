/// A loop over jobs, shared by the calling thread and one more.
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace cusp::scenarios {

/// Runs work(i) for each i in [0, count) once; `tick(i)` on the calling thread, between its jobs. Stops early, between
/// jobs, once *cancel is true. Jobs must not throw and must not depend on one another.
inline void in_two_threads(int count, const std::function<void(int)>& work, const std::function<void(int)>& tick = {},
                           const std::atomic<bool>* cancel = nullptr) {
  std::atomic<int> next{0};
  const auto stop = [&] { return cancel != nullptr && cancel->load(std::memory_order_relaxed); };
  const auto run = [&](const std::function<void(int)>& after) {
    for (int i = next++; i < count && !stop(); i = next++) {
      work(i);
      if (after) after(i);
    }
  };
  std::jthread other([&] { run({}); });
  run(tick);
}

}  // namespace cusp::scenarios
