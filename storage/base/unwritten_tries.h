/// Wrong tries at sign-in that no row can keep, since the records are read-only: they end with the program. Any thread.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>

#include "engine/base/ids.h"

namespace cusp::storage {

class UnwrittenTries {
 public:
  /// Adds one. How many there are now.
  std::int64_t count(UserId user) {
    const std::lock_guard hold(mutex_);
    return ++tries_[user].wrong;
  }
  void lock(UserId user, std::int64_t until_utc_us) {
    const std::lock_guard hold(mutex_);
    tries_[user].locked_until_utc_us = until_utc_us;
  }
  /// 0: never locked.
  std::int64_t locked_until(UserId user) {
    const std::lock_guard hold(mutex_);
    const auto found = tries_.find(user);
    return found == tries_.end() ? 0 : found->second.locked_until_utc_us;
  }
  void forget(UserId user) {
    const std::lock_guard hold(mutex_);
    tries_.erase(user);
  }

 private:
  struct Tries {
    std::int64_t wrong = 0, locked_until_utc_us = 0;
  };
  std::mutex mutex_;
  std::map<UserId, Tries> tries_;
};

}  // namespace cusp::storage
