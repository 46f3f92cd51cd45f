/// The chosen exercise below the library's list: picture, level and time, burs, pass mark, who uses it. Thread: GUI.
#pragma once

#include <QFrame>
#include <QImage>

#include "scenarios/format/scenario.h"
#include "ui/modules.h"

class QLabel;

namespace cusp::ui {

class ExerciseCard : public QFrame {
  Q_OBJECT

 public:
  explicit ExerciseCard(QWidget* parent = nullptr);
  void show_exercise(const Scenario& exercise);
  /// Null while it is being drawn.
  void show_picture(const QImage& picture);
  void show_use(const QString& use);
  /// Where height is scarce the name and the use stand alone.
  void fold(bool on);

 private:
  QLabel *picture_, *title_, *facts_, *use_;
};

}  // namespace cusp::ui
