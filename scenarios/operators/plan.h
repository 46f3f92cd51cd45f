/// The path that a scripted operator follows: the wanted places of the bur's centre, stroke after stroke.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "engine/volume/specimen.h"
#include "scenarios/format/scenario.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

class TargetShape;

/// Ends a plan early, without strokes, once *cancel is true. May be written by any thread. Null: nobody cancels it.
/// A plan of 15 s (class-2-25-mod) ends in 0.9 s.
using PlanCancel = const std::atomic<bool>*;
inline bool is_cancelled(PlanCancel cancel) noexcept { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }

/// One straight stroke, from wherever the bur is to `to_mm`.
struct Stroke {
  Vec3 to_mm{0.0};
  bool cut = false;  // pressed: the bur turns
};

struct Plan {
  Vec3 start_mm{0.0};           // above the specimen, touching nothing
  std::uint16_t bur = 0;       // index of the scenario's instruments
  Vec3 axis{0.0, 0.0, 1.0};    // of the bur all the way, unit, from the head towards the shank
  std::vector<Stroke> strokes;  // ends above the specimen
};

/// Changes to the perfect path. All zero: follow the target.
struct PlanErrors {
  double deeper_mm = 0;       // floor below the target's (negative: above)
  Vec3 shift_mm{0.0};         // the whole outline
  double wider_mm = 0;        // walls further out (negative: further in)
  double bolder = 1;          // layers this much deeper than they should be
  double clear_mm = 0;        // that the bur keeps from tissue beside a target which is no lone outline
  bool drill_to_pulp = false; // at last, from the floor down into the pulp's nearest place
};

/// Of a lone upright outline: layer by layer from the highest tissue within it, each layer as loops inside it so that the
/// bur's side draws the wall, the last layer at the floor; lifts above the specimen between paths. The largest bur that fits
/// the width and the corner. Of any other target: region_plan.h, with the widest bur of those that leave about the least of it.
/// The bur is held as the exercise's handpiece rests (tool_tilt_deg). A tilted one has no loops: its lone outline is cut as a tree.
/// No strokes if target or instruments are missing. If no bur fits, a lone outline takes the smallest; others get none.
[[nodiscard]] Plan plan_target(const Scenario& scenario, const Specimen& specimen, const PlanErrors& errors = {},
                               PlanCancel cancel = nullptr);

/// Whether a path follows loops about the target's lines: a lone upright outline under an upright bur. Any other follows poses.
[[nodiscard]] bool cut_in_loops(const Scenario& scenario, const TargetShape& target) noexcept;

/// Strokes at the end of a plan: over the pulp's nearest place, down until the bur's tip lies two radii below that voxel's
/// centre, and up again; a tilted bur goes along its axis. None without a pulp.
void add_way_to_pulp(const Scenario& scenario, const Specimen& specimen, Plan& plan);

}  // namespace cusp::scenarios
