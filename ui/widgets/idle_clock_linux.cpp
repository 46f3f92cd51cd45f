#include <ctime>

#include "ui/widgets/idle_watch.h"

namespace cusp::ui {

std::chrono::milliseconds time_since_boot() {
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return std::chrono::milliseconds(now.tv_sec * 1000LL + now.tv_nsec / 1'000'000);
}

}  // namespace cusp::ui
