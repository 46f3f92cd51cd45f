/// A section of tooth and bur as a picture beside the stage. Thread: GUI.
#pragma once

#include <QImage>
#include <QString>
#include <QWidget>

#include "ui/modules.h"
#include "ui/render/section.h"

namespace cusp::ui {

/// The picture of a section on the view's background, with the letters of its two sides.
class SectionView : public QWidget {
  Q_OBJECT

 public:
  explicit SectionView(QWidget* parent = nullptr);
  void show_image(const SectionImage& image);
  void set_sides(const QString& left, const QString& right);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void draw_side(QPainter& p, const QString& side, Qt::Alignment where) const;
  QImage image_;
  QString left_, right_;
};

}  // namespace cusp::ui
