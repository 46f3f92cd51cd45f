#include "engine/loop/rtkit.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <systemd/sd-bus.h>
#include <unistd.h>

#include <algorithm>

namespace cusp::engine {

namespace {

constexpr const char* kName = "org.freedesktop.RealtimeKit1";
constexpr const char* kPath = "/org/freedesktop/RealtimeKit1";
constexpr std::uint64_t kAnswerUs = 1'000'000;

}  // namespace

RtkitAnswer ask_rtkit(int& priority) noexcept {
  [[gnu::cleanup(sd_bus_flush_close_unrefp)]] sd_bus* bus = nullptr;
  if (sd_bus_open_system(&bus) < 0) return RtkitAnswer::absent;
  sd_bus_set_method_call_timeout(bus, kAnswerUs);

  std::int32_t most = 0;
  if (sd_bus_get_property_trivial(bus, kName, kPath, kName, "MaxRealtimePriority", nullptr, 'i', &most) < 0)
    return RtkitAnswer::absent;
  std::int64_t run_us = 0;
  if (sd_bus_get_property_trivial(bus, kName, kPath, kName, "RTTimeUSecMax", nullptr, 'x', &run_us) < 0)
    return RtkitAnswer::absent;
  if (most < 1 || run_us < 1) return RtkitAnswer::refused;

  rlimit limit{};
  if (getrlimit(RLIMIT_RTTIME, &limit) != 0) return RtkitAnswer::refused;
  const auto wanted = static_cast<rlim_t>(run_us);
  if (limit.rlim_max > wanted) limit.rlim_max = wanted;
  limit.rlim_cur = std::min(limit.rlim_max, wanted);
  if (setrlimit(RLIMIT_RTTIME, &limit) != 0) return RtkitAnswer::refused;

  priority = std::min(priority, static_cast<int>(most));
  const auto thread = static_cast<std::uint64_t>(syscall(SYS_gettid));
  const int called = sd_bus_call_method(bus, kName, kPath, kName, "MakeThreadRealtime", nullptr, nullptr, "tu", thread,
                                        static_cast<std::uint32_t>(priority));
  return called < 0 ? RtkitAnswer::refused : RtkitAnswer::granted;
}

}  // namespace cusp::engine
