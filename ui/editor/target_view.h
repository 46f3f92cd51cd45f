/// The tooth with the handles of the target, or of the landmarks of a tooth from a file. Each handle is a widget with focus, name and value: the left button drags it, arrow
/// keys move it by 0.05 mm, with Shift by 0.01 mm. Elsewhere the left button turns the tooth. Outlines follow a drag at once, the
/// cavity after a pause. A section goes through the tooth as it is shown. Thread: GUI; the pool makes the meshes.
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ui/editor/editor_model.h"
#include "ui/editor/node_handles.h"
#include "ui/editor/specimen_grower.h"
#include "ui/editor/target_handles.h"
#include "ui/render/overlay_line.h"

class QFrame;
class QLabel;
class QPushButton;

namespace cusp::ui {

class DepthArrow;
class HandleKnob;
class SceneryLook;
class SectionBar;
class ToothView;

class TargetView : public QWidget {
  Q_OBJECT

 public:
  explicit TargetView(EditorModel& model, QWidget* parent = nullptr);
  ~TargetView() override;

  enum class Shows : std::uint8_t { target, landmarks };
  /// Landmarks, while the exercise has any, stand on the whole tooth without the target.
  void set_shown(Shows what);
  /// Null hides the handles: no specimen is grown yet.
  void set_specimen(std::shared_ptr<const GrownSpecimen> grown);
  ToothView* view() const { return view_; }
  SectionBar* section() const { return section_; }
  /// A widget in the middle: progress, or the cause of a failure.
  void set_centre(QWidget* widget);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  friend class HandleKnob;
  void make_tools();
  void fit_tools();
  void make_legend();
  void make_section(QPushButton& button);
  void cut_section();
  void place_section();
  void follow_model();
  void place_all();
  void place_handles();
  std::vector<TargetHandle> present_handles();
  std::vector<TargetHandle> node_handles();
  void place_tag(QLabel* tag, QPoint at);
  static void show_tag(QLabel& tag);
  void look_at_target();
  void show_scenery();
  void run_next();
  void apply(const TargetHandle& handle, const Outline& from, Vec3 to_mm);
  enum class Snap : std::uint8_t { landmarks, none };
  struct Way {
    QPointF from, to;  // of the widget
    Snap snap = Snap::landmarks;
  };
  void drag_part(const TargetHandle& handle, const Region& from, const Way& way);
  /// `keys`: steps to the right and up.
  void step_part(const TargetHandle& handle, glm::ivec2 keys, double step_mm);
  void place_part(const TargetHandle& handle, Vec3 to_mm);
  /// Landmarks that a place may go to: of the grown tooth, or of the exercise.
  std::span<const Landmark> present_marks() const;
  /// Above the landmark that is near on the screen; the same place if none is.
  Vec3 snapped(Vec3 to_mm) const;
  /// Takes a place above the nearest landmark.
  void snap(const TargetHandle& handle);
  /// Of the landmark under a place; empty if none is.
  QString place_name(const TargetHandle& handle) const;
  void name_place(HandleKnob& knob, const TargetHandle& handle);
  void write_hint();
  /// On the surface under the pointer; an axis' end, and a place beside the tooth, in the plane that faces the viewer.
  void drag_landmark(const TargetHandle& handle, const Way& way);
  void step_landmark(const TargetHandle& handle, glm::ivec2 keys, double step_mm);
  void name_landmark_handle(HandleKnob& knob, const TargetHandle& handle);
  bool shows_landmarks() const;
  bool is_chosen(const TargetHandle& handle) const;
  /// Hidden: a landmark behind the tooth, unless it is the chosen one.
  bool is_seen(const TargetHandle& handle) const;
  void show_lines();
  void follow_landmarks();
  /// The place after a way in the plane that faces the viewer.
  Vec3 moved_in_view(Vec3 from_mm, const Way& way) const;
  /// Unit steps along the axes of the frame that lie nearest to right and up.
  Vec3 way_of(glm::ivec2 keys) const;
  void name_part_handle(HandleKnob& knob, const TargetHandle& handle);
  void name_outline_handle(HandleKnob& knob, std::size_t i, QPointF at);
  QLabel* tag_of(const TargetHandle& handle) const;
  /// Place on the reference plane under a position of the widget.
  std::optional<Vec3> on_plane(QPointF at) const;

  EditorModel& model_;
  ToothView* view_;
  QFrame *tools_, *legend_;
  QWidget *target_legend_, *mark_legend_;  // of legend_
  SectionBar* section_;
  QPushButton* carved_button_ = nullptr;
  std::vector<std::pair<QPushButton*, QString>> tool_texts_;
  QLabel *depth_tag_, *width_tag_, *mark_tag_, *hint_;
  DepthArrow* arrow_;
  QWidget* centre_ = nullptr;
  std::vector<HandleKnob*> knobs_;  // in the order of handles_of(); the others are hidden
  std::vector<TargetHandle> handles_;
  std::shared_ptr<const GrownSpecimen> grown_;
  /// The anchor of the chosen node's handle, and what it was found for.
  struct FoundAnchor {
    Region node;  // with neither rounding nor growth
    std::shared_ptr<const GrownSpecimen> grown;
    std::optional<NodeAnchor> anchor;
  };
  FoundAnchor found_;
  std::shared_ptr<const Volume> preview_;          // that the view shows; null: not yet
  std::shared_ptr<const SceneryLook> scenery_;     // of the same tooth; null: none, or not yet
  std::optional<SpecimenSource> looked_at_;
  Region shown_;
  Leeway shown_leeway_;
  Shows shows_ = Shows::target;
  SpecimenLandmarks shown_landmarks_;     // empty while the target is shown
  std::vector<OverlayLine> target_lines_;  // the newest
  QTimer rest_;
  bool carved_ = true, lines_wanted_ = false, mesh_wanted_ = false, working_ = false;
  int preset_ = 0;
};

}  // namespace cusp::ui
