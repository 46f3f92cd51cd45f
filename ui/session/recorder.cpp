#include "ui/session/recorder.h"

#include "engine/loop/realtime.h"

namespace cusp {

Recorder::Recorder(std::unique_ptr<Store> store, SessionId session, Writing writing)
    : store_(std::move(store)), session_(session), writing_(writing) {
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

void Recorder::add(RecordedSecond second) {
  std::unique_lock lock(mutex_);
  waiting_.push_back(std::move(second));
  if (writing_ == Writing::at_once) {
    while (!waiting_.empty() && write_first(lock)) {
    }
    return;
  }
  lock.unlock();
  wake_.notify_one();
}

bool Recorder::write_first(std::unique_lock<std::mutex>& lock) {
  if (failure_) return false;
  // Only this thread takes from the front, and a deque's items do not move when others are added behind.
  const RecordedSecond& second = waiting_.front();
  writing_now_ = true;
  lock.unlock();
  auto written = store_->traces.append(session_, second);
  lock.lock();
  writing_now_ = false;
  if (written) {
    waiting_.pop_front();
  } else {
    failure_ = std::move(written.error());
  }
  idle_.notify_all();
  return !failure_;
}

void Recorder::run() {
  name_this_thread("cusp-recorder");
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return stop_ || (!waiting_.empty() && !failure_); });
    if (!waiting_.empty() && !failure_) {
      write_first(lock);
    } else if (stop_) {
      return;
    }
  }
}

RecordingState Recorder::state() const {
  const std::lock_guard lock(mutex_);
  if (failure_) return RecordingState::failed;
  return waiting_.size() > kBehind ? RecordingState::behind : RecordingState::recording;
}

std::optional<StorageFailure> Recorder::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

void Recorder::retry() {
  std::unique_lock lock(mutex_);
  failure_.reset();
  if (writing_ == Writing::at_once) {
    while (!waiting_.empty() && write_first(lock)) {
    }
    return;
  }
  lock.unlock();
  wake_.notify_one();
}

bool Recorder::drain() {
  std::unique_lock lock(mutex_);
  if (writing_ == Writing::on_a_thread) {
    idle_.wait(lock, [this] { return !writing_now_ && (waiting_.empty() || failure_.has_value()); });
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

}  // namespace cusp
