#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "scenarios/import/child_process.h"

extern char** environ;

namespace cusp::scenarios {
namespace {

constexpr std::size_t kMaxLine = 65536;
constexpr std::size_t kKeptErrors = 2048;
constexpr int kPollMs = 50;
constexpr int kExecFailed = 127;

/// The same stream under a number above 2, as a program whose own standard streams are closed may get those.
int above_standard(int fd) noexcept {
  if (fd < 0 || fd > 2) return fd;
  const int moved = fcntl(fd, F_DUPFD_CLOEXEC, 3);
  close(fd);
  return moved;
}

/// Closes itself. Both ends are closed on exec; the child's own ends live on as copies on 1 and 2.
struct Pipe {
  int read = -1, write = -1;
  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return;
    read = above_standard(ends[0]);
    write = above_standard(ends[1]);
  }
  ~Pipe() {
    close_read();
    close_write();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_read() {
    if (read >= 0) close(read);
    read = -1;
  }
  void close_write() {
    if (write >= 0) close(write);
    write = -1;
  }
};

void limit(__rlimit_resource_t what, rlim_t soft, rlim_t hard) noexcept {
  const rlimit value{soft, hard};
  setrlimit(what, &value);
}

using Clock = std::chrono::steady_clock;

/// File descriptors that the child takes as its own.
struct ChildStreams {
  int in = -1, out = -1, errors = -1;
};

/// Runs between fork and exec: async-signal-safe calls only.
[[noreturn]] void exec_child(char* const* argv, char* const* environment, const ChildStreams& streams, const ChildLimits& limits,
                             pid_t parent) noexcept {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kExecFailed);  // the parent ended before prctl
  dup2(streams.in, 0);
  dup2(streams.out, 1);
  dup2(streams.errors, 2);
  syscall(SYS_close_range, 3u, ~0u, 0u);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  limit(RLIMIT_CORE, 0, 0);
  if (limits.memory_bytes > 0 && child_memory_limit_works()) limit(RLIMIT_AS, limits.memory_bytes, limits.memory_bytes);
  if (limits.cpu.count() > 0) {
    const auto seconds = static_cast<rlim_t>(limits.cpu.count());
    limit(RLIMIT_CPU, seconds, seconds + 1);  // SIGKILL a second later, if it ignores SIGXCPU
  }
  execve(argv[0], argv, environment);
  _exit(kExecFailed);
}

/// Calls `line` for each whole line; keeps the rest.
class LineReader {
 public:
  explicit LineReader(const std::function<void(std::string_view)>& line) : line_(line) {}
  void feed(std::string_view bytes) {
    for (const char c : bytes) {
      if (c == '\n') {
        if (!overlong_) line_(kept_);
        kept_.clear();
        overlong_ = false;
      } else if (kept_.size() >= kMaxLine) {
        overlong_ = true;
      } else {
        kept_ += c;
      }
    }
  }

 private:
  const std::function<void(std::string_view)>& line_;
  std::string kept_;
  bool overlong_ = false;
};

/// Copies what is there to `take`; false at the end of the stream.
template <class Take>
bool drain(int fd, Take take) {
  std::array<char, 4096> buffer;
  const ssize_t n = read(fd, buffer.data(), buffer.size());
  if (n > 0) take(std::string_view(buffer.data(), static_cast<std::size_t>(n)));
  return n > 0 || (n < 0 && (errno == EINTR || errno == EAGAIN));
}

/// Decides when a running child must end: at a stop request or at its wall limit.
class Watch {
 public:
  Watch(Clock::time_point started, std::chrono::milliseconds wall, std::stop_token stop)
      : deadline_(started + wall), limited_(wall.count() > 0), stop_(std::move(stop)) {}
  bool must_end() {
    if (stop_.stop_requested()) why_ = ChildEnd::How::stopped;
    else if (limited_ && Clock::now() >= deadline_) why_ = ChildEnd::How::wall_limit;
    return ended();
  }
  /// Whether must_end() was ever true.
  bool ended() const noexcept { return why_ != ChildEnd::How::exited; }
  /// Pre: ended().
  ChildEnd::How why() const noexcept { return why_; }

