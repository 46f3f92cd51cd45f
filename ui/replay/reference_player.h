/// The reference operator's cuts for a window: tooth, path and cutting on a thread of their own. Thread: GUI, but for the thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>

#include "ui/render/overlay_line.h"
#include "ui/session/background_task.h"
#include "ui/session/reference_cut.h"
#include "ui/view/start_view.h"
#include "ui/view/tooth_cache.h"

namespace cusp::ui {

class ReferencePlayer {
 public:
  static constexpr double kSeconds = 30.0;  // that a path takes at the usual speed

  /// Tooth and path are there; immutable but for the feed.
  struct Show {
    PathTimeline timeline;
    Bur bur;
    int last_step = 0;
    std::shared_ptr<PatchFeed> patches;
    std::shared_ptr<const SceneryLook> scenery;  // null: none
    std::vector<OverlayLine> lines;
    StartView start_view;
  };
  using Failure = std::variant<SessionFailure, OperatorCutError>;
  struct Progress {
    std::optional<ToothPart> part;  // nullopt: the path is planned
    double share = 0;               // of the part, in [0, 1]
  };

  /// Begins at once.
  ReferencePlayer(std::shared_ptr<ToothCache> teeth, ToothWish wish);
  /// Stops, and does not wait.
  ~ReferencePlayer();
  ReferencePlayer(const ReferencePlayer&) = delete;
  ReferencePlayer& operator=(const ReferencePlayer&) = delete;

  Progress progress() const;
  std::shared_ptr<const Show> show() const;  // null: not yet
  std::optional<Failure> failure() const;
  /// The step to be cut to. The newest wish replaces those before.
  void want(int step);
  /// The step that the feed has.
  int shown() const;

 private:
  struct Shared;
  static void work(Shared& shared, ToothCache& teeth, const ToothWish& wish);
  static void follow(Shared& shared, ReferenceCut& cut, PatchFeed& patches);

  std::shared_ptr<Shared> shared_;
  BackgroundTask task_;
};

}  // namespace cusp::ui
