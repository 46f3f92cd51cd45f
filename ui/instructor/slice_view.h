/// One slice of a volume, grey, with the colours of the tissues that its values would become; live.
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
  /// Begins in the middle, seen from above. Colours stand for themselves, other values are grey.
  void show_preview(std::shared_ptr<const ImagePreview> preview, ImageKind kind);
  /// Which tissue a value becomes; called for every pixel that is drawn.
  void set_tissues(std::function<Tissue(float)> tissue_of);
  /// 0: along x, 1: along y, 2: along z.
  int axis() const;
  int slice() const;
  /// The slice as it is drawn, one pixel a voxel, its upper row first.
  QImage picture() const;

 private:
  class Pane;
  void change_axis();
  void redraw();

  std::shared_ptr<const ImagePreview> preview_;
  ImageKind kind_ = ImageKind::grey;
  std::function<Tissue(float)> tissue_of_;
  float low_ = 0.0f, high_ = 1.0f;  // black and white
  Pane* pane_;
  Segments* axes_;
  QSlider* slider_;
  QLabel* where_;
};

}  // namespace cusp::ui
