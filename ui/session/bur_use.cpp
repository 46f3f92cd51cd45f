#include "ui/session/bur_use.h"

namespace cusp::ui {

void BurUse::add(std::span<const StepInput> inputs) {
  for (const StepInput& input : inputs) {
    if (spans_.empty() || spans_.back().bur != input.bur) spans_.push_back({input.bur, elapsed_us_, elapsed_us_, 0});
    elapsed_us_ += input.elapsed_us;
    spans_.back().to_us = elapsed_us_;
    if (input.cutting()) spans_.back().cutting_us += input.elapsed_us;
  }
}

}  // namespace cusp::ui
