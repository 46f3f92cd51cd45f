/// An imported specimen before it is kept: in 3D, with quarter turns that are its own and not the camera's, its tissues'
/// volumes, and what the import did to the file. Where windows have no OpenGL all but the picture is there. Thread: GUI;
/// turns and meshes are made on others.
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

/// What the preview shows of a specimen. Made on any thread: seconds for a jaw.
struct ImportedSpecimen {
  std::shared_ptr<const VoxelVolume> volume;
  std::shared_ptr<PatchFeed> patches;
  std::array<double, kTissueCodes> mm3{};
  Vec3 low_mm{0.0}, high_mm{0.0};  // of what is solid
};
ImportedSpecimen imported_specimen(VoxelVolume volume);

class ImportPreview : public QWidget {
  Q_OBJECT

 public:
  explicit ImportPreview(QWidget* parent = nullptr);
  void show_specimen(ImportedSpecimen made, const std::vector<ImportRemark>& remarks);
  void clear();

  /// As it stands after the turns; null: nothing is shown.
  const std::shared_ptr<const VoxelVolume>& volume() const { return made_.volume; }
  Vec3 size_mm() const { return made_.high_mm - made_.low_mm; }
  /// About x, y or z (0, 1, 2), by the right hand. Nothing happens while another turn is being made.
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
