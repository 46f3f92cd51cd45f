/// What a list of students makes in the records, on a thread of its own with a store of its own: a PIN's hash takes a tenth of a second.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "ui/admin/people_csv.h"
#include "ui/admin/pin_slips.h"
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
  std::optional<StorageFailure> failure;
  int line = 0;  // of the file, at which `failure` stopped the work; 0: before the first
};

/// All are called on the task's thread.
struct PeopleImportAnswers {
  std::function<void(PinSlip)> account_made;  // before the account joins its cohort: no PIN is lost if that fails
  std::function<void(int)> lines_done;        // how many now
  std::function<void(PeopleImportEnd)> ended;
};

/// Makes accounts, PINs and cohorts line by line. `stop` ends it before the next line.
BackgroundTask make_accounts(PeopleImportWork work, std::stop_token stop, PeopleImportAnswers answers);

}  // namespace cusp::ui
