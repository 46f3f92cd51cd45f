/// What a page needs of an exercise's uncut tooth before it can be seen and drilled: grown or read from files, and the last one kept
/// in memory. Who asks for what another thread makes waits for it and gets the same one: a briefing makes ahead what Start needs.
/// Any thread. Specimen, scenery and mesh equal what is made without a cache, bit for bit.
#pragma once

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "scenarios/metrics/reference.h"
#include "scenarios/operators/plan.h"
#include "ui/render/patch_feed.h"
#include "ui/render/scenery_look.h"
#include "ui/session/exercise_session.h"
#include "ui/session/specimen_files.h"

namespace cusp::ui {

/// Immutable.
struct ReadyTooth {
  std::shared_ptr<const Specimen> specimen;
  std::shared_ptr<const Reference> reference;
  std::shared_ptr<const SceneryLook> scenery;  // null: none
  WholeMesh mesh;                              // with the settings of TargetLook::feed(), without deviation if silent
};

/// What takes the time.
enum class ToothPart : std::uint8_t { specimen, scenery, mesh };

struct ToothWish {
  Scenario scenario;
  std::filesystem::path folder;               // where a volume that the scenario names lies
  Guidance guidance = Guidance::full;
  std::shared_ptr<const Specimen> specimen;   // to begin with; null: the scenario's
};

class ToothCache {
 public:
  using Progress = std::function<void(ToothPart part, double share)>;  // share of the part, in [0, 1]

  explicit ToothCache(std::filesystem::path folder) : files_(std::move(folder)) {}

  /// `stop` may be null; set by another thread, it ends early and fails (specimen, cancelled). Progress comes on the calling thread.
  Outcome<std::shared_ptr<const ReadyTooth>> tooth(const ToothWish& wish, const std::atomic<bool>* stop, const Progress& progress = {});

  /// The reference operator's path of the wish's exercise; nullopt: it has none. Planned (up to a minute) or read from files;
  /// nullopt too once `stop` is set by another thread. Pre: the specimen is that of the wish.
  std::optional<Plan> reference_path(const ToothWish& wish, const Specimen& specimen, const std::atomic<bool>* stop = nullptr) const;

 private:
  struct Done {
    ToothPart part = ToothPart::specimen;
    double share = 0;
  };
  Outcome<std::shared_ptr<const ReadyTooth>> make(const ToothWish& wish, const std::atomic<bool>* stop, const Progress& progress) const;
  WholeMesh mesh(const ToothWish& wish, const Specimen& specimen, const Volume& whole) const;

  SpecimenFiles files_;
  std::mutex mutex_;  // guards what follows; held for a copy
  std::condition_variable changed_;
  std::map<Hash256, Done> making_;
  std::optional<Hash256> last_key_;
  std::shared_ptr<const ReadyTooth> last_;
};

}  // namespace cusp::ui
