#include "tests/bench/machine.h"

#include <fstream>

#include "bench_commit.h"

namespace cusp::bench {

std::string commit_of_build() { return kCommit; }

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) {
      const std::size_t colon = line.find(": ");
      if (colon != std::string::npos) return line.substr(colon + 2);
    }
  return "unknown";
}

}  // namespace cusp::bench
