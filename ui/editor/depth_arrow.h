/// The depth of a target as it is drawn on the tooth: an arrow from the floor up to the reference plane. Shaped, not
/// translucent: what lies below is OpenGL. GUI thread.
#pragma once

#include <QPainterPath>
#include <QPointF>
#include <QWidget>

namespace cusp::ui {

class DepthArrow : public QWidget {
 public:
  explicit DepthArrow(QWidget* parent);
  /// Both in the parent's coordinates; too near each other, nothing is shown.
  void span(QPointF floor, QPointF top);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPainterPath path_;
};

}  // namespace cusp::ui
