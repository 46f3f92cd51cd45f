#include "engine/lab/measures.h"

#include <algorithm>
#include <cmath>

namespace cusp::engine::lab {

namespace {
double norm_of(Vec3 v) { return std::sqrt(glm::dot(v, v)); }
}  // namespace

void ContactEnergy::add(const Share& share) noexcept {
  if (share.contact) {
    if (gap_ >= kGapMs) {
      sum_ = 0.0;
      ++episodes_;
    }
    gap_ = 0;
  } else if (gap_ < kGapMs) {
    ++gap_;
  }
  if (gap_ >= kGapMs) return;
  sum_ += share.energy_mj;
  most_ = std::max(most_, sum_);
}

Steadiness::Steadiness(Vec3 along, Vec3 across) noexcept : axes_{along, across, glm::cross(along, across)} {}

void Steadiness::add(const LoopTick& tick, Part part) noexcept {
  over_ = over_ || tick.over_limit;
  if (part == Part::before_window) return;
  if (count_ == 0) from_ = tick.from_mm;
  to_ = tick.to_mm;
  moment_ += tick.mean_n;
  energy_ += tick.energy_mj;
  Vec3 at;
  for (std::size_t a = 0; a < 3; ++a) at[static_cast<int>(a)] = glm::dot(tick.to_mm, axes_[a]);
  low_ = glm::min(low_, at);
  high_ = glm::max(high_, at);
  if (count_ < window_.size()) window_[count_++] = at;
}

double Steadiness::peak_to_peak_mm() const noexcept {
  const Vec3 wide = high_ - low_;
  return count_ > 0 ? std::max({wide.x, wide.y, wide.z}) : 0.0;
}

double Steadiness::energy_mj() const noexcept {
  return count_ > 0 ? energy_ - glm::dot(moment_ / static_cast<double>(count_), to_ - from_) : 0.0;
}

Steadiness::Verdict Steadiness::verdict(double encoder_step_mm) const noexcept {
  if (over_) return Verdict::over_limit;
  if (!(peak_to_peak_mm() <= kMostSteps * encoder_step_mm)) return Verdict::moves;
  if (!(energy_mj() <= kMostEnergyMj)) return Verdict::feeds;
  return Verdict::steady;
}

double Steadiness::cycle_hz() const noexcept {
  if (count_ == 0) return 0.0;
  const Vec3 wide = high_ - low_;
  int axis = 0;
  for (int a = 1; a < 3; ++a)
    if (wide[a] > wide[axis]) axis = a;
  // Turning points by more than half of the peak to peak: a maximum counts once the motion is that far below it.
  const double enough = 0.5 * wide[axis];
  if (!(enough > 0.0)) return 0.0;
  double top = window_[0][axis], bottom = top;
  std::size_t first = 0, last = 0, top_at = 0;
  int maxima = 0;
  bool rising = true;
  for (std::size_t i = 0; i < count_; ++i) {
    const double at = window_[i][axis];
    if (rising) {
      if (at >= top) {
        top = at;
        top_at = i;
      } else if (top - at > enough) {
        if (maxima++ == 0) first = top_at;
        last = top_at;
        rising = false;
        bottom = at;
      }
    } else if (at <= bottom) {
      bottom = at;
    } else if (at - bottom > enough) {
      rising = true;
      top = at;
      top_at = i;
    }
  }
  return maxima >= 2 ? static_cast<double>(maxima - 1) / (static_cast<double>(last - first) * kTickS) : 0.0;
}

void StuckWatch::add(Vec3 exact_mm, Vec3 method_mm) noexcept {
  const auto place = static_cast<std::size_t>(count_ % kWindowMs);
  bool now = false;
  if (count_ >= kWindowMs) {
    const double wanted = norm_of(exact_mm - exact_[place]), went = norm_of(method_mm - method_[place]);
    now = wanted > kMovedMm && !(went >= kShare * wanted);
  }
  running_ = now ? std::max(running_, kWindowMs - 1) + 1 : 0;
  longest_ = std::max(longest_, running_);
  exact_[place] = exact_mm;
  method_[place] = method_mm;
  ++count_;
}

double rise_n(Vec3 before_n, Vec3 now_n) noexcept {
  const Vec3 change = now_n - before_n;
  const double before = norm_of(before_n);
  if (before == 0.0) return norm_of(change);
  const double along = glm::dot(change, before_n) / before;
  const double fall = std::min(std::max(0.0, -along), before);
  return norm_of(change + before_n * (fall / before));
}

std::optional<double> ForceSteps::add(const Tick& tick) noexcept {
  const Vec3 before = force_, exact_before = exact_;
  const bool have = have_, lost = gone_ < kGapMs;
  if (tick.force_n != Vec3(0.0)) {
    gone_ = 0;
  } else {
    gone_ = tick.exact_n == Vec3(0.0) ? kGapMs : std::min(gone_ + 1, kGapMs);
  }
  force_ = tick.force_n;
  exact_ = tick.exact_n;
  have_ = true;
  if (!have) return std::nullopt;
  const double rise = rise_n(before, tick.force_n) * 1000.0;
  if (tick.guard_acted) {
    guard_ = std::max(guard_, rise);
    return std::nullopt;
  }
  // First contact: of the method, or of the exact proxy a tick apart from it.
  if ((before == Vec3(0.0) && !lost) || exact_before == Vec3(0.0)) return std::nullopt;
  const double more = rise - rise_n(exact_before, tick.exact_n) * 1000.0;
  step_ = std::max(step_, more);
  return more;
}

}  // namespace cusp::engine::lab
