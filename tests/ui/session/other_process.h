/// A second process that holds a database's write lock, as a program that writes something long does.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <thread>

#include "storage/sqlite/database.h"
#include "tests/modules.h"

namespace cusp::test {

class LockHolder {
 public:
  /// Make it before the test has threads or opens the database: what SQLite keeps of a file may not go through a fork.
  explicit LockHolder(const std::filesystem::path& database) {
    int answer[2], wait[2];
    if (pipe(answer) != 0 || pipe(wait) != 0) return;
    child_ = fork();
    if (child_ == 0) {
      close(answer[0]);
      close(wait[1]);
      hold_lock(database, answer[1], wait[0]);
    }
    close(answer[1]);
    close(wait[0]);
    answers_ = answer[0];
    asks_ = wait[1];
  }
  ~LockHolder() { release(); }
  LockHolder(const LockHolder&) = delete;
  LockHolder& operator=(const LockHolder&) = delete;

  /// True when it holds the lock: for so long, or with zero until release(). Once.
  bool take(std::chrono::milliseconds hold = {}) {
    const std::int64_t ms = hold.count();
    char byte = 0;
    return write(asks_, &ms, sizeof ms) == sizeof ms && read(answers_, &byte, 1) == 1;
  }
  void release() {
    if (asks_ < 0) return;
    close(asks_);
    close(answers_);
    asks_ = -1;
    waitpid(child_, nullptr, 0);
  }

 private:
  [[noreturn]] static void hold_lock(const std::filesystem::path& file, int answer, int wait) {
    std::int64_t ms = 0;
    if (read(wait, &ms, sizeof ms) != sizeof ms) _exit(1);
    {
      auto database = Database::open(file);
      if (!database) _exit(1);
      Transaction transaction(*database);
      char byte = 1;
      if (!transaction.ok() || write(answer, &byte, 1) != 1) _exit(1);
      if (ms > 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(ms));
      } else if (read(wait, &byte, 1) < 0) {
        _exit(1);
      }
    }
    _exit(0);
  }

  pid_t child_ = -1;
  int answers_ = -1, asks_ = -1;
};

}  // namespace cusp::test
