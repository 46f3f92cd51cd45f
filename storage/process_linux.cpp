#include <unistd.h>

#include <charconv>
#include <fstream>
#include <sstream>

#include "storage/process.h"

namespace cusp {
namespace {

std::string boot_id() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  std::getline(file, id);
  return id;
}

/// Clock ticks after boot at which the process began (field 22 of /proc/PID/stat); empty when there is none, or only
/// what is left of one that has ended.
std::string start_time(long process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string line;
  std::getline(file, line);
  const auto name_end = line.rfind(')');  // the name may hold spaces and brackets
  if (name_end == std::string::npos) return {};
  std::istringstream words(line.substr(name_end + 1));
  std::string word;
  for (int field = 3; field <= 22; ++field) {
    if (!(words >> word)) return {};
    if (field == 3 && (word == "Z" || word == "X")) return {};
  }
  return word;
}

}  // namespace

std::string this_process() {
  const long process = getpid();
  return boot_id() + ":" + std::to_string(process) + ":" + start_time(process);
}

bool process_runs(const std::string& process) {
  const auto first = process.find(':');
  const auto second = process.find(':', first == std::string::npos ? first : first + 1);
  if (first == std::string::npos || second == std::string::npos) return false;
  if (process.substr(0, first) != boot_id()) return false;
  long number = 0;
  const char* begin = process.data() + first + 1;
  const char* end = process.data() + second;
  if (const auto read = std::from_chars(begin, end, number); read.ptr != end || number <= 0) return false;
  const std::string started = start_time(number);
  return !started.empty() && started == process.substr(second + 1);
}

}  // namespace cusp
