#include "ui/session/second_scorer.h"

#include <algorithm>
#include <utility>

#include "engine/loop/realtime.h"

namespace cusp::ui {

SecondScorer::SecondScorer(std::shared_ptr<const Reference> reference, std::shared_ptr<const Specimen> specimen, Recorder& recorder)
    : volume_(std::move(specimen)), scores_(std::move(reference)), recorder_(recorder), thread_([this] { run(); }) {}

SecondScorer::~SecondScorer() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void SecondScorer::add(std::vector<ChangedBrick> changed, RecordedSecond second, std::optional<KeyState> key_state) {
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [this] { return !job_; });
  job_ = Job{std::move(changed), std::move(second), std::move(key_state)};
  lock.unlock();
  wake_.notify_all();
}

void SecondScorer::run() {
  name_this_thread("cusp-scorer");
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return job_ || end_; });
    if (!job_) return;
    Job job = std::move(*job_);
    job_.reset();
    lock.unlock();
    wake_.notify_all();
    record(std::move(job));
    lock.lock();
  }
}

void SecondScorer::record(Job job) {
  std::vector<std::int32_t> bricks;
  bricks.reserve(job.changed.size());
  for (const ChangedBrick& one : job.changed) {
    std::uint16_t* cut = volume_.cut_for_writing(one.brick);
    if (cut == nullptr) continue;
    std::ranges::copy(one.cut, cut);
    volume_.touched(one.brick);
    bricks.push_back(one.brick);
  }
  scores_.update(volume_, bricks);
  job.second.metrics.removed = scores_.removed();
  recorder_.add(std::move(job.second), std::move(job.key_state));
}

}  // namespace cusp::ui
