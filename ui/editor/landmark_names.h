/// Landmarks of a tooth in words for the instructor, and why none were proposed. Pure functions. Thread: any.
#pragma once

#include <QString>

#include "scenarios/format/landmark.h"
#include "scenarios/landmarks/propose.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"

namespace cusp::ui {

/// "Cusp tip, MB", "Pit, central", "Long axis".
QString landmark_name(const Landmark& mark);
/// "Occlusal end" of an axis, "Point 3" of a line; empty of a single place.
QString landmark_point_name(const Landmark& mark, std::size_t point);
QString mark_state_name(MarkState state);
/// Name of the icon that stands for it: a ring or a disc, as on the tooth.
QString mark_state_icon(MarkState state);

Message describe(ProposeError error);
/// What a proposal lacks as a whole: everything, or all that goes by the crown's likeness to the average tooth of `fdi`. Empty if
/// neither.
Message describe_lack(const SpecimenLandmarks& proposed);

}  // namespace cusp::ui
