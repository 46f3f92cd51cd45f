/// Progress of a long task: shown after 300 ms, with a count, and with a way to cancel. Thread: GUI.
#pragma once

#include <QWidget>

#include "ui/widgets/gauge.h"

class QLabel;
class QPushButton;
class QTimer;

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

  static constexpr int kDelayMs = 300;  // a shorter wait needs no change of the screen

 Q_SIGNALS:
  void cancelled();

 private:
  bool running_ = false;
  QTimer* timer_;
  QLabel* title_;
  QLabel* counted_;
  Bar* bar_;
  QPushButton* cancel_;
};

}  // namespace cusp::ui
