/// Waits for files to become ready, with the system's resolution: libusb rounds a wait up to whole milliseconds.
#pragma once

#include <chrono>
#include <span>

namespace cusp::device::falcon {

struct WatchedFile {
  int descriptor = -1;
  short events = 0;  // poll() events, from libusb
};

/// Returns when a file is ready or the time is over. Watches at most 16 files.
void wait_for_files(std::span<const WatchedFile> files, std::chrono::nanoseconds at_most) noexcept;

}  // namespace cusp::device::falcon
