// Handles of the target that go to landmarks, in the editor's view.

#include <QLabel>
#include <limits>

#include "ui/editor/handle_knob.h"
#include "ui/editor/landmark_names.h"
#include "ui/editor/landmark_snap.h"
#include "ui/editor/target_view.h"
#include "ui/view/tooth_view.h"

namespace cusp::ui {
namespace {

constexpr double kReachPx = 10.0;     // of a landmark on the screen
constexpr double kMostReachMm = 0.4;  // half a fissure's width: from afar a handle still stands beside one

}  // namespace

std::span<const Landmark> TargetView::present_marks() const {
  if (!grown_) return {};
  return grown_->landmarks.empty() ? std::span<const Landmark>(model_.landmarks().marks) : std::span<const Landmark>(grown_->landmarks);
}

Vec3 TargetView::snapped(Vec3 to_mm) const {
  const double px_per_mm = view_->camera().px_per_mm(std::min(width(), height()));
  const auto place = nearest_place(present_marks(), to_mm, std::min(kReachPx / std::max(px_per_mm, 1.0), kMostReachMm));
  return place ? Vec3(place->at_mm.x, place->at_mm.y, to_mm.z) : to_mm;
}

void TargetView::snap(const TargetHandle& handle) {
  const auto place = nearest_place(present_marks(), handle.at_mm, std::numeric_limits<double>::max());
  if (!place) return;
  const Vec3 to(place->at_mm.x, place->at_mm.y, handle.at_mm.z);
  if (handle.of_outline()) {
    apply(handle, model_.outline(), to);
  } else {
    place_part(handle, to);
  }
}

QString TargetView::place_name(const TargetHandle& handle) const {
  if (!handle.is_place() || handle.kind == TargetHandle::Kind::landmark) return {};
  const auto marks = present_marks();
  const auto place = nearest_place(marks, handle.at_mm, kHandleStepMm);  // the handle stands on a step beside it
  return place ? landmark_name(marks[place->mark]) : QString();
}

void TargetView::name_place(HandleKnob& knob, const TargetHandle& handle) {
  const QString name = place_name(handle);
  if (name.isEmpty()) return;
  //: %1: a place in millimetres, %2: the landmark that lies there ("Pit, central")
  knob.set_handle(handle, knob.accessibleName(), tr("%1; %2").arg(knob.accessibleDescription(), name));
  if (!knob.hasFocus()) return;
  mark_tag_->setText(name);
  show_tag(*mark_tag_);
  place_tag(mark_tag_, knob.geometry().center());
}

/// The last sentence stands where there are landmarks to go to.
void TargetView::write_hint() {
  QString text = tr("Drag a handle, or move it with the arrow keys; Shift moves by 0.01 mm. Drag elsewhere to turn.");
  if (!shows_landmarks() && !present_marks().empty())
    text += u' ' + tr("A place snaps to a landmark, with Shift it does not; L takes it to the nearest.");
  if (hint_->text() != text) hint_->setText(text);
}

}  // namespace cusp::ui
