/// Grows the specimen of an exercise in the background, and makes of it what the editor needs: voxels for the try-out,
/// facts for the checks, and how high it stands. No widget. Thread: GUI; the growing has one of Qt's pool.
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
  std::optional<Vec3> central_mm;  // a tooth's central pit
};

class SpecimenGrower : public QObject {
  Q_OBJECT

 public:
  explicit SpecimenGrower(QObject* parent = nullptr);
  ~SpecimenGrower() override;
  /// What was being grown is given up. `folder`: where a volume lies.
  void grow(const SpecimenSource& source, Method method, const std::string& folder);
  /// Nothing more is told of what is being grown.
  void cancel();
  bool running() const { return job_ != nullptr; }

 Q_SIGNALS:
  void progressed(double share);
  /// A fine tooth as coarse voxels, to be looked at while it grows.
  void previewed(std::shared_ptr<const GrownSpecimen> specimen);
  void grown(std::shared_ptr<const GrownSpecimen> specimen);
  void failed(ImportFailure failure);

 private:
  struct Job {
    std::atomic<bool> cancel{false};
  };
  std::shared_ptr<Job> job_;
};

/// What exercises that come with the program say of a generator's tissues (feel, speed).
std::vector<ScenarioTissue> usual_tissues(const std::string& generator);
/// The same for the tissues that a volume holds; those that no exercise knows get the values of ScenarioTissue.
std::vector<ScenarioTissue> usual_tissues(const std::vector<Tissue>& tissues);

/// Highest solid place under x, y; nullopt beside the specimen.
std::optional<double> height_at(const Specimen& specimen, double x_mm, double y_mm);

}  // namespace cusp::ui
