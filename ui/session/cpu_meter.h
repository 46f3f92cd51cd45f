/// What this thread has taken so far. Not for the haptic tick.
#pragma once

#include <cstdint>
#include <optional>

namespace cusp::ui {

/// CPU time of the calling thread, in seconds.
double thread_cpu_s() noexcept;

/// Bytes of the heap in use by the whole process.
std::uint64_t heap_bytes() noexcept;

/// Instructions of the calling thread in user mode, counted by the processor. Many virtual machines do not count.
class InstructionCounter {
 public:
  InstructionCounter() noexcept;
  ~InstructionCounter();
  InstructionCounter(const InstructionCounter&) = delete;
  InstructionCounter& operator=(const InstructionCounter&) = delete;
  /// Since the making; nullopt where the machine does not count.
  std::optional<std::uint64_t> read() const noexcept;

 private:
  int file_ = -1;
};

}  // namespace cusp::ui
