#include "ui/editor/operator_job.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

namespace cusp::ui {

OperatorJob::OperatorJob(QObject* parent) : QObject(parent) {}

OperatorJob::~OperatorJob() { cancel(); }

void OperatorJob::cancel() {
  if (job_) job_->cancel.store(true);
  job_.reset();
}

void OperatorJob::start(const Scenario& scenario, const std::shared_ptr<const Specimen>& specimen, const std::vector<std::string>& names) {
  cancel();
  job_ = std::make_shared<Job>();
  QThreadPool::globalInstance()->start([own = job_, scenario, specimen, names, self = QPointer<OperatorJob>(this)] {
    const auto post = [&](auto answer) {
      QMetaObject::invokeMethod(
          qApp,
          [self, own, answer] {
            if (self && self->job_ == own) answer(*self);
          },
          Qt::QueuedConnection);
    };
    for (const std::string& name : names) {
      if (own->cancel.load()) return;
      auto result = cut_by_operator(name, scenario, specimen);
      if (result) {
        post([made = std::make_shared<const SessionResult>(std::move(*result))](OperatorJob& job) { Q_EMIT job.cut(made); });
      } else {
        post([error = result.error(), name](OperatorJob& job) { Q_EMIT job.failed(error, name); });
      }
    }
    post([](OperatorJob& job) {
      job.job_.reset();
      Q_EMIT job.done();
    });
  });
}

}  // namespace cusp::ui
