/// One child process with limits, its lines and its end. Knows nothing of imports.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace cusp::scenarios {

struct ChildLimits {
  std::size_t memory_bytes = 0;  // of address space; 0: none
  std::chrono::seconds cpu{0};   // 0: none
  std::chrono::milliseconds wall{0};  // 0: none
};

struct ChildEnd {
  enum class How : std::uint8_t { exited, crashed, cpu_limit, wall_limit, stopped, not_started };
  How how = How::not_started;
  int code = 0;         // exit status, or the signal's number
  std::string errors;   // the last 2 KiB of its standard error
  /// What it took, with all that it started and waited for.
  double wall_s = 0.0, cpu_s = 0.0;
  std::uint64_t resident_bytes = 0;  // at most
};

/// Whether memory_bytes can be kept in this build: AddressSanitizer reserves terabytes of address space for itself.
bool child_memory_limit_works() noexcept;

/// Path by which this program can be started again, whatever happened to its file since.
std::string own_program();

/// Starts argv[0] (a path) with argv, no standard input, standard output and error caught; blocks until it has ended.
/// `line` gets each line of its standard output, without the line's end, on the calling thread; lines above 64 KiB are
/// dropped. A stop request or a limit kills it and all that it started, within 50 ms. It dies with this thread.
/// It inherits nothing open but the three standard streams, and writes no core file.
ChildEnd run_child(const std::vector<std::string>& argv, const ChildLimits& limits,
                   const std::function<void(std::string_view)>& line, std::stop_token stop);

}  // namespace cusp::scenarios
