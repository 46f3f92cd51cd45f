/// A line edit for a PIN of six digits, painted as six boxes. It drops whatever is no digit, so a pasted " 271 828 " is
/// taken whole. Right-to-left layouts do not mirror it. Thread: GUI.
#pragma once

#include <QLineEdit>

namespace cusp::ui {

class PinField : public QLineEdit {
  Q_OBJECT

 public:
  static constexpr int kDigits = 6;
  explicit PinField(QWidget* parent = nullptr);
  /// Draws the boxes in the colour of an error until the next edit.
  void show_refused();
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 Q_SIGNALS:
  /// The sixth digit was typed or pasted.
  void completed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  bool refused_ = false;
};

}  // namespace cusp::ui
