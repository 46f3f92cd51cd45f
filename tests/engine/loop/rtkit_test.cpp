// The bus calls to the service, against a fake one on the test's own bus (dbus-run-session). It grants nothing: the
// test checks the requests and the effect of the answers.
#include "engine/loop/rtkit.h"
#include "tests/modules.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <systemd/sd-bus.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <thread>

namespace cusp::test {
namespace {

struct Kit {
  std::int32_t most = 20;
  std::int64_t run_us = 200'000;
  bool refuses = false;
  std::atomic<std::uint64_t> thread{0};
  std::atomic<std::uint32_t> priority{0};

  static int make(sd_bus_message* message, void* self, sd_bus_error* error) {
    auto& kit = *static_cast<Kit*>(self);
    std::uint64_t thread = 0;
    std::uint32_t priority = 0;
    if (const int read = sd_bus_message_read(message, "tu", &thread, &priority); read < 0) return read;
    kit.thread = thread;
    kit.priority = priority;
    if (kit.refuses) return sd_bus_error_set_errno(error, EPERM);
    return sd_bus_reply_method_return(message, "");
  }
  static int property(sd_bus*, const char*, const char*, const char* name, sd_bus_message* reply, void* self, sd_bus_error*) {
    auto& kit = *static_cast<Kit*>(self);
    if (std::string_view(name) == "RTTimeUSecMax") return sd_bus_message_append(reply, "x", kit.run_us);
    return sd_bus_message_append(reply, "i", kit.most);
  }
};

const sd_bus_vtable kTable[] = {
    SD_BUS_VTABLE_START(0),
    SD_BUS_METHOD("MakeThreadRealtime", "tu", "", &Kit::make, SD_BUS_VTABLE_UNPRIVILEGED),
    SD_BUS_PROPERTY("MaxRealtimePriority", "i", &Kit::property, 0, SD_BUS_VTABLE_PROPERTY_CONST),
    SD_BUS_PROPERTY("RTTimeUSecMax", "x", &Kit::property, 0, SD_BUS_VTABLE_PROPERTY_CONST),
    SD_BUS_VTABLE_END,
};

/// Answers on a thread of its own while it lives.
class Service {
 public:
  explicit Service(Kit& kit) {
    EXPECT_GE(sd_bus_open_system(&bus_), 0);
    EXPECT_GE(sd_bus_add_object_vtable(bus_, nullptr, "/org/freedesktop/RealtimeKit1", "org.freedesktop.RealtimeKit1", kTable,
                                       &kit),
              0);
    EXPECT_GE(sd_bus_request_name(bus_, "org.freedesktop.RealtimeKit1", 0), 0);
    thread_ = std::thread([this] {
      while (!stop_) {
        while (sd_bus_process(bus_, nullptr) > 0) continue;
        sd_bus_wait(bus_, 10'000);
      }
    });
  }
  ~Service() {
    stop_ = true;
    thread_.join();
    sd_bus_flush_close_unref(bus_);
  }

 private:
  sd_bus* bus_ = nullptr;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

TEST(Rtkit, is_asked_for_this_thread_with_a_priority_that_it_may_give) {
  Kit kit;
  const Service service(kit);
  int priority = 15;
  EXPECT_EQ(ask_rtkit(priority), RtkitAnswer::granted);
  EXPECT_EQ(kit.thread, static_cast<std::uint64_t>(syscall(SYS_gettid)));
  EXPECT_EQ(kit.priority, 15u);
  EXPECT_EQ(priority, 15);
  rlimit limit{};
  getrlimit(RLIMIT_RTTIME, &limit);
  EXPECT_LE(limit.rlim_max, 200'000u);  // else it refuses
}

TEST(Rtkit, gives_less_than_was_asked_where_it_has_less) {
  Kit kit;
  kit.most = 5;
  const Service service(kit);
  int priority = 15;
  EXPECT_EQ(ask_rtkit(priority), RtkitAnswer::granted);
  EXPECT_EQ(kit.priority, 5u);
  EXPECT_EQ(priority, 5);
}

TEST(Rtkit, says_no_and_that_is_a_refusal) {
  Kit kit;
  kit.refuses = true;
  const Service service(kit);
  int priority = 15;
  EXPECT_EQ(ask_rtkit(priority), RtkitAnswer::refused);
  EXPECT_NE(kit.thread, 0u);
}

TEST(Rtkit, has_nothing_to_give) {
  Kit kit;
  kit.most = 0;
  const Service service(kit);
  int priority = 15;
  EXPECT_EQ(ask_rtkit(priority), RtkitAnswer::refused);
  EXPECT_EQ(kit.thread, 0u);
}

TEST(Rtkit, is_not_there_or_there_is_no_bus) {
  int priority = 15;
  EXPECT_EQ(ask_rtkit(priority), RtkitAnswer::absent);
  const std::string bus = std::getenv("DBUS_SYSTEM_BUS_ADDRESS");
  setenv("DBUS_SYSTEM_BUS_ADDRESS", "unix:path=/nowhere/at/all", 1);
  EXPECT_EQ(ask_rtkit(priority), RtkitAnswer::absent);
  setenv("DBUS_SYSTEM_BUS_ADDRESS", bus.c_str(), 1);
}

}  // namespace
}  // namespace cusp::test

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const char* own = std::getenv("DBUS_SESSION_BUS_ADDRESS");
  if (own == nullptr) return 2;  // has to run under dbus-run-session
  setenv("DBUS_SYSTEM_BUS_ADDRESS", own, 1);
  return RUN_ALL_TESTS();
}
