/// What the program still waits for after its window has closed, and the way not to wait for it. Thread: GUI.
#pragma once

#include <QTimer>
#include <QWidget>
#include <cstdint>

#include "ui/session/background_task.h"

class QEventLoop;
class QLabel;
class QPushButton;

namespace cusp::ui {

class ClosingWindow : public QWidget {
  Q_OBJECT

 public:
  /// left: work goes on, and somebody does not wait for it, or a signal ends the program beside what is harmless.
  enum class End : std::uint8_t { work_over, left };

  explicit ClosingWindow(QWidget* parent = nullptr);
  /// Until no dropped background task and no job of Qt's pool is at work. Shows itself only if that takes a while. Pages are gone by then.
  End wait();
  QString text() const;
  QPushButton* leave() const { return leave_; }

 protected:
  /// As its button, where nothing can be lost; else it stays.
  void closeEvent(QCloseEvent* event) override;

 private:
  void look();
  void show_wait();
  void end(End how);

  QLabel *what_, *more_;
  QPushButton* leave_;
  QTimer look_timer_, show_timer_;
  QEventLoop* loop_ = nullptr;  // while wait() runs
  DroppedWork work_ = DroppedWork::none;
  End end_ = End::work_over;
};

}  // namespace cusp::ui
