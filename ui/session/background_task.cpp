#include "ui/session/background_task.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <list>
#include <mutex>
#include <thread>
#include <utility>

namespace cusp::ui {

struct BackgroundTask::Job {
  std::thread thread;
  std::atomic<bool> over{false};
  Holds holds = Holds::nothing;
};

namespace {

using Holds = BackgroundTask::Holds;

constexpr std::chrono::milliseconds kDeviceLook{1};

/// BackgroundTasks that nobody holds any more.
class Dropped {
 public:
  ~Dropped() { wait(); }

  /// Keeps the thread until it is over.
  void take(Holds holds, std::function<bool()> is_over, std::thread thread) {
    const std::lock_guard lock(mutex_);
    sweep();
    left_.push_back({holds, std::move(is_over), std::move(thread)});
  }

  void wait() {
    for (;;) {
      One one;
      {
        const std::lock_guard lock(mutex_);
        if (left_.empty()) return;
        one = std::move(left_.front());
        left_.pop_front();
        ++waited_for(one.holds);
      }
      one.thread.join();
      const std::lock_guard lock(mutex_);
      --waited_for(one.holds);
      joined_.notify_all();
    }
  }

  void wait_for_all() {
    wait();
    // Another may have taken one over to wait for it.
    std::unique_lock lock(mutex_);
    joined_.wait(lock, [&] { return std::ranges::all_of(waited_for_, [](int tasks) { return tasks == 0; }); });
  }

  /// Whether one is left that holds this.
  bool has(Holds holds) {
    const std::lock_guard lock(mutex_);
    sweep();
    return waited_for(holds) > 0 || std::ranges::any_of(left_, [holds](const One& one) { return one.holds == holds; });
  }

 private:
  struct One {
    Holds holds = Holds::nothing;
    std::function<bool()> is_over;
    std::thread thread;
  };
  int& waited_for(Holds holds) { return waited_for_[static_cast<std::size_t>(holds)]; }
  void sweep() {
    for (auto it = left_.begin(); it != left_.end();) {
      if (!it->is_over()) {
        ++it;
        continue;
      }
      it->thread.join();
      it = left_.erase(it);
    }
  }

  std::mutex mutex_;
  std::condition_variable joined_;
  std::list<One> left_;
  std::array<int, 3> waited_for_{};  // [Holds]
};

Dropped& dropped() {
  static Dropped all;
  return all;
}

}  // namespace

BackgroundTask::BackgroundTask(std::function<void()> work, Holds holds) : job_(std::make_shared<Job>()) {
  dropped();  // stands before the first background task, and goes after it
  job_->holds = holds;
  job_->thread = std::thread([work = std::move(work), job = job_.get()]() mutable {
    work();
    work = nullptr;  // what it holds goes here, not on the window's thread
    job->over.store(true, std::memory_order_release);
  });
}

BackgroundTask::~BackgroundTask() {
  if (!job_) return;
  std::thread thread = std::move(job_->thread);
  const Holds holds = job_->holds;
  dropped().take(holds, [job = std::move(job_)] { return job->over.load(std::memory_order_acquire); }, std::move(thread));
}

BackgroundTask::BackgroundTask(BackgroundTask&& other) noexcept = default;

BackgroundTask& BackgroundTask::operator=(BackgroundTask&& other) noexcept {
  BackgroundTask gone(std::move(*this));
  job_ = std::move(other.job_);
  return *this;
}

bool BackgroundTask::over() const noexcept { return !job_ || job_->over.load(std::memory_order_acquire); }

void wait_for_dropped_tasks() { dropped().wait_for_all(); }

void wait_for_dropped_devices(const std::function<bool()>& called_off) {
  while (dropped().has(Holds::device) && !(called_off && called_off())) std::this_thread::sleep_for(kDeviceLook);
}

DroppedWork dropped_work() {
  if (dropped().has(Holds::change)) return DroppedWork::change;
  return dropped().has(Holds::nothing) || dropped().has(Holds::device) ? DroppedWork::harmless : DroppedWork::none;
}

TasksEndHere::~TasksEndHere() {
  if (status_) std::_Exit(*status_);
  wait_for_dropped_tasks();
}

}  // namespace cusp::ui
