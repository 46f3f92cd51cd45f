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
    const auto notify = [&](auto say) {
      QMetaObject::invokeMethod(
          qApp,
          [self, run, say] {
            if (self && self->run_ == run) say(*self);
          },
          Qt::QueuedConnection);
    };
    double reported = -1;
    const auto report = audit(scenario, settings, runner, [&](double share) {
      // A hundred times in all, however often it is asked.
      if (share >= reported + 0.01) {
        reported = share;
        notify([share](AuditJob& job) { Q_EMIT job.progressed(share); });
      }
      return !run->cancel.load();
    });
    if (!report) {
      notify([failure = report.error()](AuditJob& job) {
        job.run_.reset();
        Q_EMIT job.failed(failure);
      });
      return;
    }
    notify([found = std::make_shared<const AuditReport>(*report)](AuditJob& job) {
      job.run_.reset();
      Q_EMIT job.done(found);
    });
  });
}

}  // namespace cusp::ui
