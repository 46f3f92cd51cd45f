/// A process of its own that is killed while it works.
#pragma once

#include <cstddef>
#include <functional>

namespace cusp::test {

struct Killed {
  std::size_t steps = 0;   // that it reported before it ended
  bool by_signal = false;  // false: it had ended by itself
};

/// Forks; the child calls `work`, which calls `step` for each step that it reports, and exits with 0 when it returns. Kills
/// the child `delay_us` after it has reported `steps`, or when it has ended.
Killed kill_after(std::size_t steps, unsigned delay_us, const std::function<void(const std::function<bool()>& step)>& work);

}  // namespace cusp::test
