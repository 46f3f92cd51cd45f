#include "storage/repositories/sign_in_lock.h"

#include <algorithm>
#include <string>

#include "storage/base/unwritten_tries.h"
#include "storage/records/audit_writer.h"

namespace cusp::storage {
namespace {

constexpr int kFreeTries = 5;
constexpr std::int64_t kFirstLock_us = 30'000'000, kLongestLock_us = 900'000'000;

std::int64_t lock_us(std::int64_t wrong_tries) noexcept {
  if (wrong_tries < kFreeTries) return 0;
  const auto doublings = std::min<std::int64_t>(wrong_tries - kFreeTries, 5);
  return std::min(kFirstLock_us << doublings, kLongestLock_us);
}

}  // namespace

bool lock_holds(std::int64_t locked_until, std::int64_t now) noexcept { return locked_until > now && locked_until - now <= kLongestLock_us; }

StorageFailure locked_failure(std::int64_t locked_until) { return {StorageError::locked, "sign_in", std::to_string(locked_until)}; }

std::int64_t locked_until(StorageContext& c, UserId user, std::int64_t written, std::int64_t now) {
  const std::int64_t in_memory = c.tries->locked_until(user);
  return lock_holds(in_memory, now) && !(lock_holds(written, now) && written > in_memory) ? in_memory : written;
}

void count_wrong_try(StorageContext& c, Transaction& transaction, UserId user, std::int64_t now) {
  const auto tries = transaction.first(
      "UPDATE people SET wrong_tries = wrong_tries + 1 WHERE id = ?1 RETURNING wrong_tries",
      [](Row row) { return row.integer(0); }, user);
  if (const auto lock = lock_us(tries.value_or(0)); lock > 0) {
    transaction.run("UPDATE people SET locked_until = ?2 WHERE id = ?1", user, now + lock);
  }
  log_event(c, transaction,
            {.action = "sign_in_failed",
             .subject = user.uuid,
             .detail = std::to_string(tries.value_or(0))});
}

void count_unwritten_try(StorageContext& c, UserId user, std::int64_t now) {
  if (const auto lock = lock_us(c.tries->count(user)); lock > 0) c.tries->lock(user, now + lock);
}

}  // namespace cusp::storage
