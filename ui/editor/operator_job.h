/// Lets scripted operators cut an exercise at once in Qt's pool, one after another; its signals come on the GUI thread.
/// Thread: GUI.
#pragma once

#include <QObject>
#include <memory>
#include <string>
#include <vector>

#include "ui/widgets/pool_job.h"
#include "ui/modules.h"
#include "ui/session/operator_cut.h"

namespace cusp::ui {

class OperatorJob : public QObject {
  Q_OBJECT

 public:
  explicit OperatorJob(QObject* parent = nullptr) : QObject(parent) {}

  /// Cancels the running job first. `names` as in cut_by_operator().
  void start(const Scenario& scenario, const std::shared_ptr<const Specimen>& specimen, const std::vector<std::string>& names);
  /// No more signals come. The pool ends the operator that cuts now.
  void cancel() { job_.cancel(); }
  bool running() const { return job_.running(); }

 Q_SIGNALS:
  void cut(const std::shared_ptr<const SessionResult>& result);
  void failed(OperatorCutError error, const std::string& name);
  /// After the last one, failed or not.
  void done();

 private:
  PoolJob<OperatorJob> job_;
};

}  // namespace cusp::ui
