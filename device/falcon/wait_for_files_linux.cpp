#include <poll.h>

#include <array>
#include <cstddef>

#include "device/falcon/wait_for_files.h"

namespace cusp::device::falcon {

void wait_for_files(std::span<const WatchedFile> files, std::chrono::nanoseconds at_most) noexcept {
  std::array<pollfd, 16> polled{};
  std::size_t count = 0;
  for (const WatchedFile& file : files) {
    if (count == polled.size()) break;
    polled[count++] = {file.descriptor, file.events, 0};
  }
  if (at_most < std::chrono::nanoseconds(0)) at_most = std::chrono::nanoseconds(0);
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(at_most);
  const timespec time{static_cast<time_t>(seconds.count()), static_cast<long>((at_most - seconds).count())};
  static_cast<void>(
      ppoll(polled.data(), count, &time, nullptr));  // interrupted, it returns early: the caller looks again
}

}  // namespace cusp::device::falcon
