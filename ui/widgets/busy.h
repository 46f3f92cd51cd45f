/// Work that takes a while: shows after 300 ms, counts something real, can be cancelled.
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
  /// Begins; becomes visible 300 ms later unless finish() came before.
  void start(const QString& title, bool can_cancel);
  void set_progress(double share, const QString& counted);
  void finish();
  bool running() const { return running_; }

  static constexpr int kDelayMs = 300;  // shorter waits are not worth a change of the screen

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
