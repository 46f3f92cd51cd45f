// EditorModel's edits of the landmarks of a tooth from a file.
#include <algorithm>

#include "ui/editor/editor_model.h"
#include "ui/editor/tooth_side.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

bool lies_outside(const std::vector<Finding>& findings, std::size_t mark) {
  const std::string path = "/specimen/landmarks/marks/" + std::to_string(mark);
  return std::ranges::any_of(findings, [&](const Finding& f) { return f.code == "landmark_outside" && f.path == path; });
}

/// A cemento-enamel junction stays closed.
void move_point(Landmark& mark, std::size_t point, Vec3 mm) {
  auto& points = mark.points_mm;
  const bool closes = mark.kind == MarkKind::cej && point == 0;
  points[point] = mm;
  if (closes) points.front() = points.back() = mm;
  mark.state = MarkState::set;
}

}  // namespace

std::size_t movable_points(const Landmark& mark) noexcept {
  const std::size_t points = mark.points_mm.size();
  return mark.kind == MarkKind::cej && points > 1 ? points - 1 : points;
}

MarkPoint EditorModel::landmark() const {
  const auto& marks = landmarks().marks;
  if (marks.empty()) return {};
  MarkPoint out = landmark_;
  out.mark = std::min(out.mark, marks.size() - 1);
  out.point = std::min(out.point, movable_points(marks[out.mark]) - 1);
  return out;
}

void EditorModel::choose_landmark(MarkPoint at) {
  if (at == landmark()) return;
  end_gesture();
  landmark_ = at;
  Q_EMIT landmark_chosen();
}

bool EditorModel::edit_landmarks(const QString& text, const std::function<void(SpecimenLandmarks&)>& change) {
  if (!takes_landmarks()) return false;
  end_gesture();
  const bool taken = edit(text, u"landmarks"_qs, [&](Scenario& s) {
    change(s.specimen.landmarks);
    keep_sides(s, drawn_on(scenario_, stack_));
  });
  end_gesture();
  return taken;
}

bool EditorModel::take_proposed(const SpecimenLandmarks& proposed) {
  return edit_landmarks(tr("Propose landmarks"), [&](SpecimenLandmarks& held) {
    SpecimenLandmarks fresh = proposed;
    if (held.fdi == fresh.fdi) {
      for (Landmark& mark : held.marks) {
        if (mark.state != MarkState::set) continue;
        std::erase_if(fresh.marks, [&](const Landmark& other) { return other.kind == mark.kind && other.name == mark.name; });
        fresh.marks.push_back(std::move(mark));
      }
    }
    std::ranges::stable_sort(fresh.marks, {}, &Landmark::kind);
    held = std::move(fresh);
  });
}

bool EditorModel::move_landmark(MarkPoint at, Vec3 mm) {
  const auto& marks = landmarks().marks;
  if (!takes_landmarks() || at.mark >= marks.size() || at.point >= movable_points(marks[at.mark])) return false;
  const auto change = [&](Scenario& s) { move_point(s.specimen.landmarks.marks[at.mark], at.point, mm); };
  if (marks[at.mark].points_mm[at.point] == mm) return true;
  if (facts_) {
    Scenario moved = scenario_;
    change(moved);
    if (lies_outside(validate(moved, &*facts_), at.mark)) return false;
  }
  return edit(tr("Landmark"), u"landmark/%1/%2"_qs.arg(at.mark).arg(at.point), change);
}

SpecimenLandmarks EditorModel::landmarks_on(const SpecimenFacts& other) const {
  const std::vector<Finding> found = validate(scenario_, &other);
  SpecimenLandmarks out{landmarks().fdi, {}};
  for (std::size_t i = 0; i < landmarks().marks.size(); ++i)
    if (!lies_outside(found, i)) out.marks.push_back(landmarks().marks[i]);
  return out;
}

bool EditorModel::accept_landmark(std::size_t mark) {
  if (mark >= landmarks().marks.size()) return false;
  return edit_landmarks(tr("Accept a landmark"), [mark](SpecimenLandmarks& held) { held.marks[mark].state = MarkState::set; });
}

bool EditorModel::accept_landmarks() {
  return edit_landmarks(tr("Accept the landmarks"), [](SpecimenLandmarks& held) {
    for (Landmark& mark : held.marks) mark.state = MarkState::set;
  });
}

bool EditorModel::remove_landmark(std::size_t mark) {
  if (mark >= landmarks().marks.size()) return false;
  return edit_landmarks(tr("Remove a landmark"), [mark](SpecimenLandmarks& held) {
    held.marks.erase(held.marks.begin() + static_cast<std::ptrdiff_t>(mark));
  });
}

}  // namespace cusp::ui
