/// One line of the legend: the target's or the tolerance zone's, as the tooth shows it. Thread: GUI.
#pragma once

#include <QPainter>
#include <QWidget>

#include "ui/modules.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {

class LineSample : public QWidget {
 public:
  enum class Line { target, tolerance_zone };
  LineSample(Line line, QWidget* parent) : QWidget(parent), line_(line) { setFixedSize(px(22), px(12)); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    const bool dashed = line_ == Line::tolerance_zone;
    QPen pen(dashed ? tokens().line_leeway : tokens().line_target, dashed ? 2 : 3);
    if (dashed) pen.setDashPattern({3, 2});
    p.setPen(pen);
    p.drawLine(0, height() / 2, width(), height() / 2);
  }

 private:
  Line line_;
};

}  // namespace cusp::ui
