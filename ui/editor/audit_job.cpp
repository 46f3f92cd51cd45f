#include "ui/editor/audit_job.h"

namespace cusp::ui {

void AuditJob::start(const Scenario& scenario, const AuditSettings& settings, const AuditRunner& runner) {
  job_.start(this, [scenario, settings, runner](const PoolLink<AuditJob>& link) {
    double reported = -1;
    const auto report = audit(scenario, settings, runner, [&](double share) {
      // At most 100 signals, one for each percent.
      if (share >= reported + 0.01) {
        reported = share;
        link.post([share](AuditJob& job) { Q_EMIT job.progressed(share); });
      }
      return !link.cancelled();
    });
    if (!report) {
      link.post([failure = report.error()](AuditJob& job) {
        job.job_.finish();
        Q_EMIT job.failed(failure);
      });
      return;
    }
    link.post([found = std::make_shared<const AuditReport>(*report)](AuditJob& job) {
      job.job_.finish();
      Q_EMIT job.done(found);
    });
  });
}

}  // namespace cusp::ui
