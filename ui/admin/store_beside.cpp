#include "ui/admin/store_beside.h"

namespace cusp::ui {

Stored<std::unique_ptr<Store>> open_beside(const std::filesystem::path& database, DatabaseOptions::Access access) {
  StoreOptions options;
  options.database.access = access;
  options.mark_interrupted = false;
  return Store::open(database, options);
}

}  // namespace cusp::ui
