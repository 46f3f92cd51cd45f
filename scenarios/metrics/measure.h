/// All measures of a finished (or interrupted) exercise, each with its uncertainty and its place. Sub-voxel for a banded
/// volume; a filled one is its voxels, with a larger uncertainty.
///
/// Keys: target_removed (%), overcut_leeway_floor, overcut_leeway_side, overcut_beyond_floor, overcut_beyond_side,
/// uncut_remainder (mm3), depth_least, depth_mean, depth_most (mm), wall_angle_mesial, wall_angle_distal, wall_angle_buccal,
/// wall_angle_lingual, convergence_mesiodistal, convergence_buccolingual (deg; walls.h), floor_flatness (mm), floor_tilt
/// (deg; floor.h), isthmus_width (mm; width.h), ridge_mesial, ridge_distal (mm; remaining.h), removed_<tissue key> (mm3, each
/// tissue of the scenario; one of its own: removed_16 and so on), remaining_over_pulp (mm), time (s), force_peak, force_mean
/// (N), pulp_exposure (1 happened, 0 not). Where something is
/// protected also protected_removed (mm3) and protected_damage (how many; protected_parts.h). With the phenomenon "heat" also dry_cutting_time (s), temperature_rise_peak (K, of
/// the model of engine/removal/heat.h) and dry_cutting (how often the pulp's criterion was reached).
///
/// Of several targets (several_targets.h) those keys that a criterion names: depth_mean@NAME and so on.
///
/// Only where the rubric asks for one of their keys: the groups of groups.h, each with its definition and source: volume.h,
/// surface.h, box.h, margin.h, unsupported.h, proximal.h, caries.h.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/grading/grade.h"
#include "scenarios/metrics/process.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Takes a rising share of the work, in [0, 1), on the thread that measures.
using MeasureProgress = std::function<void(double share)>;

/// Not for the haptic thread: tenths of a second, at 512³ voxels seconds, on two threads. Pre: `volume` is of the reference's specimen.
[[nodiscard]] std::vector<Measure> measure(const Reference& reference, const Volume& volume, const Process& process,
                                           const MeasureProgress& progress = {});

/// "removed_enamel", "removed_16".
[[nodiscard]] std::string removed_key(Tissue tissue);

}  // namespace cusp::scenarios
