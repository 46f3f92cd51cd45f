/// One export of a page at a time, in the background: its progress with Cancel, and its outcome in the page's band. Thread: GUI.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

#include "ui/admin/export_work.h"
#include "ui/modules.h"

class QTimer;

namespace cusp::ui {

class Band;
class Busy;

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
  using Begin = std::function<BackgroundTask(std::shared_ptr<ExportProgress> progress, std::function<void(Outcome)> then)>;

  /// The page owns band and run. It lays busy() out.
  ExportRun(Band& band, Texts texts, QObject* page);
  Busy* busy() const { return busy_; }
  bool running() const { return progress_ != nullptr; }
  /// Does nothing while an export runs.
  void start(const QString& path, const Begin& begin);
  /// Stops before the next rows. The outcome says that nothing was written.
  void cancel();

 private:
  void show_progress();
  void show_outcome(const Outcome& rows);

  Band& band_;
  Texts texts_;
  Busy* busy_;
  QTimer* look_;
  QString path_;
  std::shared_ptr<ExportProgress> progress_;  // null: none runs
  BackgroundTask task_;
};

}  // namespace cusp::ui
