/// One work of a page at a time, in the background: how far it is, with Cancel. Thread: GUI.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>

#include "storage/base/watch.h"
#include "ui/modules.h"
#include "ui/widgets/busy.h"

namespace cusp::ui {

/// How far a work has come, written by its task; `stop`, written by the window, ends it before its next step.
struct WorkProgress {
  std::atomic<std::size_t> done{0}, all{0};
  std::atomic<bool> stop{false};
};
/// For the call that the task makes. Empty without progress.
WorkWatch watch_of(std::shared_ptr<WorkProgress> progress);

/// "1,200", as the language groups digits.
QString count_text(std::size_t count);

class WorkRun : public QObject {
 public:
  /// "Verified 200 of 900 attempts".
  using Counted = std::function<QString(std::size_t done, std::size_t all)>;
  /// The page owns the run, and lays busy() out.
  explicit WorkRun(QObject* page);
  Busy* busy() const { return busy_; }
  bool running() const { return progress_ != nullptr; }
  /// The task writes to what it returns. Comes before the page disables anything: Cancel, once it is shown, takes the focus that a
  /// disabled button has handed on. Pre: none runs.
  std::shared_ptr<WorkProgress> start(const QString& title, Counted counted);
  /// Shows a work that runs already, without Cancel. Pre: none runs.
  void follow(std::shared_ptr<WorkProgress> progress, const QString& title, Counted counted);
  /// Gives the focus back that a disabled button or Cancel has handed on; to `instead` where the button stays off. Comes once the page
  /// has enabled its parts.
  void finish(QWidget* instead = nullptr);
  /// Stops the work before its next step. Its outcome shows whether it was over before.
  void cancel();

 private:
  void show(const QString& title, Counted counted, Busy::Cancel cancel);
  void show_progress();
  QWidget* focused() const;
  /// Whether the focus went from the disabled button to where nobody put it.
  bool handed_on(const QWidget* now) const;

  Busy* busy_;
  QTimer* timer_;
  Counted counted_;
  std::shared_ptr<WorkProgress> progress_;  // null: none runs
  QPointer<QWidget> pressed_, handed_to_;   // what had the focus before, and what got it when that was disabled
  bool handed_ = false;                     // handed_to_ is known: from the next turn of the event loop on
};

}  // namespace cusp::ui