 private:
  Clock::time_point deadline_;
  bool limited_;
  std::stop_token stop_;
  ChildEnd::How why_ = ChildEnd::How::exited;  // exited: it need not end
};

/// This program's environment with fewer malloc arenas: each reserves 64 MiB of address space, eight for every core, so
/// that a memory limit would depend on the machine.
std::vector<char*> child_environment() {
  static constexpr char kArenas[] = "MALLOC_ARENA_MAX=2";
  std::vector<char*> out{const_cast<char*>(kArenas)};
  for (char** e = environ; *e; ++e)
    if (std::strncmp(*e, "MALLOC_ARENA_MAX=", 17) != 0) out.push_back(*e);
  out.push_back(nullptr);
  return out;
}

/// Feeds `lines` until both streams end or the child must end; returns the last of its errors.
std::string read_streams(Pipe& out, Pipe& errors, LineReader& lines, Watch& watch) {
  std::string kept;
  while ((out.read >= 0 || errors.read >= 0) && !watch.must_end()) {
    pollfd ends[2] = {{out.read, POLLIN, 0}, {errors.read, POLLIN, 0}};
    if (poll(ends, 2, kPollMs) <= 0) continue;
    if (ends[0].revents && !drain(out.read, [&](std::string_view t) { lines.feed(t); })) out.close_read();
    if (ends[1].revents && !drain(errors.read, [&](std::string_view t) {
          kept += t;
          if (kept.size() > kKeptErrors) kept.erase(0, kept.size() - kKeptErrors);
        }))
      errors.close_read();
  }
  return kept;
}

/// Waits for the child's end, or kills its group; the status as of wait4(). A child that closed its streams is held to
/// the same limits.
int wait_for(pid_t pid, Watch& watch, rusage& used) {
  int status = 0;
  while (wait4(pid, &status, WNOHANG, &used) != pid) {
    if (watch.ended() || watch.must_end()) {
      kill(-pid, SIGKILL);
      while (wait4(pid, &status, 0, &used) < 0 && errno == EINTR) {
      }
      break;
    }
    poll(nullptr, 0, 1);
  }
  return status;
}

double seconds_of(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

ChildEnd end_of(int status) {
  ChildEnd end;
  if (WIFEXITED(status)) {
    end.how = ChildEnd::How::exited;
    end.code = WEXITSTATUS(status);
    if (end.code == kExecFailed) end.how = ChildEnd::How::not_started;
  } else {
    end.code = WTERMSIG(status);
    end.how = end.code == SIGXCPU ? ChildEnd::How::cpu_limit : ChildEnd::How::crashed;
  }
  return end;
}

}  // namespace

bool child_memory_limit_works() noexcept {
#ifdef CUSP_SANITIZED
  return false;
#else
  return true;
#endif
}

std::string own_program() { return "/proc/self/exe"; }

ChildEnd run_child(const std::vector<std::string>& argv, const ChildLimits& limits,
                   const std::function<void(std::string_view)>& line, std::stop_token stop) {
  ChildEnd end;
  Pipe out, errors;
  const int nothing = above_standard(open("/dev/null", O_RDONLY | O_CLOEXEC));
  if (out.read < 0 || out.write < 0 || errors.read < 0 || errors.write < 0 || nothing < 0) {
    end.errors = std::strerror(errno);
    if (nothing >= 0) close(nothing);
    return end;
  }
  std::vector<char*> arguments;
  for (const std::string& a : argv) arguments.push_back(const_cast<char*>(a.c_str()));
  arguments.push_back(nullptr);
  const std::vector<char*> environment = child_environment();

  const auto started = Clock::now();
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) exec_child(arguments.data(), environment.data(), {nothing, out.write, errors.write}, limits, parent);
  close(nothing);
  if (pid < 0) {
    end.errors = std::strerror(errno);
    return end;
  }
  setpgid(pid, pid);  // on both sides, so that the group exists whoever comes first
  out.close_write();
  errors.close_write();

  Watch watch(started, limits.wall, std::move(stop));
  LineReader lines(line);
  std::string kept_errors = read_streams(out, errors, lines, watch);
  rusage used{};
  const int status = wait_for(pid, watch, used);
  end = end_of(status);
  end.wall_s = std::chrono::duration<double>(Clock::now() - started).count();
  end.cpu_s = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  end.resident_bytes = static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
  if (watch.ended() && !WIFEXITED(status)) end.how = watch.why();
  end.errors = std::move(kept_errors);
  return end;
}

}  // namespace cusp::scenarios
