/// A store whose accounts tests make, with a clock that they set.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "tests/storage/sample.h"

namespace cusp::test {

class AccountsTest : public ::testing::Test {
 protected:
  Folder folder;
  std::shared_ptr<std::int64_t> now = std::make_shared<std::int64_t>(kNow);
  std::unique_ptr<Store> store = open(folder / "a.db", quick(now));
  Accounts& accounts = store->accounts;
  std::function<void()> meanwhile;  // once, when the other process has read the account and the clock

  /// At the same records.
  std::unique_ptr<Store> other_process() {
    StoreOptions options = quick(now);
    options.clock = [this] {
      const std::int64_t read = *now;
      if (const auto act = std::exchange(meanwhile, {})) act();
      return read;
    };
    return open(folder / "a.db", options);
  }
};

}  // namespace cusp::test
