/// One export of a page at a time, in the background: its progress with Cancel, and its outcome in the page's band. Thread: GUI.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

#include "ui/admin/export_work.h"
#include "ui/admin/work_run.h"
#include "ui/modules.h"

namespace cusp::ui {

class Band;

class ExportRun : public QObject {
  Q_OBJECT

 public:
  struct Texts {
    QString busy;                                                             // "Exporting attempts"
    std::function<QString(const QString& done, const QString& all)> counted;  // "200 of 900 attempts"
    std::function<QString(int rows)> exported;                                // "900 attempts exported."
    QString cancelled, unwritten;                                             // `unwritten` has %1 for the path
  };
  using Outcome = Stored<std::optional<std::size_t>>;  // nullopt: stopped
  /// Starts the work, which calls `then` on its own thread.
  using Begin = std::function<BackgroundTask(std::shared_ptr<WorkProgress> progress, std::function<void(Outcome)> then)>;

  /// The page owns band and run. It lays busy() out.
  ExportRun(Band& band, Texts texts, QObject* page);
  Busy* busy() const { return run_->busy(); }
  bool running() const { return run_->running(); }
  /// Does nothing while an export runs.
  void start(const QString& path, const Begin& begin);
  /// Stops before the next rows. The outcome says that nothing was written.
  void cancel() { run_->cancel(); }

 private:
  void show_outcome(const Outcome& rows);

  Band& band_;
  Texts texts_;
  WorkRun* run_;
  QString path_;
  BackgroundTask task_;
};

}  // namespace cusp::ui
