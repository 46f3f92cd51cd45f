/// Depth of a proximal box. Source: dentistry.md, group "depth"; dental.md 2.2, row set A ("axial height") and row set B ("axial").
///
/// gingival_above_cej (mm): least height of the gingival floor above the cemento-enamel junction beside it; below 0: beneath it.
/// box_height (mm): mean height of the pulpal floor above the gingival floor.
/// A gingival floor that was cut through lies where the tooth ended; a box that was cut through whole has that height.
/// axial_past_junction_least, _mean, _most (mm): how far the axial wall lies in dentine, from the dentino-enamel junction at
/// right angles to the target's wall; below 0: so much enamel is left on it. Of the wall below the mean height of the pulpal floor, if
/// one was cut: above it the box's wall stands in occlusal enamel.
/// Needs: a target with a gingival floor or an axial wall by name, a banded volume, that face cut; for the first the CEJ (of a grown
/// tooth, or marked), for the last enamel and dentine.
#pragma once

#include <optional>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/grading/grade.h"
#include "scenarios/metrics/cut_faces.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// A length with its place. The uncertainty is one of 95 %.
struct MeasuredLength {
  double mm = 0, uncertainty_mm = 0;
  Vec3 at_mm{0.0};
};

/// `through`: where the gingival floor was cut through.
[[nodiscard]] std::optional<MeasuredLength> gingival_above_cej(const CutFaces& faces, const Reference& reference, std::optional<Vec3> through);
[[nodiscard]] std::optional<MeasuredLength> box_height(const CutFaces& faces, const Reference& reference, std::optional<Vec3> through);

struct AxialDepth {
  MeasuredLength least, mean, most;
};
/// Each of 25 lines a voxel about a place counts the tissue up to the junction: a border of voxels is known better so.
[[nodiscard]] std::optional<AxialDepth> axial_past_junction(const CutFaces& faces, const Reference& reference);

void add_box(const CutFaces& faces, const Reference& reference, const Volume& volume, std::vector<Measure>& out);

}  // namespace cusp::scenarios
