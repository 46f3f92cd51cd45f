/// The folder of a draft's volume, which windows of several programs may use at once. Thread: any. A hold ends with its process.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

namespace cusp::ui {

/// While the value lives, remove_unheld() leaves the folder; waits for one that is removing it. nullptr if there is no folder, or on a
/// drive that locks none.
std::shared_ptr<const void> hold_folder(const std::filesystem::path& folder);

/// Removes the folder unless one holds it or `is_needed` returns true, which is asked while nobody can begin to hold it. Leaves it on a
/// drive that locks no folder. Failures are ignored: a volume that stays wastes disk space only.
void remove_unheld(const std::filesystem::path& folder, const std::function<bool()>& is_needed);

}  // namespace cusp::ui
