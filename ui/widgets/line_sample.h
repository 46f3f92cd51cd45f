/// Sample of a line for a legend, as the tooth shows it: of the target, the tolerance zone, or a reference preparation in a section. Thread: GUI.
#pragma once

#include <QPainter>
#include <QWidget>

#include "ui/widgets/theme.h"

namespace cusp::ui {

class LineSample : public QWidget {
 public:
  enum class Line { target, tolerance_zone, reference };
  LineSample(Line line, QWidget* parent) : QWidget(parent), line_(line) { setFixedSize(px(24), px(12)); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const QLineF line(0, height() / 2.0, width(), height() / 2.0);
    QPen pen(line_ == Line::tolerance_zone ? tokens().line_leeway : line_ == Line::reference ? ToothColours::get().casing : tokens().line_target,
             px(3));
    pen.setCapStyle(Qt::FlatCap);
    if (line_ == Line::tolerance_zone) pen.setDashPattern({2, 1.2});
    p.setPen(pen);
    p.drawLine(line);
    if (line_ != Line::reference) return;
    pen.setColor(ToothColours::get().map[2]);  // the lighter dashes between
    pen.setDashPattern({1.4, 1.4});
    p.setPen(pen);
    p.drawLine(line);
  }

 private:
  Line line_;
};

}  // namespace cusp::ui
