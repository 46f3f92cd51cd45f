/// Preview of an imported specimen: 3D view, quarter turns of the specimen, volumes of its tissues, remarks of the import. Without
/// OpenGL only the view is missing. Thread: GUI; Qt's pool makes turns and meshes.
#pragma once

#include <QWidget>
#include <array>
#include <memory>
#include <vector>

#include "engine/volume/specimen.h"
#include "engine/volume/voxel_volume.h"
#include "scenarios/import/remarks.h"
#include "ui/modules.h"

class QLabel;

namespace cusp::ui {

class PatchFeed;
class ToothView;

/// Data of the preview. Thread: any; takes seconds for a jaw.
struct ImportedSpecimen {
  std::shared_ptr<const VoxelVolume> volume;
  std::shared_ptr<PatchFeed> patches;
  std::array<double, kTissueCodes> mm3{};
  Vec3 low_mm{0.0}, high_mm{0.0};  // bounds of the solid voxels
};
ImportedSpecimen imported_specimen(VoxelVolume volume);

class ImportPreview : public QWidget {
  Q_OBJECT

 public:
  explicit ImportPreview(QWidget* parent = nullptr);
  void show_specimen(ImportedSpecimen made, const std::vector<ImportRemark>& remarks);
  void clear();

  /// The volume after all turns; null without a specimen.
  const std::shared_ptr<const VoxelVolume>& volume() const { return made_.volume; }
  Vec3 size_mm() const { return made_.high_mm - made_.low_mm; }
  /// Turns about x, y or z (0, 1, 2) by the right-hand rule. A call during another turn does nothing.
  void turn(int axis, int quarters);
  bool turning() const { return turning_; }

 Q_SIGNALS:
  /// A turn began or ended.
  void turning_changed();

 private:
  void show_made();

  ImportedSpecimen made_;
  bool turning_ = false;
  ToothView* view_;
  QWidget* turns_;
  QLabel *facts_, *warnings_, *notes_;
};

}  // namespace cusp::ui
