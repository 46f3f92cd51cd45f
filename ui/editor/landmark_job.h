/// Proposes the landmarks of a tooth from a file in Qt's pool; its signals come on the GUI thread. Thread: GUI.
#pragma once

#include <QObject>
#include <string>

#include "scenarios/format/scenario.h"
#include "scenarios/import/import_error.h"
#include "scenarios/landmarks/propose.h"
#include "ui/widgets/pool_job.h"
#include "ui/modules.h"

namespace cusp::ui {

class LandmarkJob : public QObject {
  Q_OBJECT

 public:
  explicit LandmarkJob(QObject* parent = nullptr) : QObject(parent) {}

  /// Cancels the running job first. `folder` has the volume that `source` names; `fdi` is the number of its tooth.
  void start(const SpecimenSource& source, const std::string& folder, int fdi);
  /// No more signals come. The pool ends what it computes now, some 0.5 s.
  void cancel() { job_.cancel(); }
  bool running() const { return job_.running(); }

 Q_SIGNALS:
  void proposed(const SpecimenLandmarks& found);
  void unreadable(const ImportFailure& failure);
  void failed(ProposeError error);

 private:
  PoolJob<LandmarkJob> job_;
};

}  // namespace cusp::ui
