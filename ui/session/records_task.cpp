#include "ui/session/records_task.h"

#include <utility>

namespace cusp::ui {

RecordsBeside RecordsBeside::for_reading() const {
  RecordsBeside out = *this;
  out.options.database.access = DatabaseOptions::Access::read_only;
  return out;
}

RecordsBeside records_of(Store& store) {
  const StorageContext& context = store.context();
  StoreOptions options;
  options.database.access = context.db.read_only() ? DatabaseOptions::Access::read_only : DatabaseOptions::Access::existing;
  options.clock = context.clock;
  options.cost = context.cost;
  options.key_file = context.key_file;
  options.mark_interrupted = false;
  options.tries = context.tries;
  return {context.db.file(), options};
}

OwnStore open_beside(const RecordsBeside& records) { return Store::open(records.file, records.options); }

BackgroundTask with_own_store(Store& store, std::function<void(OwnStore own)> work, BackgroundTask::Holds holds) {
  return BackgroundTask([records = records_of(store), work = std::move(work)] { work(open_beside(records)); }, holds);
}

}  // namespace cusp::ui
