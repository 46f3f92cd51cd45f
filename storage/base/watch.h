/// Work that takes long reports where it is, and asks whether to go on. Thread: the work's own.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

namespace cusp::storage {

/// Called between two steps of a work: so many of so many are done; 0 of 0 while they are not counted. False ends the work. It throws
/// nothing and runs no statement on the work's database.
using WorkWatch = std::function<bool(std::size_t done, std::size_t all)>;

/// The steps of one work, and its watch, which is asked until it first answers false. Within storage only.
class WorkSteps {
 public:
  explicit WorkSteps(WorkWatch watch) : watch_{std::move(watch)} {}

  /// From here on so many steps are to be done.
  void begin(std::size_t all) noexcept {
    all_ = all;
    done_ = 0;
  }
  /// Never more than all.
  void set_done(std::size_t done) noexcept { done_ = std::min(done, all_); }
  void add_done() noexcept { set_done(done_ + 1); }
  void end() noexcept { done_ = all_; }
  std::size_t done() const noexcept { return done_; }

  bool go_on() {
    stopped_ = stopped_ || (watch_ && !watch_(done_, all_));
    return !stopped_;
  }
  bool stopped() const noexcept { return stopped_; }

 private:
  WorkWatch watch_;
  std::size_t done_ = 0, all_ = 0;
  bool stopped_ = false;
};

}  // namespace cusp::storage
