#include "ui/editor/operator_job.h"

namespace cusp::ui {

void OperatorJob::start(const Scenario& scenario, const std::shared_ptr<const Specimen>& specimen, const std::vector<std::string>& names) {
  job_.start(this, [scenario, specimen, names](const PoolLink<OperatorJob>& link) {
    for (const std::string& name : names) {
      if (link.cancelled()) return;
      auto result = cut_by_operator(name, scenario, specimen, link.cancel_flag());
      if (result) {
        link.post([made = std::make_shared<const SessionResult>(std::move(*result))](OperatorJob& job) { Q_EMIT job.cut(made); });
      } else {
        link.post([error = result.error(), name](OperatorJob& job) { Q_EMIT job.failed(error, name); });
      }
    }
    link.post([](OperatorJob& job) {
      job.job_.finish();
      Q_EMIT job.done();
    });
  });
}

}  // namespace cusp::ui
