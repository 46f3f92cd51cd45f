/// What the handpiece does, as far as the exercise reckons it: speed of the spindle, coolant, the tooth's warmth, and the
/// sound. Parts that the exercise does not ask for are not there. Shows what it is given; decides nothing. Thread: GUI.
#pragma once

#include <QFrame>

#include "scenarios/format/scenario.h"
#include "ui/modules.h"
#include "ui/session/exercise_session.h"
#include "ui/session/observer.h"

class QBoxLayout;
class QLabel;
class QPushButton;
class QSlider;
class QToolButton;

namespace cusp::ui {

class Bar;

class HandpiecePanel : public QFrame {
  Q_OBJECT

 public:
  explicit HandpiecePanel(QWidget* parent = nullptr);

  /// Once. Hidden as a whole where the exercise asks for none of it. silent: no warmth, which is a score.
  void set_exercise(const Scenario& scenario, Guidance guidance = Guidance::full);
  void show_values(const LiveView& live);
  struct Sound {
    bool available = false;  // false: the station has no output, and the panel shows that
    int volume_percent = 0;
    bool muted = false;
  };
  void set_sound(const Sound& sound);
  /// Titles and numbers alone.
  void fold(bool on);
  /// W and M of a hidden panel, whose buttons take no key. False for other keys, and where the exercise has no such part.
  bool press_key(int key);
  /// Speed, coolant and warmth as one sentence; empty where there is none.
  QString spoken() const;

 Q_SIGNALS:
  void coolant_changed(bool on);
  void volume_changed(int percent);
  void muted_changed(bool muted);

 private:
  /// It runs by this switch or by the pedal's.
  void show_coolant();
  void show_muted();

  bool pedal_wets_ = false;  // coolant runs that this switch did not ask for
  QBoxLayout* head_;
  QWidget *speed_row_, *heat_part_, *sound_row_;
  QLabel *speed_, *heat_, *heat_note_, *no_sound_;
  QPushButton* coolant_;
  Bar* heat_bar_;
  QToolButton* mute_;
  QSlider* volume_;
  bool spindle_ = false, reckons_heat_ = false, shows_heat_ = false, sounds_ = false, over_ = false, folded_ = false;
};

}  // namespace cusp::ui
