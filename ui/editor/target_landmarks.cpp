// The landmarks of a tooth from a file, in the editor's view.

#include <QLabel>
#include <QPointF>

#include "ui/editor/handle_knob.h"
#include "ui/editor/landmark_handles.h"
#include "ui/editor/landmark_names.h"
#include "ui/editor/target_view.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

QString landmark_mm(double value) { return format({value, {}, QStringLiteral("mm"), 2}); }

MarkPoint point_of(const TargetHandle& handle) { return {handle.path, handle.point}; }

}  // namespace

void TargetView::set_shown(Shows what) {
  shows_ = what;
  follow_landmarks();
  place_all();
}

bool TargetView::shows_landmarks() const { return shows_ == Shows::landmarks && !model_.landmarks().marks.empty(); }

/// The cavity closes while landmarks are shown, and their lines take the place of the target's.
void TargetView::follow_landmarks() {
  const SpecimenLandmarks now = shows_landmarks() ? model_.landmarks() : SpecimenLandmarks{};
  if (now == shown_landmarks_) return;
  const bool changes_mesh = now.marks.empty() != shown_landmarks_.marks.empty();
  shown_landmarks_ = now;
  target_legend_->setVisible(now.marks.empty());
  mark_legend_->setVisible(!now.marks.empty());
  carved_button_->setEnabled(now.marks.empty());
  show_lines();
  if (!changes_mesh) return;
  mesh_wanted_ = true;
  run_next();
}

void TargetView::show_lines() { view_->set_lines(shows_landmarks() ? landmark_lines(model_.landmarks()) : target_lines_); }

bool TargetView::is_chosen(const TargetHandle& handle) const { return point_of(handle) == model_.landmark(); }

bool TargetView::is_seen(const TargetHandle& handle) const {
  if (handle.kind != TargetHandle::Kind::landmark || is_chosen(handle)) return true;
  if (!lies_on_surface(model_.landmarks().marks[handle.path].kind)) return true;
  return view_->store().shows(handle.at_mm, view_->camera().eye_mm());
}

void TargetView::drag_landmark(const TargetHandle& handle, const Way& way) {
  const auto& marks = model_.landmarks().marks;
  if (handle.path >= marks.size()) return;
  Vec3 to = moved_in_view(handle.at_mm, way);
  const auto middle = view_->project(handle.at_mm);
  if (middle && lies_on_surface(marks[handle.path].kind)) {
    if (const auto under = view_->pick(*middle + way.to - way.from)) to = under->at_mm;
  }
  model_.move_landmark(point_of(handle), on_handle_step(to));
}

void TargetView::step_landmark(const TargetHandle& handle, glm::ivec2 keys, double step_mm) {
  model_.move_landmark(point_of(handle), on_handle_step(handle.at_mm + step_mm * way_of(keys)));
}

void TargetView::name_landmark_handle(HandleKnob& knob, const TargetHandle& handle) {
  const Landmark& mark = model_.landmarks().marks[handle.path];
  const QString end = landmark_point_name(mark, handle.point), whole = landmark_name(mark);
  //: %1: a landmark ("Long axis"), %2: one of its points ("Occlusal end")
  const QString name = end.isEmpty() ? whole : tr("%1: %2").arg(whole, end);
  const Vec3 at = handle.at_mm;
  const QString place = tr("%1 across, %2 along, %3 high").arg(landmark_mm(at.y), landmark_mm(at.x), landmark_mm(at.z));
  //: %1: a place, or the name of a landmark, %2: "proposed" or "set"
  const auto with_state = [&](const QString& text) { return tr("%1, %2").arg(text, mark_state_name(mark.state)); };
  knob.set_handle(handle, name, with_state(place));
  QLabel* tag = tag_of(handle);
  if (tag == nullptr) return;
  tag->setText(with_state(name));
  show_tag(*tag);
}

}  // namespace cusp::ui
