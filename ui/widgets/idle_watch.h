/// Reports that nobody has used mouse, keys, pen or screen for a while, the sleep of the computer included. Thread: GUI.
#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>
#include <functional>

namespace cusp::ui {

/// Counts while the computer sleeps, and does not follow a clock that is set. Any thread.
std::chrono::milliseconds time_since_boot();

class IdleWatch : public QObject {
  Q_OBJECT

 public:
  /// Sees every input of the application. `clock`: milliseconds that rise.
  explicit IdleWatch(std::function<std::chrono::milliseconds()> clock = time_since_boot, QObject* parent = nullptr);
  /// 0: never. Begins anew.
  void set_limit(std::chrono::milliseconds limit);
  /// Of a device whose motion is no event of the window. False: it came after the limit, and idle() follows.
  bool count_input();
  /// Time since the last input; before the first one without meaning.
  std::chrono::milliseconds idle_for() const { return clock_() - last_input_; }

 Q_SIGNALS:
  /// Once; again after the next input and the same time without any.
  void idle();

 protected:
  /// The first input after too long a sleep reaches nobody: whoever wakes the computer may be another.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void look();
  void wait();

  std::function<std::chrono::milliseconds()> clock_;
  std::chrono::milliseconds limit_{0}, last_input_{0};
  QTimer timer_;  // stands still while the computer sleeps
};

}  // namespace cusp::ui
