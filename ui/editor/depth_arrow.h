/// Depth of a target on the picture of the tooth: an arrow from the floor to the reference plane. A mask shapes the widget, since
/// OpenGL below it allows no translucency. Thread: GUI.
#pragma once

#include <QPainterPath>
#include <QPointF>
#include <QWidget>

namespace cusp::ui {

class DepthArrow : public QWidget {
 public:
  explicit DepthArrow(QWidget* parent);
  /// Both points in the parent's coordinates. If they are too close, the arrow is hidden.
  void span(QPointF floor, QPointF top);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPainterPath path_;
};

}  // namespace cusp::ui
