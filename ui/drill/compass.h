/// Which way is mesial, distal, buccal, lingual in the view: letters on a small disc. Not mirrored in right-to-left.
#pragma once

#include <QWidget>

#include "ui/drill/tooth_view.h"

namespace cusp {

class Compass : public QWidget {
  Q_OBJECT

 public:
  Compass(const ToothView& view, QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const ToothView& view_;
};

}  // namespace cusp
