/// How far the cutaway's plane stands before or behind the bur, as a slider over the view. Thread: GUI.
#pragma once

#include <QFrame>

class QLabel;
class QSlider;

namespace cusp::ui {

class CutSlider : public QFrame {
  Q_OBJECT

 public:
  explicit CutSlider(QWidget* parent = nullptr);
  /// Towards the viewer; negative: away.
  double nearer_mm() const;
  /// Through the bur again.
  void centre();
  /// At most `width_px` wide; a narrow one leaves out its ends' names.
  void fit(int width_px);
  QSlider* slider() const { return slider_; }

  static constexpr double kMostMm = 6.0, kStepMm = 0.1;  // half a molar; Page Up and Down: five steps

 Q_SIGNALS:
  void moved();

 private:
  void show_place();

  QSlider* slider_;
  QLabel *far_, *near_, *place_;
};

}  // namespace cusp::ui
