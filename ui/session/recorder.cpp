#include "ui/session/recorder.h"

#include "engine/loop/realtime.h"
#include "ui/modules.h"

namespace cusp::ui {

Recorder::Recorder(std::unique_ptr<Store> store, SessionId session, Writing writing, const Patience& patience)
    : store_(std::move(store)), session_(session), writing_(writing), patience_(patience) {
  if (writing_ == Writing::on_a_thread) thread_ = std::thread([this] { run(); });
}

Recorder::~Recorder() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Recorder::add(RecordedSecond second, std::optional<KeyState> key_state) {
  std::unique_lock lock(mutex_);
  waiting_.push_back({std::move(second), std::move(key_state)});
  if (writing_ == Writing::at_once) return write_all_at_once(lock);
  lock.unlock();
  wake_.notify_one();
}

bool Recorder::write_first(std::unique_lock<std::mutex>& lock) {
  // Only this thread takes from the front, and a deque's items do not move when others are added behind.
  const Waiting& first = waiting_.front();
  writing_now_ = true;
  lock.unlock();
  auto written = store_->traces.append(session_, first.second);
  if (written && first.key_state) {
    // A cache: where it cannot be written, whoever needs the state runs the session again.
    static_cast<void>(store_->key_states.keep_live(session_, *first.key_state));
  }
  if (!written && out_of_space(written.error().code)) store_->key_states.make_room();
  lock.lock();
  writing_now_ = again_ = false;
  if (written) {
    for (const StepInput& input : first.second.inputs) stored_us_ += input.elapsed_us;
    waiting_.pop_front();
    failure_.reset();
  } else {
    failure_ = std::move(written.error());
    ++refusals_;
  }
  idle_.notify_all();
  return !failure_;
}

void Recorder::write_all_at_once(std::unique_lock<std::mutex>& lock) {
  int tries = 0;
  while (!waiting_.empty() && !gave_up_) {
    if (write_first(lock)) {
      tries = 0;
    } else if (!passes(failure_->code) || ++tries >= patience_.tries) {
      gave_up_ = true;
    } else {
      lock.unlock();
      std::this_thread::sleep_for(patience_.pause);
      lock.lock();
    }
  }
}

void Recorder::run() {
  name_this_thread("cusp-recorder");
  std::unique_lock lock(mutex_);
  for (;;) {
    if (!failure_) {
      wake_.wait(lock, [this] { return stop_ || !waiting_.empty(); });
      if (waiting_.empty()) return;
    } else {
      const auto called = [this] { return stop_ || again_; };
      if (passes(failure_->code)) {
        wake_.wait_for(lock, patience_.pause, called);
      } else {
        wake_.wait(lock, called);
      }
      if (stop_) return;
    }
    write_first(lock);
  }
}

RecordingState Recorder::state() const {
  const std::lock_guard lock(mutex_);
  if (failure_ && !again_ && (gave_up_ || !passes(failure_->code) || waiting_.size() >= patience_.most_waiting)) {
    return RecordingState::failed;
  }
  return failure_ || waiting_.size() > kBehind ? RecordingState::behind : RecordingState::recording;
}

std::optional<StorageFailure> Recorder::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

void Recorder::retry() {
  std::unique_lock lock(mutex_);
  gave_up_ = false;
  if (writing_ == Writing::at_once) return write_all_at_once(lock);
  again_ = failure_.has_value();
  lock.unlock();
  wake_.notify_one();
}

std::uint64_t Recorder::stored_us() const {
  const std::lock_guard lock(mutex_);
  return stored_us_;
}

bool Recorder::drain() {
  std::unique_lock lock(mutex_);
  if (writing_ == Writing::on_a_thread) {
    const std::uint64_t before = refusals_;
    const auto enough = [&] {
      return failure_ && (!passes(failure_->code) || refusals_ - before >= static_cast<std::uint64_t>(patience_.tries));
    };
    idle_.wait(lock, [&] { return !writing_now_ && !again_ && (waiting_.empty() || enough()); });
  }
  return waiting_.empty();
}

std::unique_ptr<Store> Recorder::take_store() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
  return std::move(store_);
}

}  // namespace cusp::ui
