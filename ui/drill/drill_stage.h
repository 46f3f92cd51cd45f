/// The view of the drilling screen with what stands on it: tool bar, depth and push, coach, legend, directions, hint,
/// and the band that stops everything. Opaque child widgets: each pixel is copied once a frame. Thread: GUI.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "scenarios/format/scenario.h"
#include "ui/drill/attempt_opening.h"
#include "ui/drill/coach.h"
#include "ui/drill/drill_feed.h"
#include "ui/drill/stop_card.h"
#include "ui/modules.h"
#include "ui/session/observer.h"
#include "ui/view/tooth_view.h"

class QFrame;
class QLabel;
class QPushButton;

namespace cusp::ui {

inline constexpr int kStageGap = 12;  // between what stands over the view and its edges, px at 100 %

class Compass;
class Gauge;
class CutSlider;
class HandGhost;
class MirrorHold;

class DrillStage : public QWidget {
  Q_OBJECT

 public:
  using Stop = StopCard::Stop;

  explicit DrillStage(QWidget* parent = nullptr);
  ToothView* view() const { return view_; }

  /// What the stage shows of an exercise besides its scenario and target.
  struct Setup {
    Box bounds{};                           // of the specimen, mm
    StartView start_view{};
    Guidance guidance = Guidance::full;
    bool by_mouse = false;                  // else a device leads the bur
    bool is_tooth = false;                  // else a block
    std::optional<double> pulp_depth_mm{};  // of the highest pulp under the target, below its top; nullopt: none
  };
  void set_exercise(const Scenario& scenario, const TargetLook& look, const Setup& setup);
  /// `falcon`: its state while it does not answer the attempt; nullptr for another device.
  void show_values(const LiveView& live, const FalconView* falcon = nullptr);
  /// What the mouse would push with, N.
  void show_wanted_push(double newtons);
  /// Whether the mouse holds the bur's depth.
  void show_depth_held(bool on);
  /// Moves the tag at the bur, which has the coach's figure while something is worth a look, and the ghost of the mouse's hand.
  /// `hand_mm`: at the bur's depth; nullopt: the mouse does not drill.
  void follow_bur(Vec3 pivot_mm, const std::optional<Vec3>& hand_mm);
  void show_cutaway(SectionImage image);
  void show_stopped(Stop stop, const Message& record = {}, Fault fault = Fault::none);
  /// From now on the attempt stands because nothing is drawn.
  void set_undrawn() { undrawn_ = true; }
  bool undrawn() const { return undrawn_; }
  /// Of a device that is lost, its handle alone is missing.
  void set_handle_gone(bool on) { handle_gone_ = on; }
  /// While a question stands over the screen, the pause that it made is not shown besides.
  void set_asking(bool on) { asking_ = on; }
  void enable_tools(bool on);
  void show_handpiece(bool on);
  /// 1 to 6 of the tool bar, and the mirror's keys; false for other keys.
  bool press_key(int key, Qt::KeyboardModifiers modifiers);
  /// Live values as one sentence, for a screen reader on request.
  QString spoken() const;
  /// A widget in the middle of the view (loading).
  void set_centre(QWidget* widget);

 Q_SIGNALS:
  void depth_hold_wanted(bool on);
  /// Shown or put away by somebody.
  void handpiece_switched(bool shown);
  void go_on();
  void finish_again();
  void leave();
  void sections_wanted(const std::optional<SectionWish>& panel, const std::optional<SectionWish>& lid);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void make_tools();
  void connect_tools();
  void make_gauges();
  static QFrame* make_card(QWidget* parent);
  void make_coach();
  void make_legend();
  void place_all();
  void place_tools(int gap);
  void place_gauges(int gap);
  void place_compass(int gap);
  void place_cut(int gap);
  void place_mirror_hint(int gap);
  void place_coach(int gap);
  /// Without room for all of it the stage leaves out the legend and puts the wheel's force beside the tools.
  bool is_scarce() const;
  void want_sections();
  void hold_mirror(bool on);
  double required_depth_mm() const;
  double bur_radius_mm() const;
  void scale_depth(double seen_mm);
  /// Band and limit of the depth gauge about the required depth.
  void show_required(double depth_mm);
  void show_depth(const LiveView& live, double bur_radius_mm);
  void show_coach(CoachLine line);
  QString coach_text(const CoachLine& line) const;
  void sign_coach(CoachTone tone);

  ToothView* view_;
  MirrorHold* mirror_hold_;
  HandGhost* hand_ghost_;
  QFrame *tools_, *coach_card_, *legend_;
  StopCard* stop_card_;
  QPushButton *turn_, *mirror_, *cutaway_, *above_, *target_, *handpiece_;
  std::vector<std::pair<QPushButton*, QLabel*>> caps_;  // each tool's key
  Gauge *depth_, *push_;
  QLabel *coach_sign_, *coach_, *wanted_push_, *bur_tag_, *mirror_hint_;
  QPushButton* hold_;
  Compass* compass_;
  CutSlider* cut_;
  QWidget* centre_ = nullptr;
  std::optional<TargetLook> look_;
  Leeway leeway_;
  std::vector<Bur> burs_;
  LiveView live_;
  CoachLine shown_, spoken_;  // on the screen; last announced to a screen reader
  bool by_mouse_ = false, is_tooth_ = false, asking_ = false, undrawn_ = false, handle_gone_ = false;
  int mesial_x_ = 0;  // of the tooth; 0 where no side is known
  bool guided_ = true;  // no assessment
  bool wide_ = false;  // the specimen is more than one tooth
  int preset_ = 0;
  std::optional<double> pulp_depth_mm_;
};

}  // namespace cusp::ui
