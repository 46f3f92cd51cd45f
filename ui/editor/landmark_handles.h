/// The handles of the landmarks of a tooth from a file, and the lines that join their points. Frame: specimen. Millimetres. Pure
/// functions. Thread: any.
#pragma once

#include <vector>

#include "ui/editor/editor_model.h"
#include "ui/editor/target_handles.h"
#include "ui/render/overlay_line.h"

namespace cusp::ui {

/// One for each place and for each end of an axis; then the chosen point of a line, if a line is chosen.
std::vector<TargetHandle> handles_of_landmarks(const SpecimenLandmarks& landmarks, MarkPoint chosen);

/// Whether a landmark's points lie on the tooth's surface: those of axes do not.
bool lies_on_surface(MarkKind kind) noexcept;

/// Axes, fissures, ridges and the cemento-enamel junction: dashed while proposed.
std::vector<OverlayLine> landmark_lines(const SpecimenLandmarks& landmarks);

}  // namespace cusp::ui
