#include "ui/session/keep_awake.h"

#include <systemd/sd-bus.h>

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <utility>

namespace cusp::ui {

/// Between whoever keeps awake and the thread that asks the bus.
struct KeepAwake::Shared {
  std::mutex mutex;
  std::condition_variable ended;
  bool over = false;

  void wait() {
    std::unique_lock lock(mutex);
    ended.wait(lock, [this] { return over; });
  }
};

namespace {

constexpr const char* kSaver = "org.freedesktop.ScreenSaver";
constexpr const char* kSaverPath = "/org/freedesktop/ScreenSaver";
constexpr std::uint64_t kSaverAnswerUs = 1'000'000;

/// The number under which the desktop keeps the wish; 0: it has not taken it.
std::uint32_t inhibit(sd_bus* bus, const std::string& why) {
  sd_bus_message* answer = nullptr;
  std::uint32_t cookie = 0;
  if (sd_bus_call_method(bus, kSaver, kSaverPath, kSaver, "Inhibit", nullptr, &answer, "ss", "Cusp", why.c_str()) >= 0 &&
      sd_bus_message_read(answer, "u", &cookie) < 0) {
    cookie = 0;
  }
  sd_bus_message_unref(answer);
  return cookie;
}

}  // namespace

KeepAwake::KeepAwake(std::string why) : shared_(std::make_shared<Shared>()) {
  task_ = BackgroundTask([shared = shared_, why = std::move(why)] {
    [[gnu::cleanup(sd_bus_flush_close_unrefp)]] sd_bus* bus = nullptr;
    if (sd_bus_open_user(&bus) < 0) return;
    sd_bus_set_method_call_timeout(bus, kSaverAnswerUs);
    const std::uint32_t cookie = inhibit(bus, why);
    if (cookie == 0) return;
    shared->wait();  // the desktop forgets the wish of a connection that goes
    sd_bus_call_method(bus, kSaver, kSaverPath, kSaver, "UnInhibit", nullptr, nullptr, "u", cookie);
  }, BackgroundTask::Holds::nothing);
}

KeepAwake::~KeepAwake() {
  const std::lock_guard lock(shared_->mutex);
  shared_->over = true;
  shared_->ended.notify_all();
}

}  // namespace cusp::ui
