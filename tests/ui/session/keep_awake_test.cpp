// What keeps the screen on, against a fake screen saver on the test's own bus (dbus-run-session).
#include "ui/session/keep_awake.h"

#include <gtest/gtest.h>
#include <systemd/sd-bus.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <thread>

#include "tests/eventually.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

constexpr const char* kSaverName = "org.freedesktop.ScreenSaver";
constexpr std::uint32_t kCookie = 7;

/// Counts the wishes that it has been given and not been asked to forget, on a thread of its own while it lives.
class Saver {
 public:
  Saver() {
    EXPECT_GE(sd_bus_open_user(&bus_), 0);
    EXPECT_GE(sd_bus_add_object(bus_, nullptr, "/org/freedesktop/ScreenSaver", &Saver::answer, this), 0);
    EXPECT_GE(sd_bus_request_name(bus_, kSaverName, 0), 0);
    thread_ = std::thread([this] {
      while (!stop_) {
        while (sd_bus_process(bus_, nullptr) > 0) continue;
        sd_bus_wait(bus_, 10'000);
      }
    });
  }
  ~Saver() {
    stop_ = true;
    thread_.join();
    sd_bus_flush_close_unref(bus_);
  }
  Saver(const Saver&) = delete;
  Saver& operator=(const Saver&) = delete;
  int wishes() const { return wishes_; }

 private:
  static int answer(sd_bus_message* call, void* self, sd_bus_error*) {
    auto& saver = *static_cast<Saver*>(self);
    if (sd_bus_message_is_method_call(call, kSaverName, "Inhibit") > 0) {
      ++saver.wishes_;
      return sd_bus_reply_method_return(call, "u", kCookie);
    }
    std::uint32_t cookie = 0;
    if (sd_bus_message_is_method_call(call, kSaverName, "UnInhibit") <= 0 || sd_bus_message_read(call, "u", &cookie) < 0) return 0;
    if (cookie == kCookie) --saver.wishes_;
    return sd_bus_reply_method_return(call, "");
  }

  sd_bus* bus_ = nullptr;
  std::atomic<bool> stop_{false};
  std::atomic<int> wishes_{0};
  std::thread thread_;
};

TEST(KeepAwake, asks_the_screen_saver_while_it_stands_and_no_longer) {
  const Saver saver;
  {
    const KeepAwake awake("An attempt is running");
    EXPECT_TRUE(eventually([&] { return saver.wishes() == 1; }));
  }
  wait_for_dropped_tasks();
  EXPECT_EQ(saver.wishes(), 0);
}

TEST(KeepAwake, does_nothing_where_nobody_answers_or_there_is_no_bus) {
  { const KeepAwake awake("An attempt is running"); }
  wait_for_dropped_tasks();
  const std::string bus = std::getenv("DBUS_SESSION_BUS_ADDRESS");
  setenv("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nowhere/at/all", 1);
  { const KeepAwake awake("An attempt is running"); }
  wait_for_dropped_tasks();
  setenv("DBUS_SESSION_BUS_ADDRESS", bus.c_str(), 1);
}

}  // namespace
}  // namespace cusp::test

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  if (std::getenv("DBUS_SESSION_BUS_ADDRESS") == nullptr) return 2;  // has to run under dbus-run-session
  return RUN_ALL_TESTS();
}
