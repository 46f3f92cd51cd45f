#include "ui/session/background_watch.h"

#include <condition_variable>
#include <mutex>
#include <utility>

#include "ui/session/background_task.h"

namespace cusp::ui {
namespace {

/// Between the two threads; the watching one keeps it alive.
struct Shared {
  std::mutex mutex;  // held for a copy, never while anything is asked
  std::condition_variable stopped;
  std::vector<FoundDevice> found = with_software_devices({});
  bool answered = false, changed = false, stop = false;
};

void watch_devices(Shared& shared, const std::function<std::unique_ptr<DeviceWatch>()>& make, std::chrono::milliseconds every) {
  const std::unique_ptr<DeviceWatch> watch = make();
  std::unique_lock lock(shared.mutex);
  while (!shared.stop) {
    lock.unlock();
    std::vector<FoundDevice> found;
    const bool news = watch->changed();
    if (news) found = watch->list();
    lock.lock();
    if (news && (!shared.answered || found != shared.found)) {
      shared.found = std::move(found);
      shared.answered = shared.changed = true;
    }
    shared.stopped.wait_for(lock, every, [&shared] { return shared.stop; });
  }
}

class BackgroundWatch final : public DeviceWatch {
 public:
  BackgroundWatch(std::function<std::unique_ptr<DeviceWatch>()> make, std::chrono::milliseconds every)
      : task_([shared = shared_, make = std::move(make), every] { watch_devices(*shared, make, every); }, BackgroundTask::Holds::nothing) {}
  ~BackgroundWatch() override {
    const std::lock_guard lock(shared_->mutex);
    shared_->stop = true;
    shared_->stopped.notify_all();
  }
  std::vector<FoundDevice> list() override {
    const std::lock_guard lock(shared_->mutex);
    return shared_->found;
  }
  bool changed() noexcept override {
    const std::lock_guard lock(shared_->mutex);
    return std::exchange(shared_->changed, false);
  }

 private:
  std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
  BackgroundTask task_;
};

}  // namespace

std::unique_ptr<DeviceWatch> watch_in_background(std::function<std::unique_ptr<DeviceWatch>()> make,
                                                 std::chrono::milliseconds every) {
  return std::make_unique<BackgroundWatch>(std::move(make), every);
}

}  // namespace cusp::ui
