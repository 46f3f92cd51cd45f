/// The picture of homing: the three arms and the grip seen from the front, filled where an arm knows its place, with an
/// arrow for the way that the grip has to go, and its text. Moves only as the device moves. Thread: GUI.
#pragma once

#include <QWidget>

#include "device/falcon/falcon_port.h"
#include "ui/modules.h"

class QLabel;

namespace cusp::ui {

class HomingView : public QWidget {
  Q_OBJECT

 public:
  explicit HomingView(QWidget* parent = nullptr);
  void show_falcon(const FalconView& view);
  QString text() const;

 private:
  class Picture;
  Picture* picture_;
  QLabel *phase_, *sentence_;
};

}  // namespace cusp::ui
