#include <algorithm>

#include "engine/base/fp_guard.h"
#include "ui/session/recorder.h"
#include "ui/session/replay.h"

namespace cusp::ui {

namespace {
constexpr std::uint64_t kWatchTicks = 250;
// Fewer ticks are computed without searching for a key state that another program may have left.
constexpr std::uint64_t kWorthLooking = 1000;
}  // namespace

Replay::Replay(Store& store, OpenedSession session, std::vector<StepInput> inputs)
    : store_(&store), session_(std::move(session)), inputs_(std::move(inputs)), state_(std::in_place, session_.scene) {
  const IVec3 n = session_.scene->specimen->brick_count();
  shown_revision_.assign(static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z), 0);
}

Outcome<Replay> Replay::open(Store& store, OpenedSession session) {
  if (!session.same_engine) {
    return session_fail(SessionError::other_engine, std::to_string(session.session.header.engine_version));
  }
  auto inputs = store.traces.inputs(session.session.id);
  if (!inputs) return session_fail(SessionError::storage, inputs.error());
  Replay replay(store, std::move(session), std::move(*inputs));
  if (auto read = replay.read_marks(); !read) return std::unexpected(read.error());
  return replay;
}

Outcome<void> Replay::read_marks() {
  const SessionId id = session_.session.id;
  const auto chunks = store_->traces.chunks(id);
  if (!chunks) return session_fail(SessionError::storage, chunks.error());
  std::uint64_t before_us = 0;
  for (const ChunkInfo& chunk : *chunks) {
    if (!chunk.state_hash) continue;
    const bool key = chunk.elapsed_us / kKeyStateUs > before_us / kKeyStateUs;
    marks_[chunk.first_tick + chunk.count - 1] = {.state_hash = *chunk.state_hash, .key = key};
    before_us = chunk.elapsed_us;
  }
  const auto stored = store_->traces.key_state_ticks(id);
  if (!stored) return session_fail(SessionError::storage, stored.error());
  for (const std::uint64_t tick : *stored) {
    if (const auto mark = marks_.find(tick); mark != marks_.end()) mark->second.stored = true;
  }
  look_into_cache();
  return {};
}

void Replay::look_into_cache() {
  for (auto& [tick, mark] : marks_) mark.cached = false;
  for (const std::uint64_t tick : store_->key_states.ticks(session_.session.id)) {
    if (const auto mark = marks_.find(tick); mark != marks_.end()) mark->second.cached = true;
  }
}

void Replay::begin_anew() {
  state_.emplace(session_.scene);
  process_ = Process();
  whole_ = computed_ = true;
}

std::optional<KeyState> Replay::key_state_at(std::uint64_t tick, Mark& mark) {
  const SessionId id = session_.session.id;
  if (mark.cached) {
    if (auto state = store_->key_states.read(id, tick)) return state;
    mark.cached = false;
  }
  if (!mark.stored) return std::nullopt;
  auto row = store_->traces.key_state_before(id, tick);
  if (!row || !*row || (*row)->tick != tick) return std::nullopt;
  return std::move(**row);
}

/// Takes the last key state in (after, target] that can be trusted.
bool Replay::restore_nearest(std::uint64_t target, std::uint64_t after, ReplayFrom from) {
  for (auto at = marks_.upper_bound(target); at != marks_.begin();) {
    --at;
    auto& [tick, mark] = *at;
    if (tick <= after) return false;
    if (!mark.cached && !mark.stored) continue;
    const auto kept = key_state_at(tick, mark);
    if (!kept) continue;
    const auto process = Process::restore(kept->process);
    if (from == ReplayFrom::whole_process && !process) continue;
    auto restored = StepState::restore(session_.scene, kept->state);
    if (!restored || restored->last().tick != tick || restored->hash() != mark.state_hash) {
      store_->key_states.drop(session_.session.id, tick);
      mark.cached = mark.stored = false;
      continue;
    }
    state_ = std::move(restored);
    process_ = process.value_or(Process());
    whole_ = process.has_value();
    computed_ = false;
    return true;
  }
  return false;
}

void Replay::keep_key_state(Mark& mark) {
  if (!mark.key || mark.cached || mark.stored || cache_refuses_ || state_->hash() != mark.state_hash) return;
  const KeyState state{state_->last().tick, state_->save(), whole_ ? process_.save() : std::vector<std::byte>{}};
  mark.cached = store_->key_states.keep_rebuilt(session_.session.id, state).has_value();
  cache_refuses_ = !mark.cached;
}

/// Forward from where it stands. False: stopped by the watch.
bool Replay::run(std::uint64_t target, const ReplayJump& jump) {
  const std::uint64_t begin = state_->last().tick;
  auto mark = marks_.upper_bound(begin);
  for (std::uint64_t at = begin; at < target;) {
    process_.add(step(*state_, inputs_[static_cast<std::size_t>(at)]));
    ++at;
    ++ticks_computed_;
    if (mark != marks_.end() && mark->first == at) {
      if (jump.keep) keep_key_state(mark->second);
      ++mark;
    }
    if (!jump.watch || (at - begin) % kWatchTicks != 0) continue;
    if (!jump.watch(static_cast<double>(at - begin) / static_cast<double>(target - begin))) return at == target;
  }
  return true;
}

Outcome<bool> Replay::to(std::uint64_t tick, const ReplayJump& jump) {
  const FpGuard fp;
  const std::uint64_t target = std::min<std::uint64_t>(tick, inputs_.size());
  const std::uint64_t here = state_->last().tick;
  const bool back = here > target;
  const bool anew = back || (jump.from == ReplayFrom::whole_process && !whole_) ||
                    (jump.from == ReplayFrom::first_tick && !computed_);
  bool jumped = false;
  if (jump.from != ReplayFrom::first_tick) {
    if (anew || target - here > kWorthLooking) look_into_cache();
    jumped = restore_nearest(target, anew ? 0 : here, jump.from);
  }
  if (anew && !jumped) {
    begin_anew();
    jumped = true;
  }
  const bool arrived = run(target, jump);
  show(jumped || !shown_ ? Shown::all : Shown::changed);
  return arrived;
}

void Replay::show(Shown bricks) {
  const bool all = bricks == Shown::all;
  std::vector<std::int32_t> changed;
  for (const std::int32_t brick : state_->volume().cut_bricks()) {
    std::uint32_t& shown = shown_revision_[static_cast<std::size_t>(brick)];
    const std::uint32_t revision = state_->volume().revision(brick);
    if (revision != shown || all) changed.push_back(brick);
    shown = revision;
  }
  const StateNews news{changed, 0, all, false};
  for (Observer* observer : observers_) observer->on_state(*state_, news);
  shown_ = true;
}

}  // namespace cusp::ui
