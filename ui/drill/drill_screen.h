/// The drilling screen: the tooth in the middle, depth and push beside it, the coach's message below, instruments in
/// the tray, section and scores at the right. It leads one attempt at an exercise from begin() to finished() or left().
/// Thread: GUI. It decides nothing about the tooth: the step does, and what it shows comes from the mirror.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "engine/base/haptic_port.h"
#include "ui/session/exercise_session.h"
#include "ui/session/session_device.h"
#include "ui/widgets/ports.h"

namespace cusp::ui {

struct DrillText {
  QString title;  // of the exercise, in the user's language
  QString aside;  // "Practice, attempt 7"; may be empty
};

class DrillScreen : public QWidget {
  Q_OBJECT

 public:
  /// `ports`: who answers questions.
  explicit DrillScreen(Ports ports, QWidget* parent = nullptr);
  ~DrillScreen() override;

  /// What the next attempt is drilled with; mouse and keys unless it is called. Before begin().
  void use_device(DeviceChoice choice);
  /// Where the tooth comes from; made for each attempt anew unless it is called. Before begin().
  void use_teeth(std::shared_ptr<class ToothCache> teeth);
  /// Whether the station's foot pedal is plugged in; asked while the attempt runs. Without it none is missed. Before begin().
  void watch_pedal(std::function<bool()> plugged);
  /// Makes the tooth ready and starts the attempt in the background; a Falcon's starts once it is homed. `port`: instead of the
  /// device that was chosen. Pre: no attempt is running.
  void begin(SessionPlan plan, const DrillText& text, std::unique_ptr<HapticPort> port = nullptr);
  bool running() const;
  /// Whether the attempt is being opened, measured or left.
  bool working() const;
  /// As ask_leave(), and calls `then` after left(). Work that goes on is called off, or shown: `then` follows left() or finished(). It is
  /// not called if the user stays, or if the record refuses the end of the attempt. Pre: running() or working().
  void ask_leave_then(std::function<void()> then);
  /// Input that is no event of the window and leads no bur: a SpaceMouse turns the tooth.
  void count_input();
  class ToothView* view() const;
  /// Where the drilling sound's volume and mute are kept, and whether the handpiece is drawn and in which hand; outlives the screen. Without: the usual
  /// ones, not kept.
  void keep_settings_in(class Settings* settings);

 public Q_SLOTS:
  /// Stops the clock and the force; the same again resumes. An assessment's clock is not stopped, only resumed after a fault.
  void toggle_pause();
  /// Asks, then ends the attempt and grades it.
  void ask_finish();
  /// Asks when something was cut, in an assessment for its start code; the attempt stays in the history as interrupted.
  void ask_leave();

 Q_SIGNALS:
  /// The attempt is over and graded. Emitted once an attempt.
  void finished(std::shared_ptr<const SessionResult> result);
  /// The attempt was left; nothing is running.
  void left();
  /// Before left(): the records could not be written and still show the attempt as running. Whoever has them tries again.
  void left_unmarked(const SessionId& session);
  /// It could not start or be graded: the page that opened it shows why.
  void failed(SessionFailure failure);

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make_main(class QVBoxLayout& column);
  void make_keys();
  void fold(bool on);
  bool is_small() const;
  void look();
  void opened(std::shared_ptr<struct OpenedAttempt> attempt, const std::optional<SessionFailure>& failure);
  void follow_pointer();
  void tooth_shown();
  void stop_undrawn();
  void hold_for_question();
  void answered_no();
  void hold_while_minimised();
  void keep_awake();
  void leave_now();
  void leave_after_work(std::function<void()> then);
  void report_left();
  void abandoned(const std::optional<SessionId>& unmarked);
  void finish_now();
  void graded(const std::shared_ptr<Outcome<SessionResult>>& result);
  void enable_controls(bool on);
  void show_opening();
  void show_progress();

  struct Inner;
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp::ui
