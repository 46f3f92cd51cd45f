#include "ui/editor/landmark_handles.h"

namespace cusp::ui {
namespace {

constexpr LineStyle kSetStyle{kTargetLine, kTargetCasing, 3.0f, 0.0f, 0.0f};
constexpr LineStyle kProposedStyle{kTargetLine, kTargetCasing, 3.0f, 0.28f, 0.2f};

bool is_line(const Landmark& mark) { return point_count(mark.kind).most > 2; }

TargetHandle handle_at(const Landmark& mark, MarkPoint at) {
  return {.kind = TargetHandle::Kind::landmark, .path = at.mark, .point = at.point, .at_mm = mark.points_mm[at.point], .state = mark.state};
}

}  // namespace

std::vector<TargetHandle> handles_of_landmarks(const SpecimenLandmarks& landmarks, MarkPoint chosen) {
  std::vector<TargetHandle> out;
  for (std::size_t i = 0; i < landmarks.marks.size(); ++i) {
    const Landmark& mark = landmarks.marks[i];
    if (is_line(mark)) continue;
    for (std::size_t k = 0; k < mark.points_mm.size(); ++k) out.push_back(handle_at(mark, {i, k}));
  }
  // The last, so that choosing another landmark leaves the order of the others.
  if (chosen.mark < landmarks.marks.size() && is_line(landmarks.marks[chosen.mark])) out.push_back(handle_at(landmarks.marks[chosen.mark], chosen));
  return out;
}

bool lies_on_surface(MarkKind kind) noexcept { return kind != MarkKind::long_axis && kind != MarkKind::mesial_axis; }

std::vector<OverlayLine> landmark_lines(const SpecimenLandmarks& landmarks) {
  std::vector<OverlayLine> out;
  for (const Landmark& mark : landmarks.marks) {
    if (mark.points_mm.size() < 2) continue;
    OverlayLine& line = out.emplace_back();
    for (const Vec3& p : mark.points_mm) line.points_mm.emplace_back(p);
    line.style = mark.state == MarkState::proposed ? kProposedStyle : kSetStyle;
  }
  return out;
}

}  // namespace cusp::ui
