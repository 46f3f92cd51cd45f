#include "ui/editor/audit_job.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

namespace cusp::ui {

AuditJob::AuditJob(QObject* parent) : QObject(parent) {}

AuditJob::~AuditJob() { cancel(); }

void AuditJob::cancel() {
  if (run_) run_->cancel.store(true);
  run_.reset();
}

void AuditJob::start(const Scenario& scenario, const AuditSettings& settings, const AuditRunner& runner) {
  cancel();
  run_ = std::make_shared<Run>();
  QThreadPool::globalInstance()->start([run = run_, scenario, settings, runner, self = QPointer<AuditJob>(this)] {
    const auto post = [&](auto answer) {
      QMetaObject::invokeMethod(
          qApp,
          [self, run, answer] {
            if (self && self->run_ == run) answer(*self);
          },
          Qt::QueuedConnection);
    };
    double reported = -1;
    const auto report = audit(scenario, settings, runner, [&](double share) {
      // At most 100 signals, one for each percent.
      if (share >= reported + 0.01) {
        reported = share;
        post([share](AuditJob& job) { Q_EMIT job.progressed(share); });
      }
      return !run->cancel.load();
    });
    if (!report) {
      post([failure = report.error()](AuditJob& job) {
        job.run_.reset();
        Q_EMIT job.failed(failure);
      });
      return;
    }
    post([found = std::make_shared<const AuditReport>(*report)](AuditJob& job) {
      job.run_.reset();
      Q_EMIT job.done(found);
    });
  });
}

}  // namespace cusp::ui
