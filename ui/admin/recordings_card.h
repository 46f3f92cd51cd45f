/// Recordings of old practice attempts: how many, how large, and thinning them after a dry run and a question.
/// Thread: GUI; the records are read and thinned in the background, by a store of its own.
#pragma once

#include <filesystem>
#include <memory>

#include "ui/admin/thin_work.h"
#include "ui/admin/work_run.h"
#include "ui/session/records_task.h"
#include "ui/widgets/at_work.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/ports.h"

class QLabel;
class QPushButton;

namespace cusp::ui {

class NumberField;

class RecordingsCard : public Card, public AtWork {
  Q_OBJECT

 public:
  /// The ports outlive the card.
  RecordingsCard(RecordsBeside records, const Actor& actor, const Ports& ports, QWidget* parent = nullptr);
  bool working() const override { return run_->running(); }
  /// "3 recordings, 34.1 MB"; empty while they are counted.
  QString found() const;
  void choose_days(int days);

 public Q_SLOTS:
  /// Verifies each of them, then asks.
  void thin();
  void cancel() { run_->cancel(); }

 Q_SIGNALS:
  void reported(cusp::ui::Band::Kind kind, const QString& what, const QString& more);

 private:
  int days() const;
  void count();
  void show_count(const Stored<OldTraces>& old);
  void begin(ThinningMode mode, ClockTrust trust = ClockTrust::checked);
  void end();
  void ask_first(const Stored<ThinningReport>& would);
  void show_thinned(const Stored<ThinningReport>& report);
  void report_failure(const StorageFailure& failure);

  RecordsBeside records_;
  Actor actor_;
  const Ports& ports_;
  BackgroundTask counting_, task_;
  WorkRun* run_;
  QLabel* found_ = nullptr;
  NumberField* days_ = nullptr;
  QPushButton* thin_ = nullptr;
};

}  // namespace cusp::ui
