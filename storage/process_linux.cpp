#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <fstream>
#include <optional>
#include <random>
#include <sstream>
#include <vector>

#include "storage/process.h"

namespace cusp::storage {
namespace {

std::string boot_id() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  std::getline(file, id);
  return id;
}

/// "4026531836"; empty where /proc does not tell.
std::string pid_namespace() {
  char text[64];
  const ssize_t size = readlink("/proc/self/ns/pid", text, sizeof text);
  const std::string name(text, size > 0 ? static_cast<std::size_t>(size) : 0);  // "pid:[4026531836]"
  const auto open = name.find('['), close = name.find(']');
  return open == std::string::npos || close == std::string::npos ? std::string() : name.substr(open + 1, close - open - 1);
}

struct Stat {
  bool over = false;  // only what is left of a process that has ended
  std::string start;  // clock ticks after boot (field 22 of /proc/PID/stat)
};

/// nullopt: not there, or not for this user to see.
std::optional<Stat> stat_of(long process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string line;
  std::getline(file, line);
  const auto name_end = line.rfind(')');  // the name may hold spaces and brackets
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream words(line.substr(name_end + 1));
  Stat stat;
  std::string word;
  for (int field = 3; field <= 22; ++field) {
    if (!(words >> word)) return std::nullopt;
    if (field == 3) stat.over = word == "Z" || word == "X";
  }
  stat.start = word;
  return stat;
}

template <class Number>
std::optional<Number> number_of(const std::string& text) {
  Number number = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc{} || read.ptr != end || number <= 0) return std::nullopt;
  return number;
}

struct flock place_lock(off_t place, short kind) {
  struct flock lock{};
  lock.l_type = kind;
  lock.l_whence = SEEK_SET;
  lock.l_start = place;
  lock.l_len = 1;
  return lock;
}

/// Whether some process holds the place; nullopt where that cannot be asked.
std::optional<bool> held(const std::filesystem::path& lock_file, off_t place) {
  const int descriptor = open(lock_file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  struct flock lock = place_lock(place, F_WRLCK);
  const bool asked = fcntl(descriptor, F_OFD_GETLK, &lock) == 0;
  close(descriptor);
  if (!asked) return std::nullopt;
  return lock.l_type != F_UNLCK;
}

/// By its number, which means something in one pid namespace alone; nullopt where that does not decide.
std::optional<bool> runs_by_number(pid_t number, const std::string& start) {
  if (kill(number, 0) != 0 && errno == ESRCH) return false;
  const auto stat = stat_of(number);
  if (!stat) return std::nullopt;  // it, or another of its number, is hidden from this user
  return !stat->over && stat->start == start;
}

}  // namespace

ProcessMark::ProcessMark(const std::filesystem::path& lock_file) {
  const long number = getpid();
  const auto stat = stat_of(number);
  text_ = boot_id() + ":" + std::to_string(number) + ":" + (stat ? stat->start : std::string()) + ":" + pid_namespace() + ":";
  // A lock of the open file: unlike a process's, no other close of the same file drops it, and it needs no pid.
  // Every user of the database may read it.
  descriptor_ = open(lock_file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor_ < 0) return;
  std::random_device dice;
  for (int tries = 0; tries < 8; ++tries) {
    const auto place = static_cast<off_t>((std::uint64_t{dice()} << 31 ^ dice()) & 0x3FFFFFFFFFFFFFFF) + 1;
    struct flock lock = place_lock(place, F_WRLCK);
    if (fcntl(descriptor_, F_OFD_SETLK, &lock) != 0) continue;
    text_ += std::to_string(place);
    return;
  }
}

ProcessMark::~ProcessMark() {
  if (descriptor_ >= 0) close(descriptor_);
}

bool process_runs(const std::string& process, const std::filesystem::path& lock_file) {
  std::vector<std::string> words(1);
  for (const char c : process) {
    if (c == ':') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  if ((words.size() != 3 && words.size() != 5) || words[0] != boot_id()) return false;
  const auto number = number_of<pid_t>(words[1]);
  if (!number) return false;
  const bool same_namespace = words.size() == 3 || words[3] == pid_namespace();
  if (same_namespace) {
    if (const auto known = runs_by_number(*number, words[2])) return *known;
  }
  const auto place = words.size() == 5 ? number_of<off_t>(words[4]) : std::nullopt;
  if (!place) return true;
  return held(lock_file, *place).value_or(true);
}

}  // namespace cusp::storage
