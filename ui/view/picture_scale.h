/// How large a picture in motion is drawn: the largest share of the view's sides at which a frame keeps to a budget.
/// Durations come from the caller; nothing is measured here. Thread: one at a time.
#pragma once

#include <cstddef>
#include <vector>

namespace cusp::ui {

class PictureScale {
 public:
  /// `budget_ms`: for drawing one frame; above 0.
  explicit PictureScale(double budget_ms) : budget_ms_(budget_ms) {}

  /// Of each side, 0.5 to 1; 1 at the beginning.
  double share() const noexcept;
  /// A picture in motion was drawn at share() and took so long.
  void drawn(double ms);

 private:
  double budget_ms_;
  std::size_t step_ = 0;            // of the table of shares
  std::vector<double> times_ms_;    // drawn at this step
};

}  // namespace cusp::ui
