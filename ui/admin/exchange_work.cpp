#include "ui/admin/exchange_work.h"

#include "ui/session/records_task.h"

namespace cusp::ui {
namespace {

/// Runs `call` on a store beside the window's.
template <class Result, class Call>
BackgroundTask with_store(ExchangeWork work, std::function<void(Stored<Result>)> then, Call call) {
  return BackgroundTask([work = std::move(work), then = std::move(then), call] {
    const auto store = open_beside(work.records);
    then(store ? call((*store)->context(), work) : Stored<Result>(std::unexpected(store.error())));
  });
}

}  // namespace

BackgroundTask give_out_file(ExchangeWork work, ExchangeKind kind, std::function<void(Stored<GivenOut>)> then) {
  return with_store<GivenOut>(std::move(work), std::move(then),
                              [kind](StorageContext& context, const ExchangeWork& w) { return give_out(context, w.actor, kind, w.file, watch_of(w.progress)); });
}

BackgroundTask look_into_file(ExchangeWork work, std::function<void(Stored<ExchangeLook>)> then) {
  return with_store<ExchangeLook>(std::move(work), std::move(then),
                                  [](StorageContext& context, const ExchangeWork& w) { return look_into(context, w.actor, w.file, watch_of(w.progress)); });
}

BackgroundTask read_file_in(ExchangeWork work, std::function<void(Stored<ReadIn>)> then) {
  return with_store<ReadIn>(std::move(work), std::move(then),
                            [](StorageContext& context, const ExchangeWork& w) { return read_in(context, w.actor, w.file, watch_of(w.progress)); });
}

}  // namespace cusp::ui
