/// Which way is mesial, distal, buccal, lingual in the view: letters on a small disc. Not mirrored in right-to-left.
#pragma once

#include <QString>
#include <QWidget>
#include <array>

#include "ui/view/tooth_view.h"

namespace cusp::ui {

class Compass : public QWidget {
  Q_OBJECT

 public:
  struct Way {
    Vec3 way;  // unit, specimen frame
    QString letter;
  };
  /// The four sides of a tooth as its frame has them (scenarios/teeth/landmarks.h). Pre: mesial_x(fdi) is not 0.
  static std::array<Way, 4> ways(int fdi);

  Compass(const ToothView& view, QWidget* parent);
  /// Of which tooth it speaks; hidden where `fdi` is no tooth's number, since no side is known then.
  void set_tooth(int fdi);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const ToothView& view_;
  int fdi_ = 0;
};

}  // namespace cusp::ui
