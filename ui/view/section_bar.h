/// The section of a tooth that stands still: which way its plane goes, a slider for its place, and the picture that closes the
/// cutaway, drawn in Qt's pool. Frame: specimen, z up. Thread: GUI.
#pragma once

#include <QFrame>
#include <memory>
#include <optional>

#include "engine/volume/volume.h"
#include "scenarios/format/scenario.h"
#include "ui/modules.h"
#include "ui/render/camera.h"
#include "ui/render/scenery_look.h"
#include "ui/render/section.h"

class QBoxLayout;
class QLabel;
class QSlider;

namespace cusp::ui {

class Segments;
class ToothView;

class SectionBar : public QFrame {
  Q_OBJECT

 public:
  /// What the plane cuts; immutable.
  struct Cut {
    std::shared_ptr<const Volume> volume;
    Region target;
    Leeway leeway;
    std::shared_ptr<const SceneryLook> scenery;  // null: none
    std::shared_ptr<const Volume> ideal;         // its walls stand in place of the target's line; null: none
  };
  enum class Way : std::uint8_t { mesiodistal, buccolingual };  // the plane lies along the frame's x, or its y

  /// Closed. `view` outlives this.
  explicit SectionBar(ToothView& view, QWidget* parent = nullptr);
  /// `fdi`: of the tooth, whose sides the bar names; 0: of no tooth.
  void set_tooth(int fdi);
  void show_cut(Cut cut);
  /// Open, the view is turned to face the plane; closed, it is as it was before.
  void open();
  void close();
  bool is_open() const { return open_; }
  /// Tab comes here from that widget of the same window.
  void tab_after(QWidget* before);
  /// Moves the plane through this place. If it lies at a wall, the plane takes the way that meets the wall at right angles.
  void go_through(Vec3 mm);

  Way way() const { return way_; }
  void choose(Way way);
  QSlider* slider() const { return slider_; }
  /// From the target's middle: towards buccal, or along the frame's x.
  double place_mm() const;
  SectionPlane plane() const;
  /// Width and height of the picture about plane().centre_mm; the whole specimen lies in it.
  glm::dvec2 picture_mm() const;
  static constexpr double kStepMm = 0.1;  // of the slider; Page Up and Down: five

 Q_SIGNALS:
  /// The plane stands elsewhere.
  void moved();
  /// A picture of the newest wish closes the cutaway.
  void shown();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  class CutLook;

  Vec3 across() const;
  void measure();
  void centre_on(Vec3 middle_mm);
  void fit_slider();
  void face();
  void follow_camera();
  void show_place();
  void fit_head();
  void draw();
  /// target_mm: the target's middle at its top, as the picture's CutLook has it.
  void take(SectionImage image, const std::shared_ptr<CutLook>& of, const std::optional<Vec3>& target_mm);

  ToothView& view_;
  QBoxLayout* head_;  // ways and place: beside each other where they fit
  Segments* ways_;
  QSlider* slider_;
  QLabel *place_, *low_, *high_;
  Cut cut_;
  Vec3 low_mm_{0.0}, high_mm_{0.0};  // of the specimen
  Vec3 middle_mm_{0.0};           // of the target at its top; without one, of the specimen at its top
  Vec3 through_mm_{0.0};
  Way way_ = Way::buccolingual;
  int fdi_ = 0;
  double facing_ = 1.0;           // -1: the viewer stands on the other side of the plane
  std::optional<Camera> before_;  // the section was opened
  std::shared_ptr<CutLook> look_;  // of cut_
  bool open_ = false, drawing_ = false, stale_ = false;
};

}  // namespace cusp::ui
