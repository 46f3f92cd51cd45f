/// What a list of students makes in the records, on a thread of its own with a store of its own: a PIN's hash takes a tenth of a second.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ui/admin/people_csv.h"
#include "ui/admin/work_run.h"
#include "ui/modules.h"
#include "ui/session/background_task.h"
#include "ui/session/records_task.h"

namespace cusp::ui {

struct PeopleImportWork {
  RecordsBeside records;
  Actor actor{};
  std::vector<ListedStudent> lines;  // fresh: gets an account with its PIN; known: joins its cohort alone
  std::filesystem::path slips{};     // file with the PINs, written already; empty: no line is fresh
};

struct PeopleImportEnd {
  int made = 0;                             // accounts
  std::filesystem::path slips{};            // of PeopleImportWork
  std::optional<StorageFailure> failure{};  // none was made
  int line = 0;                             // of the list, that `failure` concerns; 0: no single one
};

/// Gives each fresh line a PIN of six digits that brings none. Thread: any.
void give_pins(std::vector<ListedStudent>& lines);

/// Makes the accounts, PINs and cohorts of all lines; or none, and removes the slips. `ended` is called on the task's thread.
BackgroundTask make_accounts(PeopleImportWork work, std::shared_ptr<WorkProgress> progress, std::function<void(PeopleImportEnd)> ended);

}  // namespace cusp::ui
