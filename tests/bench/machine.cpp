#include "tests/bench/machine.h"

#include <filesystem>
#include <fstream>

namespace cusp::bench {

namespace {

std::string read_first_line(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

}  // namespace

std::string commit_of_tree() {
  namespace fs = std::filesystem;
  fs::path git = fs::path(CUSP_BENCH_SOURCE) / ".git";
  std::error_code none;
  if (fs::is_regular_file(git, none)) {
    // A linked working tree: the file names the folder.
    const std::string line = read_first_line(git);
    if (!line.starts_with("gitdir: ")) return "unknown";
    git = line.substr(8);
  }
  const std::string head = read_first_line(git / "HEAD");
  if (!head.starts_with("ref: ")) return head.empty() ? "unknown" : head;
  const std::string name = head.substr(5);
  fs::path common = git;
  if (const std::string line = read_first_line(git / "commondir"); !line.empty()) common = git / line;
  if (std::string id = read_first_line(common / name); !id.empty()) return id;
  std::ifstream packed(common / "packed-refs");
  for (std::string line; std::getline(packed, line);)
    if (line.size() > 41 && line.substr(41) == name) return line.substr(0, 40);
  return "unknown";
}

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
