/// The measurement groups of dentistry.md beyond target, depth and form: what the rubric asks for is computed, and nothing else.
#pragma once

#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/grading/grade.h"
#include "scenarios/metrics/cut_faces.h"
#include "scenarios/metrics/margin.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Appends whole groups: volume, surface, box, margin, unsupported enamel, proximal, caries. What cannot be measured is there with measured = false.
void add_groups(const CutFaces& faces, const std::vector<MarginPoint>& margin, const Reference& reference, const Volume& volume,
                std::vector<Measure>& out);

}  // namespace cusp::scenarios
