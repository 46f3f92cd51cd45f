/// What the expressions of a template may name of a tooth. Frame: that of the table, mesial along +x, buccal along +y; a
/// tooth of quadrants 2 and 4 is mirrored into it. Millimetres.
///
/// molar (1 or 0), upper (1 or 0), beside.distal (0 of a third molar, behind which no tooth stands, else 1), bl, md (extents
/// of the crown), central.x .y .z (the central pit, or the middle of the central groove), fossa.z (the lowest pit), contact.mesial.x .y .z, contact.distal.x .y .z, cej.mesial.z, cej.distal.z,
/// pit.mesial.x .y, pit.distal.x .y. A tooth from a file has those that its landmarks say.
#pragma once

#include "engine/base/result.h"
#include "scenarios/teeth/landmarks.h"
#include "scenarios/templates/expression.h"
#include "scenarios/templates/templates.h"

namespace cusp::scenarios {

/// A tooth's landmarks with mesial along +x.
[[nodiscard]] ToothLandmarks mesial_forward(ToothLandmarks landmarks, int fdi);

/// Without the names whose landmarks the tooth has not. Pre: mesial_forward().
[[nodiscard]] Scope scope_of(const ToothLandmarks& landmarks, int fdi);

/// Whether an expression's name is one of a tooth: where the scope lacks it, a landmark is missing.
[[nodiscard]] bool is_of_tooth(std::string_view name) noexcept;

/// A target of the table's frame on a tooth of quadrants 2 and 4: x and the names of its sides change over.
void mirror_x(Region& region);

}  // namespace cusp::scenarios
