/// Mouse and keys to the pointer device: the bur follows the mouse over the tooth, the left button or Space drills,
/// the wheel and Page Up and Down set how hard, H holds the depth. Thread: GUI.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QSet>
#include <QTimer>
#include <optional>

#include "device/pointer/pointer_hand.h"
#include "ui/modules.h"
#include "ui/view/tooth_view.h"

namespace cusp::ui {

class PointerInput : public QObject {
  Q_OBJECT

 public:
  /// `hand` outlives this. `tool_axis`: unit, from the bur to the shank.
  PointerInput(ToothView& view, PointerHand& hand, Vec3 tool_axis, double usual_push_n, QObject* parent);

  enum class KeyPress { first, repeated };
  /// True when the key is one of drilling's and was taken.
  bool press_key(int key, KeyPress press = KeyPress::first);
  bool release_key(int key);
  /// Releases button and keys, wherever the events of their release go: at a loss of focus, a question.
  void release_all();
  /// Disabled, it releases them too. What stays pressed then, or is pressed meanwhile, drills only after its release.
  void set_enabled(bool on);
  /// Whether such a button or key is still pressed.
  bool ignores_cut() const { return enabled_ && (ignores_button_ || ignores_space_); }

  /// Where the bur stands, and how far above the floor of the target: a sweeping push goes no deeper. nullopt: no floor there.
  void follow_bur(Vec3 pivot_mm, std::optional<double> above_floor_mm);
  /// Where the hand is at the bur's depth; nullopt unless it drills.
  std::optional<Vec3> hand_mm(Vec3 pivot_mm) const;
  /// Holds the depth at which the bur stood while it drilled last, or no longer. Before the first drilling nothing is held.
  void hold_depth(bool on);

  /// The next depth to hold is that of the next drilling.
  void forget_depth();

  /// What drilling pushes with, N.
  double push_n() const { return push_n_; }

  static constexpr double kPushStepN = 0.1;  // a notch of the wheel, a press of Page Down
  static constexpr double kLeastPushN = 0.1;
  static constexpr double kSlideMmS = 2.5;   // of a held arrow key; with Shift a fifth
  static constexpr double kTurnDegPerMm = 12.0;  // with Ctrl an arrow key turns the handpiece: 30 degrees a second

 Q_SIGNALS:
  void push_changed(double newtons);
  void drilled();  // the cut was switched on
  void depth_held(bool on);

 protected:
  /// Of the view: whatever takes the mouse away releases the button.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void stop();
  void show_view();
  void slide(QPointF at);
  void hand_over();
  void step_keys();
  void turn_wheel(int delta);
  void change_push(double by);

  ToothView& view_;
  PointerHand& hand_;
  Vec3 axis_;
  double push_n_;
  int wheel_ = 0;  // of the next notch, in its parts
  double held_push_n_ = 0;  // of Page Down: rests on the tooth without drilling
  bool button_ = false, space_ = false, enabled_ = true;
  bool ignores_button_ = false, ignores_space_ = false;  // pressed, and to be released first
  bool held_ = false;
  std::optional<Vec3> drilled_mm_;  // pivot of the bur, as it was last seen drilling: a press of a button lifts it
  std::optional<Vec3> plane_at_;    // the place that was pressed: while drilling the mouse slides over the plane through it
  QSet<int> arrows_;
  QTimer timer_;
  QElapsedTimer since_;
};

}  // namespace cusp::ui
