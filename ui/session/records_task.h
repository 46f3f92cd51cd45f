/// Work on the records that would hold up a window: on a thread of its own, with a store of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "storage/store.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"

namespace cusp::ui {

/// What the work gets: the same records, or why they did not open.
using OwnStore = Stored<std::unique_ptr<Store>>;

/// How the records of a store are opened once more. A copy may go to any thread.
struct RecordsBeside {
  std::filesystem::path file;
  StoreOptions options;
  RecordsBeside for_reading() const;
};

/// With the clock, the cost of passwords, the key and the unwritten tries of `store`; only for reading if `store` only reads.
RecordsBeside records_of(Store& store);
/// Thread: whoever uses the store then.
OwnStore open_beside(const RecordsBeside& records);

/// open_beside() the records of `store`. `work` is called on the task's thread.
BackgroundTask with_own_store(Store& store, std::function<void(OwnStore own)> work,
                              BackgroundTask::Holds holds = BackgroundTask::Holds::change);

}  // namespace cusp::ui
