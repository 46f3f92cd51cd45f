#include "ui/editor/draft_folder.h"

#include "storage/base/locked_folder.h"
#include "ui/modules.h"

namespace cusp::ui {

std::shared_ptr<const void> hold_folder(const std::filesystem::path& folder) {
  auto held = std::make_shared<const LockedFolder>(folder, FolderLock::shared);
  if (!held->locked()) return nullptr;
  return held;
}

void remove_unheld(const std::filesystem::path& folder, const std::function<bool()>& is_needed) {
  const LockedFolder alone(folder, FolderLock::alone_at_once);
  if (!alone.locked() || is_needed()) return;
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
}

}  // namespace cusp::ui
