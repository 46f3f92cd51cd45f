/// The measurements of a preparation's form: walls, floor, width, remaining ridges, as Measures for rubric and report.
#pragma once

#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/grading/grade.h"
#include "scenarios/metrics/cut_faces.h"
#include "scenarios/metrics/margin.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Appends wall_angle_*, convergence_*, floor_flatness, floor_tilt, isthmus_width, ridge_mesial and ridge_distal. What
/// cannot be measured is there with measured = false.
void add_form(const CutFaces& faces, const std::vector<MarginPoint>& margin, const Reference& reference, const Volume& volume,
              std::vector<Measure>& out);

}  // namespace cusp::scenarios
