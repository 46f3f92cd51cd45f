/// How long a writer waits for what passes by itself: another process that holds the file, a disk that is full.
#pragma once

#include <chrono>
#include <cstddef>
#include <thread>

#include "storage/base/error.h"
#include "ui/modules.h"

namespace cusp::ui {

struct Patience {
  std::chrono::milliseconds pause{500};  // between two tries; a busy file has its own time-out (5 s) besides
  int tries = 20;                        // of one write that somebody waits for: ten seconds of a full disk
  // Seconds of a session that may rest in memory alone before it is held, and writing is tried further.
  std::size_t most_waiting = 30;
};

constexpr bool passes(StorageError code) noexcept { return code == StorageError::busy || out_of_space(code); }

/// `write` until it succeeds, fails for good, or has been tried often enough.
template <class Write>
auto write_patiently(const Patience& patience, Write&& write) {
  for (int tries = 1;; ++tries) {
    auto done = write();
    if (done || !passes(done.error().code) || tries >= patience.tries) return done;
    std::this_thread::sleep_for(patience.pause);
  }
}

}  // namespace cusp::ui
