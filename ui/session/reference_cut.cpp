#include "ui/session/reference_cut.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scenarios/operators/fast_cut.h"

namespace cusp::ui {
namespace {

constexpr int kKeySteps = 3 * ReferenceCut::kStepsPerSecond;  // the most that going back cuts anew

}  // namespace

PathTimeline::PathTimeline(Plan plan, double seconds) : plan_(std::move(plan)), seconds_(seconds) {
  Vec3 at = plan_.start_mm;
  double sum = 0;
  for (const Stroke& stroke : plan_.strokes) {
    sum += glm::length(stroke.to_mm - at) / (stroke.cut ? 1.0 : kAirFaster);
    ends_s_.push_back(sum);
    at = stroke.to_mm;
  }
  for (double& end : ends_s_) end *= seconds_ / sum;
}

/// Of the bur at `s`, within this stroke.
Vec3 PathTimeline::place(std::size_t stroke, double s) const {
  const Vec3 from = stroke == 0 ? plan_.start_mm : plan_.strokes[stroke - 1].to_mm;
  const double begin = begin_s(stroke), takes = ends_s_[stroke] - begin;
  const double share = takes > 0 ? std::clamp((s - begin) / takes, 0.0, 1.0) : 1.0;
  return from + share * (plan_.strokes[stroke].to_mm - from);
}

PathMoment PathTimeline::at(double s) const {
  const auto end = std::ranges::lower_bound(ends_s_, s);
  if (end == ends_s_.end()) return {plan_.strokes.back().to_mm, false};
  const auto stroke = static_cast<std::size_t>(end - ends_s_.begin());
  return {place(stroke, s), plan_.strokes[stroke].cut};
}

Plan PathTimeline::between(double from_s, double to_s) const {
  Plan out;
  out.bur = plan_.bur;
  out.axis = plan_.axis;
  out.start_mm = at(from_s).pivot_mm;
  auto stroke = static_cast<std::size_t>(std::ranges::upper_bound(ends_s_, from_s) - ends_s_.begin());
  for (; stroke < ends_s_.size() && begin_s(stroke) < to_s; ++stroke) out.strokes.push_back({place(stroke, to_s), plan_.strokes[stroke].cut});
  return out;
}

ReferenceCut::ReferenceCut(const Scenario& scenario, const std::shared_ptr<const Specimen>& specimen, PathTimeline timeline)
    : scenario_(scenario), timeline_(std::move(timeline)), volume_(std::make_unique<Volume>(specimen)) {
  keys_[0] = volume_->save_cuts();
}

int ReferenceCut::last_step() const noexcept { return static_cast<int>(std::lround(timeline_.seconds() * kStepsPerSecond)); }

bool ReferenceCut::cut_next() {
  const double per_step = timeline_.seconds() / last_step();
  // The last step ends with the path, whatever the rounding.
  const double to_s = step_ + 1 == last_step() ? timeline_.seconds() : (step_ + 1) * per_step;
  if (!cut_along(timeline_.between(step_ * per_step, to_s), scenario_, *volume_)) return false;
  ++step_;
  if (step_ % kKeySteps == 0 && !keys_.contains(step_)) keys_[step_] = volume_->save_cuts();
  return true;
}

Result<std::vector<std::int32_t>, OperatorCutError> ReferenceCut::go_to(int step) {
  const int wanted = std::clamp(step, 0, last_step());
  std::map<std::int32_t, std::uint32_t> before;
  for (const std::int32_t brick : volume_->cut_bricks()) before[brick] = volume_->revision(brick);
  const bool back = wanted < step_;
  if (const auto key = std::prev(keys_.upper_bound(wanted)); back || key->first > step_) {
    if (!volume_->load_cuts(key->second)) return std::unexpected(OperatorCutError::too_much_cut);
    step_ = key->first;
    for (auto& [brick, revision] : before) revision = ~0u;  // a load begins the revisions anew
  }
  while (step_ < wanted)
    if (!cut_next()) return std::unexpected(OperatorCutError::too_much_cut);
  for (const std::int32_t brick : volume_->cut_bricks()) {
    const auto known = before.find(brick);
    if (known == before.end()) before[brick] = ~0u;
    else if (known->second == volume_->revision(brick)) before.erase(known);
  }
  std::vector<std::int32_t> changed;
  for (const auto& [brick, revision] : before) changed.push_back(brick);
  return changed;
}

}  // namespace cusp::ui
