#include "ui/session/session_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/session/bur_depth.h"

namespace cusp::ui {

namespace {
constexpr std::uint64_t kSecondUs = 1'000'000;
constexpr std::uint64_t kScoresUs = 100'000;      // as often as they are read; the picture of the tooth comes first
constexpr std::size_t kMostInputsASecond = 60'000;

std::uint64_t limit_us(double limit_s) {
  if (limit_s <= 0) return std::numeric_limits<std::uint64_t>::max();
  return static_cast<std::uint64_t>(std::ceil(limit_s * 1e6));
}

std::uint64_t next_multiple(std::uint64_t now, std::uint64_t step) { return (now / step + 1) * step; }
}  // namespace

SessionFollower::SessionFollower(std::shared_ptr<const Reference> reference, const StepState& start, Settings settings)
    : reference_(std::move(reference)),
      recorder_(settings.recorder),
      hold_(std::move(settings.hold)),
      scores_(settings.scores),
      limit_us_(limit_us(settings.time_limit_s)),
      time_is_up_(start.last().elapsed_us >= limit_us_),
      live_(reference_),
      process_(std::move(settings.process)),
      next_second_us_(next_multiple(start.last().elapsed_us, kSecondUs)),
      next_key_us_(next_multiple(start.last().elapsed_us, kKeyStateUs)) {
  const IVec3 n = start.volume().specimen().brick_count();
  seen_revision_.assign(static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z), 0);
  second_.first_tick = start.last().tick + 1;
  second_.inputs.reserve(1100);
}

void SessionFollower::on_tick(const StepInput& input, const StepState& after) {
  const StepOutput& output = after.last();
  process_.add(output);
  if (output.elapsed_us >= limit_us_) {
    time_is_up_.store(true, std::memory_order_release);
    if (hold_) hold_();
  }
  if (output.cutting) {
    const Bur& bur = after.scene().burs[output.bur];
    deepest_mm_ = std::max(deepest_mm_, bur_depth_mm(reference_->shape(), output, bur));
  }
  if (!recorder_) return;
  const double push = glm::length(output.force_raw_n);
  SecondMetrics& metrics = second_.metrics;
  if (output.contact) {
    ++metrics.contact_ticks;
    contact_us_ += input.elapsed_us;
    impulse_n_us_ += push * static_cast<double>(input.elapsed_us);
    metrics.force_peak_n = std::max(metrics.force_peak_n, push);
  }
  if (output.cutting) ++metrics.cutting_ticks;
  second_.inputs.push_back(input);
  if (output.elapsed_us >= next_second_us_ || second_.inputs.size() >= kMostInputsASecond) flush(after);
}

void SessionFollower::flush(const StepState& after) {
  const std::uint64_t now = after.last().elapsed_us;
  const std::uint64_t next_tick = after.last().tick + 1;
  if (!second_.inputs.empty()) {
    update_scores(after);
    second_.metrics.removed = removed();
    second_.metrics.force_mean_n = contact_us_ > 0 ? impulse_n_us_ / static_cast<double>(contact_us_) : 0.0;
    second_.state_hash = after.hash();
    std::optional<KeyState> key_state;
    if (now >= next_key_us_) {
      key_state = KeyState{after.last().tick, after.save(), process_.save()};
      next_key_us_ = next_multiple(now, kKeyStateUs);
    }
    recorder_->add(std::move(second_), std::move(key_state));
  }
  second_ = RecordedSecond{};
  second_.first_tick = next_tick;
  second_.inputs.reserve(1100);
  contact_us_ = 0;
  impulse_n_us_ = 0;
  next_second_us_ = next_multiple(now, kSecondUs);
}

void SessionFollower::update_scores(const StepState& state) {
  const Volume& volume = state.volume();
  const Specimen& specimen = volume.specimen();
  const bool filled = specimen.reading() == Reading::filled;
  changed_.clear();
  for (const std::int32_t brick : volume.cut_bricks()) {
    std::uint32_t& seen = seen_revision_[static_cast<std::size_t>(brick)];
    if (volume.revision(brick) == seen) continue;
    seen = volume.revision(brick);
    changed_.push_back(brick);
    std::array<std::uint32_t, kTissueCodes> gone{};
    const std::uint16_t* cut = volume.cut_of(brick);
    for (int o = 0; o < kBrickVoxels; ++o) {
      const std::uint16_t base = specimen.s_in(brick, o);
      const bool was = filled ? base > 0 : base >= kHalf;
      const bool is = filled ? std::min(base, cut[o]) > 0 : std::min(base, cut[o]) >= kHalf;
      if (was && !is) ++gone[index_of(specimen.tissue_in(brick, o))];
    }
    auto& before = gone_voxels_[brick];
    for (std::size_t t = 0; t < kTissueCodes; ++t) gone_total_[t] += gone[t] - before[t];
    before = gone;
  }
  live_.update(volume, changed_);
}

std::vector<RemovedTissue> SessionFollower::removed() const {
  std::vector<RemovedTissue> out;
  for (std::size_t t = 1; t < kTissueCodes; ++t) {
    const double mm3 = live_.reading().removed_mm3[t];
    if (gone_total_[t] > 0 || mm3 > 0) out.push_back({static_cast<Tissue>(t), gone_total_[t], mm3});
  }
  return out;
}

void SessionFollower::on_state(const StepState& state, const StateNews& news) {
  const bool read = scores_ == Scores::for_a_screen && state.last().elapsed_us >= next_scores_us_;
  if (read || news.first || news.last) {
    next_scores_us_ = state.last().elapsed_us + kScoresUs;
    update_scores(state);
  }
  if (recorder_) {
    if (news.last) flush(state);
    if (recorder_->state() == RecordingState::failed && hold_) hold_();
  }
  const std::lock_guard lock(mutex_);
  view_.tick = state.last().tick;
  view_.elapsed_us = state.last().elapsed_us;
  view_.scores = live_.reading();
  view_.deepest_mm = deepest_mm_;
  view_.peak_push_n = process_.force_peak_n();
}

FollowedView SessionFollower::view() const {
  const std::lock_guard lock(mutex_);
  return view_;
}

}  // namespace cusp::ui
