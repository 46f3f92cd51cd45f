/// Which way is mesial, distal, buccal, lingual in the view: letters on a small disc. Not mirrored in right-to-left.
#pragma once

#include <QWidget>

#include "ui/view/tooth_view.h"

namespace cusp::ui {

class Compass : public QWidget {
  Q_OBJECT

 public:
  /// Follows the camera of `view`, which outlives this.
  Compass(ToothView& view, QWidget* parent);
  /// Of which tooth it speaks; hidden where `fdi` is no tooth's number, since no side is known then.
  void set_tooth(int fdi);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const ToothView& view_;
  int fdi_ = 0;
};

}  // namespace cusp::ui
