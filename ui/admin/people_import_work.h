/// What a list of students makes in the records, on a thread of its own with a store of its own: a PIN's hash takes a tenth of a second.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ui/admin/people_csv.h"
#include "ui/admin/pin_slips.h"
#include "ui/admin/work_run.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/session/records_task.h"

namespace cusp::ui {

struct PeopleImportWork {
  RecordsBeside records;
  Actor actor{};
  std::vector<ListedStudent> lines;  // fresh: gets an account; known: joins its cohort alone
};

struct PeopleImportEnd {
  std::vector<PinSlip> slips{};  // of the accounts that were made
  std::optional<StorageFailure> failure{};  // none was made
  int line = 0;  // of the file, that `failure` concerns; 0: no single one
};

/// Makes the accounts, PINs and cohorts of all lines, or none. `ended` is called on the task's thread.
BackgroundTask make_accounts(PeopleImportWork work, std::shared_ptr<WorkProgress> progress, std::function<void(PeopleImportEnd)> ended);

}  // namespace cusp::ui
