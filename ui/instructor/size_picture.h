/// A file's bounding box from the side beside a lower first molar, both to one scale: a wrong unit is seen at once. Thread: GUI.
#pragma once

#include <QWidget>

#include "engine/base/vec.h"
#include "ui/modules.h"

namespace cusp::ui {

class SizePicture : public QWidget {
  Q_OBJECT

 public:
  explicit SizePicture(QWidget* parent = nullptr);
  void show_size(Vec3 size_mm);
  /// Pixels to a millimetre at which both fit.
  double px_per_mm() const;
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Vec3 size_mm_{0.0};
};

}  // namespace cusp::ui
