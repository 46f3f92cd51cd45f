#include "ui/view/picture_scale.h"

#include <algorithm>
#include <array>
#include <span>

namespace cusp::ui {
namespace {

// Below a half, fissures and the dashes of lines run together.
constexpr std::array kShares = {1.0, 0.85, 0.7, 0.6, 0.5};
constexpr std::size_t kSlow = 3;    // frames whose median is beyond the budget make the picture smaller
constexpr std::size_t kQuick = 12;  // frames whose median leaves room make it larger
constexpr double kRoom = 0.8;       // of the budget: the most that a larger picture may be expected to take

double median(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

}  // namespace

double PictureScale::share() const noexcept { return kShares[step_]; }

void PictureScale::drawn(double ms) {
  times_ms_.push_back(ms);
  if (times_ms_.size() > kQuick) times_ms_.erase(times_ms_.begin());
  if (times_ms_.size() < kSlow) return;
  // As if every millisecond were spent on pixels. What is spent on vertices does not change, so that a smaller picture
  // never takes less than expected and a larger one never more: neither step goes too far.
  const auto expected_ms = [this](double now_ms, std::size_t step) {
    const double by = kShares[step] / kShares[step_];
    return now_ms * by * by;
  };
  const std::size_t before = step_;
  if (const double now_ms = median(std::span(times_ms_).last(kSlow)); now_ms > budget_ms_) {
    std::size_t step = step_;
    while (step + 1 < kShares.size() && expected_ms(now_ms, step) > budget_ms_) ++step;
    step_ = step;
  } else if (times_ms_.size() == kQuick && step_ > 0 && expected_ms(median(times_ms_), step_ - 1) <= kRoom * budget_ms_) {
    --step_;
  }
  if (step_ != before) times_ms_.clear();
}

}  // namespace cusp::ui
