/// Which burr was in the handpiece when, told by a session's inputs. Any thread.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/step/input.h"

namespace cusp {

/// One burr from when it was taken to when another was, in the session's own time.
struct BurrSpan {
  std::uint16_t burr = 0;  // place in the scenario's instruments
  std::uint64_t from_us = 0, to_us = 0;
  std::uint64_t cutting_us = 0;  // of it with the drill asked to cut
  friend bool operator==(const BurrSpan&, const BurrSpan&) = default;
};

class BurrUse {
 public:
  /// The next inputs, in order.
  void add(std::span<const StepInput> inputs);
  const std::vector<BurrSpan>& spans() const noexcept { return spans_; }

 private:
  std::vector<BurrSpan> spans_;
  std::uint64_t elapsed_us_ = 0;
};

}  // namespace cusp
