/// Grows the specimen of an exercise in Qt's pool: voxels for the try-out, facts for the checks, its height. No widget.
/// Thread: GUI.
#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/format/scenario.h"
#include "scenarios/format/validate.h"
#include "scenarios/import/import_error.h"
#include "ui/modules.h"

namespace cusp::ui {

struct GrownSpecimen {
  SpecimenSource source;
  std::shared_ptr<const Volume> whole;  // nothing cut
  SpecimenFacts facts;
  std::vector<Vec3> pulp_mm;       // outermost voxels of the pulp
  std::optional<Vec3> central_mm;  // central pit of a tooth
  std::vector<Landmark> landmarks; // of a grown tooth; those of a tooth from a file stand in the exercise
};

class SpecimenGrower : public QObject {
  Q_OBJECT

 public:
  explicit SpecimenGrower(QObject* parent = nullptr);
  ~SpecimenGrower() override;
  /// Cancels the running growth first. `folder`: of a volume file.
  void grow(const SpecimenSource& source, Method method, const std::string& folder);
  /// No more signals come of the running growth.
  void cancel();
  bool running() const { return job_ != nullptr; }

 Q_SIGNALS:
  void progressed(double share);
  /// A coarse copy of a fine tooth, shown while the fine one grows.
  void previewed(std::shared_ptr<const GrownSpecimen> specimen);
  void grown(std::shared_ptr<const GrownSpecimen> specimen);
  void failed(ImportFailure failure);

 private:
  struct Job {
    std::atomic<bool> cancel{false};
  };
  std::shared_ptr<Job> job_;
};

/// Tissue figures (stiffness, speed) that the built-in exercises give a generator.
std::vector<ScenarioTissue> usual_tissues(const std::string& generator);
/// Likewise for the tissues of a volume; a tissue of no built-in exercise gets the defaults of ScenarioTissue.
std::vector<ScenarioTissue> usual_tissues(const std::vector<Tissue>& tissues);

/// Height of the specimen's surface at x, y; nullopt beside it.
std::optional<double> height_at(const Specimen& specimen, double x_mm, double y_mm);

}  // namespace cusp::ui
