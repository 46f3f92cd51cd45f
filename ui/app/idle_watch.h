/// Says when nobody has used mouse, keys, pen or screen for a while. Thread: GUI.
#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>

namespace cusp::ui {

class IdleWatch : public QObject {
  Q_OBJECT

 public:
  /// Sees every input of the application.
  explicit IdleWatch(QObject* parent = nullptr);
  /// 0: never. Begins anew.
  void set_limit(std::chrono::milliseconds limit);

 Q_SIGNALS:
  /// Once; again after the next input and the same time without any.
  void idle();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QTimer timer_;
};

}  // namespace cusp::ui
