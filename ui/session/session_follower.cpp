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
      removed_(reference_),
      process_(std::move(settings.process)),
      next_second_us_(next_multiple(start.last().elapsed_us, kSecondUs)),
      next_key_us_(next_multiple(start.last().elapsed_us, kKeyStateUs)) {
  const IVec3 n = start.volume().specimen().brick_count();
  seen_revision_.assign(static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z), 0);
  second_.first_tick = start.last().tick + 1;
  second_.inputs.reserve(1100);
  // A session that resumes is not behind by all that it has.
  view_.tick = start.last().tick;
  view_.elapsed_us = start.last().elapsed_us;
  if (recorder_ && scores_ == Scores::for_the_record) scorer_ = std::make_unique<SecondScorer>(reference_, start.volume().specimen_ptr(), *recorder_);
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
  SecondMetrics& metrics = second_.metrics;
  if (output.contact) ++metrics.contact_ticks;
  if (const auto push = known_force_n(output)) {
    contact_us_ += input.elapsed_us;
    impulse_n_us_ += *push * static_cast<double>(input.elapsed_us);
    metrics.force_peak_n = std::max(metrics.force_peak_n, *push);
  }
  if (output.cutting) ++metrics.cutting_ticks;
  second_.inputs.push_back(input);
  if (output.elapsed_us >= next_second_us_ || second_.inputs.size() >= kMostInputsASecond) flush(after);
}

void SessionFollower::flush(const StepState& after) {
  const std::uint64_t now = after.last().elapsed_us;
  const std::uint64_t next_tick = after.last().tick + 1;
  if (!second_.inputs.empty()) {
    second_.metrics.force_mean_n = contact_us_ > 0 ? impulse_n_us_ / static_cast<double>(contact_us_) : 0.0;
    second_.state_hash = after.hash();
    std::optional<KeyState> key_state;
    if (now >= next_key_us_) {
      key_state = KeyState{after.last().tick, after.save(), process_.save()};
      next_key_us_ = next_multiple(now, kKeyStateUs);
    }
    record(after.volume(), std::move(key_state));
  }
  second_ = RecordedSecond{};
  second_.first_tick = next_tick;
  second_.inputs.reserve(1100);
  contact_us_ = 0;
  impulse_n_us_ = 0;
  next_second_us_ = next_multiple(now, kSecondUs);
}

void SessionFollower::record(const Volume& volume, std::optional<KeyState> key_state) {
  if (!scorer_) {
    update_scores(volume);
    second_.metrics.removed = removed_.removed();
    return recorder_->add(std::move(second_), std::move(key_state));
  }
  find_changed(volume);
  std::vector<ChangedBrick> changed(changed_.size());
  for (std::size_t i = 0; i < changed.size(); ++i) {
    changed[i].brick = changed_[i];
    std::copy_n(volume.cut_of(changed_[i]), kBrickVoxels, changed[i].cut.begin());
  }
  scorer_->add(std::move(changed), std::move(second_), std::move(key_state));
}

void SessionFollower::find_changed(const Volume& volume) {
  changed_.clear();
  for (const std::int32_t brick : volume.cut_bricks()) {
    std::uint32_t& seen = seen_revision_[static_cast<std::size_t>(brick)];
    if (volume.revision(brick) == seen) continue;
    seen = volume.revision(brick);
    changed_.push_back(brick);
  }
}

void SessionFollower::update_scores(const Volume& volume) {
  find_changed(volume);
  removed_.update(volume, changed_);
}

void SessionFollower::on_state(const StepState& state, const StateNews& news) {
  const bool due = state.last().elapsed_us >= next_scores_us_ || news.first || news.last;
  if (scores_ == Scores::for_a_screen && due) {
    next_scores_us_ = state.last().elapsed_us + kScoresUs;
    update_scores(state.volume());
  }
  if (recorder_) {
    if (news.last) {
      flush(state);
      scorer_.reset();  // all is with the recorder
    }
    if (recorder_->state() == RecordingState::failed && hold_) hold_();
  }
  const std::lock_guard lock(mutex_);
  view_.tick = state.last().tick;
  view_.elapsed_us = state.last().elapsed_us;
  view_.scores = removed_.reading();
  view_.deepest_mm = deepest_mm_;
  view_.peak_push_n = process_.force_peak_n();
}

FollowedView SessionFollower::view() const {
  const std::lock_guard lock(mutex_);
  return view_;
}

}  // namespace cusp::ui
