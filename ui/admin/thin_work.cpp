#include "ui/admin/thin_work.h"

#include "ui/admin/store_beside.h"

namespace cusp::ui {

BackgroundTask look_for_old_traces(std::filesystem::path database, const Actor& actor, int older_than_days,
                                   std::function<void(Stored<OldTraces>)> then) {
  return BackgroundTask([database = std::move(database), actor, older_than_days, then = std::move(then)] {
    const auto store = open_beside(database, DatabaseOptions::Access::read_only);
    then(store ? old_traces((*store)->context(), actor, older_than_days) : Stored<OldTraces>(std::unexpected(store.error())));
  });
}

BackgroundTask thin_in_background(std::filesystem::path database, const Actor& actor, const ThinningOrder& order,
                                  std::shared_ptr<ThinningProgress> progress, std::function<void(Stored<ThinningReport>)> then) {
  return BackgroundTask([database = std::move(database), actor, order, progress = std::move(progress), then = std::move(then)] {
    const bool reads = order.mode == ThinningMode::dry_run;
    const auto store = open_beside(database, reads ? DatabaseOptions::Access::read_only : DatabaseOptions::Access::existing);
    if (!store) return then(std::unexpected(store.error()));
    then(thin_traces((*store)->context(), actor, order, [&progress](std::size_t done, std::size_t all) {
      progress->all = all;
      progress->done = done;
      return !progress->stop;
    }));
  });
}

}  // namespace cusp::ui
