/// Progress of a long task: shown after 300 ms, with a count, and with a way to cancel. Thread: GUI.
#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/widgets/gauge.h"

class QLabel;
class QPushButton;

namespace cusp::ui {

class Busy : public QWidget {
  Q_OBJECT

 public:
  explicit Busy(QWidget* parent = nullptr);
  enum class Cancel { offered, none };
  /// Becomes visible kDelayMs later unless finish() comes first.
  void start(const QString& title, Cancel cancel);
  void set_progress(double share, const QString& counted);
  void finish();
  bool running() const { return running_; }
  /// Where Cancel is shown.
  void focus_cancel();

  static constexpr int kDelayMs = 300;  // a shorter wait needs no change of the screen

 Q_SIGNALS:
  void shown();  // kDelayMs after start()
  void cancelled();

 private:
  bool running_ = false;
  QTimer* timer_;
  QLabel* title_;
  QLabel* counted_;
  Bar* bar_;
  QPushButton* cancel_;
};

/// A button whose work runs elsewhere. After Busy::kDelayMs its text says so. It stays enabled: a disabled button hands the focus on,
/// and a second Enter would press the next one. Whoever owns it ignores presses while running().
class ButtonWait {
 public:
  explicit ButtonWait(QPushButton* button);  // which outlives it
  void start(const QString& meanwhile);
  void finish();
  bool running() const { return running_; }

 private:
  void show_text(const QString& text);

  QPushButton* button_;
  QString before_, meanwhile_;
  QTimer timer_;
  bool running_ = false;
};

}  // namespace cusp::ui
