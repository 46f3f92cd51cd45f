/// Forms that come one a turn of the event loop: made together, those of the editor would hold the window for a quarter of a second.
/// Thread: GUI.
#pragma once

#include <QPointer>
#include <QTimer>
#include <deque>
#include <functional>
#include <utility>

class QScrollArea;
class QWidget;

namespace cusp::ui {

class LaterForms {
 public:
  using Make = std::function<QWidget*()>;
  LaterForms();
  /// A scrolling page that `make` fills later, in the order of the calls.
  QWidget* add(Make make);
  /// Fills this page now. One that is filled, or no page of these, stays as it is.
  void fill(QWidget* page);

 private:
  struct Waiting {
    QPointer<QScrollArea> area;
    Make make;
  };
  void fill_next();
  static void fill(const Waiting& one);

  std::deque<Waiting> waiting_;
  QTimer turn_;
};

}  // namespace cusp::ui
