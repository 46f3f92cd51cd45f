/// Sample of a line for a legend: the target's or the tolerance zone's, as the tooth shows it. Thread: GUI.
#pragma once

#include <QPainter>
#include <QWidget>

#include "ui/widgets/theme.h"

namespace cusp::ui {

class LineSample : public QWidget {
 public:
  enum class Line { target, tolerance_zone };
  LineSample(Line line, QWidget* parent) : QWidget(parent), line_(line) { setFixedSize(px(24), px(12)); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const bool dashed = line_ == Line::tolerance_zone;
    QPen pen(dashed ? tokens().line_leeway : tokens().line_target, px(3));
    pen.setCapStyle(Qt::FlatCap);
    if (dashed) pen.setDashPattern({2, 1.2});
    p.setPen(pen);
    p.drawLine(QPointF(0, height() / 2.0), QPointF(width(), height() / 2.0));
  }

 private:
  Line line_;
};

}  // namespace cusp::ui
