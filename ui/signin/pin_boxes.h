/// Six boxes for six digits. Typing moves on, Backspace moves back, a pasted PIN spreads. Never mirrored.
#pragma once

#include <QVector>
#include <QWidget>

class QLineEdit;

namespace cusp::ui {

class PinBoxes : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kDigits = 6;
  explicit PinBoxes(QWidget* parent = nullptr);
  QString pin() const;
  void clear();
  void set_wrong(bool wrong);
  QLineEdit* box(int i) const { return boxes_[i]; }

 Q_SIGNALS:
  void completed();
  void edited();
  void accepted();  // Return

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QVector<QLineEdit*> boxes_;
};

}  // namespace cusp::ui
