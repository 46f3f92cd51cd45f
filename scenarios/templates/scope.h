/// What the expressions of a template may name of a tooth. Frame: that of the table, mesial along +x, buccal along +y; a
/// tooth of quadrants 2 and 4 is mirrored into it. Millimetres.
///
/// molar (1 or 0), upper (1 or 0), bl, md (extents of the crown), central.x .y .z (the central pit, or the middle of the
/// central groove), fossa.z (the lowest pit), contact.mesial.x .y .z, contact.distal.x .y .z, cej.mesial.z, cej.distal.z,
/// pit.mesial.x .y, pit.distal.x .y.
#pragma once

#include "engine/base/result.h"
#include "scenarios/teeth/landmarks.h"
#include "scenarios/templates/expression.h"
#include "scenarios/templates/templates.h"

namespace cusp::scenarios {

/// A tooth's landmarks with mesial along +x.
[[nodiscard]] ToothLandmarks mesial_forward(ToothLandmarks landmarks, int fdi);

/// Fails (missing_landmark) where the tooth has no pit or no CEJ. Pre: mesial_forward().
[[nodiscard]] Result<Scope, FitFailure> scope_of(const ToothLandmarks& landmarks, int fdi);

/// A target of the table's frame on a tooth of quadrants 2 and 4: x and the names of its sides change over.
void mirror_x(Region& region);

}  // namespace cusp::scenarios
