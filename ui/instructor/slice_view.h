/// One slice of a volume in grey, tinted with the tissues of its values. Thread: GUI.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>

#include "engine/volume/tissue.h"
#include "scenarios/import/import.h"
#include "ui/modules.h"

class QImage;
class QLabel;
class QSlider;

namespace cusp::ui {

class Segments;

class SliceView : public QWidget {
  Q_OBJECT

 public:
  explicit SliceView(QWidget* parent = nullptr);
  /// Shows the middle slice from above. Values of ImageKind::colours are drawn as colours, others as grey.
  /// `size`: voxels of the file, whose slices are numbered; the preview may have only every second or third.
  void show_preview(std::shared_ptr<const ImagePreview> preview, ImageKind kind, IVec3 size);
  /// `tissue_of` gives the tissue of a value; redraw() calls it for every pixel.
  void set_tissues(std::function<Tissue(float)> tissue_of);
  /// Direction of view: 0 along x, 1 along y, 2 along z.
  int axis() const;
  int slice() const;
  /// The slice as drawn, one pixel a voxel, upper row first.
  QImage picture() const;

 private:
  class Pane;
  void change_axis();
  void redraw();

  std::shared_ptr<const ImagePreview> preview_;
  ImageKind kind_ = ImageKind::grey;
  IVec3 size_{0};
  std::function<Tissue(float)> tissue_of_;
  float low_ = 0.0f, high_ = 1.0f;  // values drawn black and white
  Pane* pane_;
  Segments* axes_;
  QSlider* slider_;
  QLabel* where_;
};

}  // namespace cusp::ui
