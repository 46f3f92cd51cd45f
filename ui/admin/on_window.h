/// A store of its own for a background task, and the way of its answer to the window.
#pragma once

#include <QCoreApplication>
#include <QMetaObject>
#include <QPointer>
#include <functional>
#include <memory>

#include "storage/store.h"
#include "ui/modules.h"

namespace cusp::ui {

/// Opens the records once more, beside the window's store. Thread: whoever uses it then.
Stored<std::unique_ptr<Store>> open_beside(const std::filesystem::path& database,
                                           DatabaseOptions::Access access = DatabaseOptions::Access::existing);

/// Calls `show` on the window's thread, if the page still stands.
template <class Result, class Page>
std::function<void(Result)> on_window(Page* page, void (Page::*show)(const Result&)) {
  return [self = QPointer(page), show](Result result) {
    auto shared = std::make_shared<Result>(std::move(result));
    QMetaObject::invokeMethod(
        QCoreApplication::instance(),
        [self, show, shared] {
          if (self) (self->*show)(*shared);
        },
        Qt::QueuedConnection);
  };
}

}  // namespace cusp::ui
