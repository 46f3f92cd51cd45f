#include "ui/replay/reference_player.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "ui/render/target_look.h"

namespace cusp::ui {
namespace {

constexpr int kMostAtOnce = 40;  // steps between two looks at what is wanted

}  // namespace

struct ReferencePlayer::Shared {
  std::atomic<bool> stop{false};
  std::atomic<int> shown{0};
  mutable std::mutex mutex;  // guards what follows; held for a copy
  std::condition_variable changed;
  int wanted = 0;
  Progress progress{ToothPart::specimen, 0};
  std::shared_ptr<const Show> show;
  std::optional<Failure> failure;

  void fail(Failure why) {
    const std::lock_guard lock(mutex);
    failure = std::move(why);
  }
};

ReferencePlayer::ReferencePlayer(std::shared_ptr<ToothCache> teeth, ToothWish wish)
    : shared_(std::make_shared<Shared>()), task_([shared = shared_, teeth = std::move(teeth), wish = std::move(wish)] {
        work(*shared, *teeth, wish);
      }, BackgroundTask::Holds::nothing) {}

ReferencePlayer::~ReferencePlayer() {
  const std::lock_guard lock(shared_->mutex);
  shared_->stop = true;
  shared_->changed.notify_all();
}

void ReferencePlayer::work(Shared& shared, ToothCache& teeth, const ToothWish& wish) {
  const auto tooth = teeth.tooth(wish, &shared.stop, [&](ToothPart part, double share) {
    const std::lock_guard lock(shared.mutex);
    shared.progress = {part, share};
  });
  if (!tooth) return shared.fail(tooth.error());
  {
    const std::lock_guard lock(shared.mutex);
    shared.progress = {};
  }
  const Scenario& scenario = wish.scenario;
  auto plan = teeth.reference_path(wish, *(*tooth)->specimen, &shared.stop);
  if (shared.stop) return;
  if (!plan) return shared.fail(OperatorCutError::no_path);
  ReferenceCut cut(scenario, (*tooth)->specimen, PathTimeline(std::move(*plan), kSeconds));
  const TargetLook look(scenario.target, scenario.leeway, (*tooth)->specimen);
  auto patches = std::make_shared<PatchFeed>(look.feed());
  patches->begin(cut.volume(), (*tooth)->mesh);
  auto show = std::make_shared<const Show>(Show{cut.timeline(), scenario.instruments[cut.timeline().bur()], cut.last_step(), patches,
                                                (*tooth)->scenery, look.lines(cut.volume()), start_view(cut.volume().grid(), look)});
  {
    const std::lock_guard lock(shared.mutex);
    shared.show = std::move(show);
  }
  follow(shared, cut, *patches);
}

void ReferencePlayer::follow(Shared& shared, ReferenceCut& cut, PatchFeed& patches) {
  while (!shared.stop) {
    int wanted = 0;
    {
      std::unique_lock lock(shared.mutex);
      shared.changed.wait(lock, [&] { return shared.stop || shared.wanted != cut.step(); });
      wanted = shared.wanted;
    }
    if (shared.stop) return;
    const auto bricks = cut.go_to(std::min(wanted, cut.step() + kMostAtOnce));
    if (!bricks) return shared.fail(bricks.error());
    patches.update(cut.volume(), *bricks, static_cast<std::uint64_t>(cut.step()));
    shared.shown = cut.step();
  }
}

ReferencePlayer::Progress ReferencePlayer::progress() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->progress;
}

std::shared_ptr<const ReferencePlayer::Show> ReferencePlayer::show() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->show;
}

std::optional<ReferencePlayer::Failure> ReferencePlayer::failure() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->failure;
}

void ReferencePlayer::want(int step) {
  const auto show = this->show();
  const std::lock_guard lock(shared_->mutex);
  shared_->wanted = show ? std::clamp(step, 0, show->last_step) : 0;
  shared_->changed.notify_all();
}

int ReferencePlayer::shown() const { return shared_->shown; }

}  // namespace cusp::ui
