/// The way of a background task's answer to the window.
#pragma once

#include <QCoreApplication>
#include <QMetaObject>
#include <QPointer>
#include <functional>
#include <memory>

#include "ui/modules.h"

namespace cusp::ui {

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
