#include "ui/session/records_task.h"

#include <utility>

namespace cusp::ui {

BackgroundTask with_own_store(Store& store, std::function<void(OwnStore own)> work) {
  const StorageContext& context = store.context();
  StoreOptions options;
  options.database.access = context.db.read_only() ? DatabaseOptions::Access::read_only : DatabaseOptions::Access::existing;
  options.clock = context.clock;
  options.cost = context.cost;
  options.key_file = context.key_file;
  options.mark_interrupted = false;
  return BackgroundTask([file = context.db.file(), options, work = std::move(work)] { work(Store::open(file, options)); });
}

}  // namespace cusp::ui
