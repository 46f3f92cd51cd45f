/// One handle on the tooth, of the target or of a landmark: the left button drags it, arrow keys move it by 0.05 mm, with Shift by
/// 0.01 mm. A dragged place goes to landmarks unless Shift is held; L takes it to the nearest. Delete removes a point or a landmark.
/// A landmark that is set has a dark core, and the handle of several shapes a cross. Thread: GUI.
#pragma once

#include <QWidget>

#include "ui/editor/target_handles.h"

namespace cusp::ui {

class TargetView;

class HandleKnob : public QWidget {
  Q_OBJECT

 public:
  HandleKnob(TargetView& stage, int index);
  void set_handle(const TargetHandle& handle, const QString& name, const QString& value);
  const TargetHandle& handle() const { return handle_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void fit_mask();
  void step_outline(glm::ivec2 keys, double step_mm);
  TargetView& stage_;
  TargetHandle handle_, start_;
  Region start_part_;
  QPointF start_at_;
  bool dragging_ = false;
};

/// The handle of a landmark, for a legend.
class KnobSample : public QWidget {
 public:
  KnobSample(MarkState state, QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  MarkState state_;
};

}  // namespace cusp::ui
