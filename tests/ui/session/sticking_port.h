/// A device whose driver a test holds up.
#pragma once

#include <atomic>
#include <memory>

#include "tests/engine/loop/block_scene.h"
#include "tests/modules.h"

namespace cusp::test {

/// Its driver does not come back while `stuck`.
class StickingPort final : public DrillingPort {
 public:
  explicit StickingPort(std::shared_ptr<std::atomic<bool>> stuck) : DrillingPort(1u << 30, Pace::to_deadline), stuck_(std::move(stuck)) {}
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override {
    stuck_->wait(true);
    return DrillingPort::wait(deadline);
  }

 private:
  std::shared_ptr<std::atomic<bool>> stuck_;
};

}  // namespace cusp::test
