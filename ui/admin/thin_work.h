/// Thinning on a thread of its own with a store of its own (storage/retention/thinning.h).
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "storage/retention/thinning.h"
#include "ui/admin/work_run.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/session/records_task.h"

namespace cusp::ui {

/// old_traces() over a store that only reads; `then` is called on the task's thread.
BackgroundTask look_for_old_traces(RecordsBeside records, const Actor& actor, int older_than_days,
                                   std::function<void(Stored<OldTraces>)> then);
/// thin_traces(); `then` is called on the task's thread.
BackgroundTask thin_in_background(RecordsBeside records, const Actor& actor, const ThinningOrder& order,
                                  std::shared_ptr<WorkProgress> progress, std::function<void(Stored<ThinningReport>)> then);

}  // namespace cusp::ui
