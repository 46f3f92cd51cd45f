/// Play, position and speed of something that is watched. Shows its own time; what is watched may hold it back. Thread: GUI.
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;
class QSlider;

namespace cusp::ui {

class Segments;

class PlaybackBar : public QFrame {
  Q_OBJECT

 public:
  explicit PlaybackBar(QWidget* parent = nullptr);
  void set_length(double seconds);
  double position_s() const { return position_s_; }
  bool playing() const { return playing_; }
  /// At the end it begins anew.
  void set_playing(bool on);
  void seek(double s);
  /// `dt_s` of the watcher's time has passed; `ready_s`: how far can be shown. Time stands kAhead_s after it,
  /// and while the slider is held.
  void advance(double dt_s, double ready_s);
  /// Space, arrows by 1 s, with Shift by 0.1 s, Home and End; false for other keys.
  bool press_key(int key, Qt::KeyboardModifiers modifiers);

  static constexpr double kAhead_s = 0.25;

 Q_SIGNALS:
  void position_changed(double s);
  void playing_changed(bool on);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show_position();
  void show_playing();

  QPushButton* play_;
  QSlider* slider_;
  QLabel* time_;
  Segments* speed_;
  double length_s_ = 0, position_s_ = 0;
  bool playing_ = false;
};

}  // namespace cusp::ui
