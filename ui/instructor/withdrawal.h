/// Takes the newest version of an exercise back from the students. No widget, no text. Thread: GUI.
#pragma once

#include <filesystem>
#include <optional>

#include "storage/store.h"
#include "ui/instructor/library_model.h"
#include "ui/modules.h"

namespace cusp::ui {

/// What follows from withdrawing the version that a row shows.
struct Withdrawal {
  int number = 1;             // of the version
  std::optional<int> before;  // the version that students find then; nullopt: none
  int assignments = 0;        // open ones that name the version
  bool newest = true;         // students find no later version
  friend bool operator==(const Withdrawal&, const Withdrawal&) = default;
};
/// Pre: row.withdrawable.
Stored<Withdrawal> plan_withdrawal(Store& store, const LibraryRow& row, std::int64_t now_utc_us);

/// Withdraws the version. If students find none then, the exercise becomes a draft of the actor's, unless there is one: the list
/// of exercises no longer has it. Pre: row.withdrawable.
Stored<void> withdraw(Store& store, const Actor& actor, const LibraryRow& row, const Withdrawal& plan,
                      const std::filesystem::path& database, const std::filesystem::path& cache);

}  // namespace cusp::ui
