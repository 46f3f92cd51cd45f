/// Audits an exercise in Qt's pool; its signals come on the GUI thread. Thread: GUI.
#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "scenarios/audit/audit.h"
#include "ui/widgets/pool_job.h"
#include "ui/modules.h"

namespace cusp::ui {

class AuditJob : public QObject {
  Q_OBJECT

 public:
  explicit AuditJob(QObject* parent = nullptr) : QObject(parent) {}

  /// Cancels the running audit first. The pool calls `runner`.
  void start(const Scenario& scenario, const AuditSettings& settings, const AuditRunner& runner);
  /// No more signals come. The audit ends within a second, but for a path that it plans: up to 15 s between neighbours.
  void cancel() { job_.cancel(); }
  bool running() const { return job_.running(); }

 Q_SIGNALS:
  void progressed(double share);
  void done(const std::shared_ptr<const AuditReport>& report);
  void failed(const AuditFailure& failure);

 private:
  PoolJob<AuditJob> job_;
};

}  // namespace cusp::ui
