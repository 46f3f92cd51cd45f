#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <fstream>
#include <optional>
#include <random>
#include <sstream>
#include <vector>

#include "storage/base/process.h"

namespace cusp::storage {
namespace {

std::string boot_id() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  std::getline(file, id);
  return id;
}

/// "4026531836"; empty if /proc does not have it.
std::string pid_namespace() {
  char text[64];
  const ssize_t size = readlink("/proc/self/ns/pid", text, sizeof text);
  const std::string name(text, size > 0 ? static_cast<std::size_t>(size) : 0);  // "pid:[4026531836]"
  const auto open = name.find('['), close = name.find(']');
  return open == std::string::npos || close == std::string::npos ? std::string() : name.substr(open + 1, close - open - 1);
}

struct Stat {
  bool ended = false;  // a zombie, or dead
  std::string start;  // clock ticks after boot (field 22 of /proc/PID/stat)
};

/// nullopt: no such process, or hidden from this user.
std::optional<Stat> stat_of(long process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string line;
  std::getline(file, line);
  const auto name_end = line.rfind(')');  // the name may hold spaces and brackets
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(line.substr(name_end + 1));
  Stat stat;
  std::string field;
  for (int number = 3; number <= 22; ++number) {
    if (!(fields >> field)) return std::nullopt;
    if (number == 3) stat.ended = field == "Z" || field == "X";
  }
  stat.start = field;
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

/// Whether a process holds the lock on the byte; nullopt if the system gives no answer.
std::optional<bool> held(const std::filesystem::path& lock_file, off_t place) {
  // O_NONBLOCK does not wait for the other end of a pipe, which holds no lock of anybody.
  const int descriptor = open(lock_file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return std::nullopt;
  struct stat about{};
  struct flock lock = place_lock(place, F_WRLCK);
  const bool asked = fstat(descriptor, &about) == 0 && S_ISREG(about.st_mode) && fcntl(descriptor, F_OFD_GETLK, &lock) == 0;
  close(descriptor);
  if (!asked) return std::nullopt;
  return lock.l_type != F_UNLCK;
}

/// By process id, valid within one pid namespace; nullopt if that does not decide.
std::optional<bool> runs_by_number(pid_t number, const std::string& start) {
  if (kill(number, 0) != 0 && errno == ESRCH) return false;
  const auto stat = stat_of(number);
  if (!stat) return std::nullopt;  // a process of this id is hidden from this user
  return !stat->ended && stat->start == start;
}

}  // namespace

ProcessMark::ProcessMark(const std::filesystem::path& lock_file) {
  const long number = getpid();
  const auto stat = stat_of(number);
  text_ = boot_id() + ":" + std::to_string(number) + ":" + (stat ? stat->start : std::string()) + ":" + pid_namespace() + ":";
  // An open file description lock: unlike a process lock, closing another descriptor does not drop it, and it has no pid.
  // Every user of the database may read the file.
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
  std::vector<std::string> fields(1);
  for (const char c : process) {
    if (c == ':') {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  if ((fields.size() != 3 && fields.size() != 5) || fields[0] != boot_id()) return false;
  const auto number = number_of<pid_t>(fields[1]);
  if (!number) return false;
  const bool same_namespace = fields.size() == 3 || fields[3] == pid_namespace();
  if (same_namespace) {
    if (const auto known = runs_by_number(*number, fields[2])) return *known;
  }
  const auto place = fields.size() == 5 ? number_of<off_t>(fields[4]) : std::nullopt;
  if (!place) return true;
  return held(lock_file, *place).value_or(true);
}

}  // namespace cusp::storage
