#include "ui/editor/tooth_side.h"

#include "scenarios/landmarks/landmarks.h"
#include "scenarios/teeth/landmarks.h"
#include "scenarios/templates/scope.h"
#include "ui/editor/commands.h"

namespace cusp::ui {
namespace {

bool is_of_same_voxels(SpecimenSource a, const SpecimenSource& b) {
  a.landmarks = b.landmarks;
  return a == b;
}

void change_names_over(Region& region) {
  for (auto& [slot, face] : region.faces) {
    if (face == FaceName::mesial_wall) {
      face = FaceName::distal_wall;
    } else if (face == FaceName::distal_wall) {
      face = FaceName::mesial_wall;
    }
  }
  for (Region& part : region.parts) change_names_over(part);
}

}  // namespace

bool is_other_side(int fdi, int other_fdi) noexcept { return mesial_x(fdi) * mesial_x(other_fdi) < 0; }

const Scenario& drawn_on(const Scenario& now, const QUndoStack& stack) {
  if (sided_fdi(now.specimen) != 0) return now;
  for (int i = stack.index() - 1; i >= 0; --i) {
    const auto* step = dynamic_cast<const ScenarioEdit*>(stack.command(i));
    if (step == nullptr) continue;  // several edits as one step
    if (step->before().target != now.target) return now;
    if (sided_fdi(step->before().specimen) != 0) return step->before();
  }
  return now;
}

void keep_sides(Scenario& s, const Scenario& drawn) {
  if (!is_other_side(sided_fdi(drawn.specimen), sided_fdi(s.specimen))) return;
  if (is_of_same_voxels(drawn.specimen, s.specimen)) return change_names_over(s.target);
  mirror_x(s.target);
  for (Protected& one : s.protected_parts)
    if (one.region) mirror_x(*one.region);
}

}  // namespace cusp::ui
