/// Work on the records that would hold up a window: on a thread of its own, with a store of its own.
#pragma once

#include <functional>
#include <memory>

#include "storage/store.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"

namespace cusp::ui {

/// What the work gets: the same records, or why they did not open.
using OwnStore = Stored<std::unique_ptr<Store>>;

/// Opens the records of `store` once more, with its clock and its cost of passwords, only for reading if `store` only reads.
/// `work` is called on the task's thread.
BackgroundTask with_own_store(Store& store, std::function<void(OwnStore own)> work);

}  // namespace cusp::ui
