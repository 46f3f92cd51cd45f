/// Which bur was in the handpiece when, from a session's inputs. Any thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/step/input.h"
#include "ui/modules.h"

namespace cusp::ui {

/// One bur from when it was taken to when another was, in the session's own time.
struct BurSpan {
  std::uint16_t bur = 0;  // place in the scenario's instruments
  std::uint64_t from_us = 0, to_us = 0;
  std::uint64_t cutting_us = 0;  // of it with the drill asked to cut
  friend bool operator==(const BurSpan&, const BurSpan&) = default;
};

class BurUse {
 public:
  /// The next inputs, in order.
  void add(std::span<const StepInput> inputs);
  const std::vector<BurSpan>& spans() const noexcept { return spans_; }

 private:
  std::vector<BurSpan> spans_;
  std::uint64_t elapsed_us_ = 0;
};

}  // namespace cusp::ui
