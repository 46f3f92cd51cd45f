/// Files between stations, each call on a thread of its own with a store of its own. `then` is called on the task's thread.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "storage/exchange/exchange.h"
#include "ui/admin/work_run.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/session/records_task.h"

namespace cusp::ui {

/// The records of this station, the file, who acts, and how far it is.
struct ExchangeWork {
  RecordsBeside records;
  std::filesystem::path file;
  Actor actor{};
  std::shared_ptr<WorkProgress> progress{};
};

/// give_out().
BackgroundTask give_out_file(ExchangeWork work, ExchangeKind kind, std::function<void(Stored<GivenOut>)> then);
/// look_into(): changes nothing.
BackgroundTask look_into_file(ExchangeWork work, std::function<void(Stored<ExchangeLook>)> then);
/// read_in().
BackgroundTask read_file_in(ExchangeWork work, std::function<void(Stored<ReadIn>)> then);

}  // namespace cusp::ui
