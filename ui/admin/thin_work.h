/// Thinning on a thread of its own with a store of its own (storage/retention/thinning.h).
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>

#include "storage/retention/thinning.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/session/records_task.h"

namespace cusp::ui {

/// How far a run has come, written by the task; `stop`, written by the window, ends it before the next attempt.
struct ThinningProgress {
  std::atomic<std::size_t> done{0}, all{0};
  std::atomic<bool> stop{false};
};

/// old_traces() over a store that only reads; `then` is called on the task's thread.
BackgroundTask look_for_old_traces(RecordsBeside records, const Actor& actor, int older_than_days,
                                   std::function<void(Stored<OldTraces>)> then);
/// thin_traces(); `then` is called on the task's thread.
BackgroundTask thin_in_background(RecordsBeside records, const Actor& actor, const ThinningOrder& order,
                                  std::shared_ptr<ThinningProgress> progress, std::function<void(Stored<ThinningReport>)> then);

}  // namespace cusp::ui
