#include "ui/editor/audit_job.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

namespace cusp::ui {

AuditJob::AuditJob(QObject* parent) : QObject(parent) {}

AuditJob::~AuditJob() { cancel(); }

void AuditJob::cancel() {
  if (job_) job_->cancel.store(true);
  job_.reset();
}

void AuditJob::start(const Scenario& scenario, const AuditSettings& settings, const AuditRunner& runner) {
  cancel();
  job_ = std::make_shared<Job>();
  QThreadPool::globalInstance()->start([own = job_, scenario, settings, runner, self = QPointer<AuditJob>(this)] {
    const auto post = [&](auto answer) {
      QMetaObject::invokeMethod(
          qApp,
          [self, own, answer] {
            if (self && self->job_ == own) answer(*self);
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
      return !own->cancel.load();
    });
    if (!report) {
      post([failure = report.error()](AuditJob& job) {
        job.job_.reset();
        Q_EMIT job.failed(failure);
      });
      return;
    }
    post([found = std::make_shared<const AuditReport>(*report)](AuditJob& job) {
      job.job_.reset();
      Q_EMIT job.done(found);
    });
  });
}

}  // namespace cusp::ui
