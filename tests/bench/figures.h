/// The pictures that are drawn from rows: the same rows give the same bytes. What is missing is said, nothing is drawn
/// without it.
#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "tests/bench/rows.h"
#include "tests/bench/tasks.h"

namespace cusp::bench {

enum class ChartError : std::uint8_t { missing_rows, cannot_read, cannot_write };
using ChartFailure = Failure<ChartError>;
using Picture = Result<std::string, ChartFailure>;

/// Mean angle error over face and sphere against updates a second, sliding at 50 mm/s: a mark for each method and voxel
/// size, the front of the best, and the peers' figures, which were measured elsewhere.
Picture speed_against_accuracy(const Report& accuracy, const Report& rate, double burr_radius_mm);

/// The paper's figure 13: updates a second by task, sampled every 25 ms.
Picture rates_by_task(const PaceReport& pace);
/// The paper's figure 14: displacement and force on each axis through the three tasks.
Picture displacement_and_force(const MotionReport& motion);

/// Angle and depth error of the surface proxy against the voxel size on sphere and cylinder, with the order that fits.
Picture error_against_voxel(const Report& accuracy);

/// A tick's cost against the burr's radius, against the volume's size, and memory against the volume's size.
Picture cost_against_size(const Report& rate, const Report& scale);

/// Speed and accuracy of every method at the usual voxel size, as a Markdown table with where it is from.
Picture method_table(const Report& accuracy, const Report& rate);

/// Methods by cases: the largest stable stiffness over the exact proxy's, and what failed (verdict.h).
Picture stability_map(const Report& stability);
/// k_max of the surface proxy on a face against the device's damping, beside the bounds that promise passivity.
Picture stiffness_against_damping(const Report& stability);
/// k_max of the surface proxy over the exact one's in every cell of `stability --full`, place by place. Pre: rows of --full.
Picture stiffness_by_cell(const Report& stability_full);
/// The worst of every method with the guard on, as a Markdown table with where it is from.
Picture stability_table(const Report& stability);

/// The paper's figure 15: depth over time through three materials, with the slopes that were wanted.
Picture depth_over_time(const Report& removal);
/// Error of the drilling speed against voxel size, tick and direction.
Picture speed_error(const Report& removal);
/// What the cut keeps of what was promised, as a Markdown table with where it is from.
Picture removal_table(const Report& removal);
/// The same with lines for what `removal --full` found. full: its rows, or none.
Picture removal_table_with(const Report& removal, const Report& full);

/// Order p of error = c h^p, by least squares on the logarithms. Pre: at least two points, all positive.
double fitted_order(const std::vector<std::pair<double, double>>& h_and_error);

}  // namespace cusp::bench
