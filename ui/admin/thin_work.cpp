#include "ui/admin/thin_work.h"

#include "ui/session/records_task.h"

namespace cusp::ui {

BackgroundTask look_for_old_traces(RecordsBeside records, const Actor& actor, int older_than_days,
                                   std::function<void(Stored<OldTraces>)> then) {
  return BackgroundTask([records = std::move(records), actor, older_than_days, then = std::move(then)] {
    const auto store = open_beside(records.for_reading());
    then(store ? old_traces((*store)->context(), actor, older_than_days) : Stored<OldTraces>(std::unexpected(store.error())));
  }, BackgroundTask::Holds::nothing);
}

BackgroundTask thin_in_background(RecordsBeside records, const Actor& actor, const ThinningOrder& order,
                                  std::shared_ptr<WorkProgress> progress, std::function<void(Stored<ThinningReport>)> then) {
  return BackgroundTask([records = std::move(records), actor, order, watch = watch_of(std::move(progress)), then = std::move(then)] {
    const bool reads = order.mode == ThinningMode::dry_run;
    const auto store = open_beside(reads ? records.for_reading() : records);
    if (!store) return then(std::unexpected(store.error()));
    then(thin_traces((*store)->context(), actor, order, watch));
  });
}

}  // namespace cusp::ui
