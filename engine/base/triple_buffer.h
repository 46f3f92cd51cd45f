/// Latest-value exchange between one writer and one reader thread. Wait-free on both sides. The reader may miss values,
/// and never sees a torn one.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace cusp {

template <class T>
class TripleBuffer {
 public:
  /// Writer thread.
  void write(const T& value) noexcept {
    slots_[back_] = value;
    back_ = middle_.exchange(static_cast<std::uint8_t>(back_ | kFresh), std::memory_order_acq_rel) & kIndex;
  }
  /// Reader thread. The newest value; a value-initialised T before the first.
  const T& read() noexcept {
    if (middle_.load(std::memory_order_relaxed) & kFresh) {
      front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    }
    return slots_[front_];
  }

 private:
  static constexpr std::uint8_t kFresh = 4;
  static constexpr std::uint8_t kIndex = 3;
  std::array<T, 3> slots_{};
  std::uint8_t back_ = 0;
  alignas(64) std::atomic<std::uint8_t> middle_{1};
  alignas(64) std::uint8_t front_ = 2;
};

}  // namespace cusp
