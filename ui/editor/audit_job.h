/// Audits an exercise in Qt's pool; reports on the GUI thread. GUI thread.
#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <string>

#include "scenarios/audit/audit.h"
#include "ui/modules.h"

namespace cusp::ui {

class AuditJob : public QObject {
  Q_OBJECT

 public:
  explicit AuditJob(QObject* parent = nullptr);
  ~AuditJob() override;

  /// Stops the one that runs. `runner` is called in the pool.
  void start(const Scenario& scenario, const AuditSettings& settings, const AuditRunner& runner);
  /// Nothing more is told of the one that runs; it ends within a fraction of a second or when a specimen has been grown.
  void cancel();
  bool running() const { return run_ != nullptr; }

 Q_SIGNALS:
  void progressed(double share);
  void done(const std::shared_ptr<const AuditReport>& report);
  void failed(const AuditFailure& failure);

 private:
  struct Run {
    std::atomic<bool> cancel{false};
  };
  std::shared_ptr<Run> run_;
};

}  // namespace cusp::ui
