#include "engine/mirror/mirror.h"

#include <algorithm>
#include <chrono>

#include "engine/base/fp_guard.h"
#include "engine/loop/realtime.h"

namespace cusp::engine {

namespace {
// The mirror polls the ring at this interval: a wake-up would be a system call in the tick.
constexpr std::chrono::milliseconds kPoll{2};
// With more inputs waiting, the mirror steps them first and shows the newest state, at most kMostDelayUs of session
// time later.
constexpr std::size_t kFewInputs = 8;
constexpr std::uint64_t kMostDelayUs = 50'000;
// With more inputs waiting, showing would make the mirror later: it shows at most kLongestUs of session time later.
constexpr std::size_t kManyInputs = 200;
constexpr std::uint64_t kLongestUs = 500'000;
}  // namespace

Mirror::Mirror(StepState state, HandOver& hand_over, const MirrorSettings& settings)
    : state_(std::move(state)), hand_over_(hand_over), settings_(settings) {
  const IVec3 n = state_.scene().specimen->brick_count();
  const auto bricks = static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z);
  shown_revision_.assign(bricks, 0);
  changed_.reserve(bricks);
  own_.reserve(64);
  ticks_.store(state_.last().tick, std::memory_order_release);
}

Mirror::~Mirror() { stop(); }

void Mirror::start() {
  if (threaded_) return;
  threaded_ = true;
  thread_ = std::thread([this] { run(); });
}

void Mirror::stop() {
  stop_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
}

std::optional<Mismatch> Mirror::mismatch() const noexcept {
  if (!differs_.load(std::memory_order_acquire)) return std::nullopt;
  return mismatch_;
}

void Mirror::one(const StepInput& input) {
  const StepOutput output = step(state_, input);
  digest_.add(state_, output);
  ticks_.store(output.tick, std::memory_order_release);
  for (MirrorObserver* o : observers_) o->on_tick(input, state_);
  if (output.tick % kMarkTicks == 0) own_.push_back({output.tick, digest_.value()});
}

void Mirror::compare() noexcept {
  DigestMark loop;
  while (hand_over_.marks.pop(loop)) loop_marks_.push_back(loop);
  // Both lists rise. A tick that one list lacks (a dropped mark) is skipped.
  std::size_t i = 0, j = 0;
  while (i < own_.size() && j < loop_marks_.size()) {
    if (own_[i].tick < loop_marks_[j].tick) {
      ++i;
    } else if (own_[i].tick > loop_marks_[j].tick) {
      ++j;
    } else {
      if (own_[i].digest != loop_marks_[j].digest && !differs_.load(std::memory_order_relaxed)) {
        mismatch_ = {own_[i].tick, loop_marks_[j].digest, own_[i].digest};
        differs_.store(true, std::memory_order_release);
      }
      compared_.fetch_add(1, std::memory_order_acq_rel);
      ++i, ++j;
    }
  }
  own_.erase(own_.begin(), own_.begin() + static_cast<std::ptrdiff_t>(i));
  loop_marks_.erase(loop_marks_.begin(), loop_marks_.begin() + static_cast<std::ptrdiff_t>(j));
}

void Mirror::show(Call call) {
  changed_.clear();
  for (const std::int32_t brick : state_.volume().cut_bricks()) {
    const std::uint32_t revision = state_.volume().revision(brick);
    std::uint32_t& shown = shown_revision_[static_cast<std::size_t>(brick)];
    if (revision == shown && !first_) continue;
    shown = revision;
    changed_.push_back(brick);
  }
  const StateNews news{changed_, hand_over_.inputs.size(), first_, call == Call::last};
  for (MirrorObserver* o : observers_) o->on_state(state_, news);
  first_ = false;
  next_show_us_ = state_.last().elapsed_us + settings_.show_every_us;
}

std::uint64_t Mirror::pump() {
  const FpGuard fp;
  if (first_) show(Call::further);
  std::uint64_t done = 0;
  StepInput input;
  while (hand_over_.inputs.pop(input)) {
    one(input);
    ++done;
    const std::uint64_t now_us = state_.last().elapsed_us;
    if (now_us < next_show_us_) continue;
    const std::size_t waiting = hand_over_.inputs.size();
    // Without a thread the mirror is never late.
    const std::uint64_t delay_us = waiting <= kFewInputs ? 0 : waiting <= kManyInputs ? kMostDelayUs : kLongestUs;
    if (!threaded_ || now_us >= next_show_us_ + delay_us) show(Call::further);
  }
  compare();
  return done;
}

void Mirror::finish() {
  pump();
  show(Call::last);
}

void Mirror::run() {
  name_this_thread("cusp-mirror");
  for (;;) {
    // Read before pump(), which then steps every input that the loop stored before stop().
    const bool stopping = stop_.load(std::memory_order_acquire);
    const std::uint64_t done = pump();
    if (stopping) break;
    if (done > 0) continue;
    for (MirrorObserver* o : observers_) o->on_idle(state_);
    std::this_thread::sleep_for(kPoll);
  }
  show(Call::last);
}

}  // namespace cusp::engine
