/// Scores the seconds of a scripted attempt and gives them to its recorder, on a thread of its own: the mirror, which both loop and
/// script wait for, only copies the bricks that changed.
#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "ui/modules.h"
#include "ui/session/recorder.h"
#include "ui/session/removed_scores.h"

namespace cusp::ui {

/// A brick's cut field.
struct ChangedBrick {
  std::int32_t brick = 0;
  std::array<std::uint16_t, kBrickVoxels> cut{};
};

class SecondScorer {
 public:
  SecondScorer(std::shared_ptr<const Reference> reference, std::shared_ptr<const Specimen> specimen, Recorder& recorder);
  /// Scores and records what was added.
  ~SecondScorer();
  SecondScorer(const SecondScorer&) = delete;
  SecondScorer& operator=(const SecondScorer&) = delete;

  /// Mirror's thread. Waits while the second before waits too. `changed`: since the last call.
  void add(std::vector<ChangedBrick> changed, RecordedSecond second, std::optional<KeyState> key_state);

 private:
  struct Job {
    std::vector<ChangedBrick> changed;
    RecordedSecond second;
    std::optional<KeyState> key_state;
  };
  void run();
  void record(Job job);

  Volume volume_;  // follows the mirror's
  RemovedScores scores_;
  Recorder& recorder_;
  std::mutex mutex_;  // guards job_ and end_; held for a move
  std::condition_variable wake_;
  std::optional<Job> job_;
  bool end_ = false;
  std::thread thread_;
};

}  // namespace cusp::ui
