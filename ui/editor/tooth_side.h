/// On which side of its tooth a target was drawn, and what keeps its mesial walls mesial on another one. Frame: specimen. Thread: GUI.
#pragma once

#include <QUndoStack>

#include "scenarios/format/scenario.h"
#include "ui/modules.h"

namespace cusp::ui {

/// Whether mesial lies towards x on one of the two teeth and away from it on the other. False if a number is 0.
bool is_other_side(int fdi, int other_fdi) noexcept;

/// The exercise on the tooth that its target was drawn for: `now` if the sides of its tooth are known, else the newest that undo can reach
/// with known sides and the same target. Without one `now`.
const Scenario& drawn_on(const Scenario& now, const QUndoStack& stack);

/// Pre: `s` has its new tooth or landmarks. If mesial lies on the other side of it than in `drawn`, target and protected regions of
/// another tooth are mirrored. On the same voxels they stay where they are: the mesial walls are called distal, and the distal ones mesial.
void keep_sides(Scenario& s, const Scenario& drawn);

}  // namespace cusp::ui
