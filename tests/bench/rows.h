/// Results of a measurement: one flat row for each method, shape, motion, bur and voxel size, as JSON and CSV.
#pragma once

#include <cmath>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace cusp::bench {

inline constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();
inline constexpr const char* kFullSweep = "full";  // Row::sweep of every row of --full

/// A number that is NaN, a count below zero and an empty string are absent: left out of JSON, empty in CSV.
struct Row {
  std::string method;              // occupancy, occupancy-pivot, ray, penalty, gradient, surface
  std::string case_name;           // stability: "case", see stability_cases.h
  std::string sweep;               // full: a row of --full, which has tables of its own
  std::string guard;               // stability: on, off
  std::string device;              // stability: m0.1-b2 is 0.1 kg and 2 N s/m
  std::string grip;                // stability: none, soft, firm; scripted: no hand in the loop
  double mass_kg = kAbsent;        // stability: moving mass of the device
  double damping_n_s_m = kAbsent;  // stability: damping of the device
  double friction_n = kAbsent;     // stability: Coulomb friction of the device
  double delay_ms = kAbsent;       // stability: from sample to force
  std::string shape;               // face, sphere, pit, cylinder, edge, corner, groove, step, wall, cut, channel, cavity; heads: slot
  std::string variant;             // of a cut: single, crossing; of a channel: straight, oblique, slot
  std::string motion;              // press, slide; cavity: also cutting
  std::string axis;                // heads: fixed, turning, jitter
  std::string task;                // rate: displacement, exploration, perforation, mill
  std::string measure;             // removal: speed, mixed, depth, shape, volume, order, slide, ridge, hole, tick
  std::string bur;                // removal: its name, with the diameter; heads: shape and catalogue number
  std::string tissue;              // removal
  std::string direction;           // removal: +x-y, or the path of the bur
  double tick_ms = kAbsent;        // removal: length of a tick
  double alpha = kAbsent;          // removal: wear coefficient of eq. (4)
  double target_mm_s = kAbsent;    // removal: expected speed, and the speed of the remaining surface
  double measured_mm_s = kAbsent;
  double error_percent = kAbsent;  // removal: of the measured value against its target
  double deepest_mm_s = kAbsent;   // removal: speed by the deepest point, and by the volume
  double volume_mm_s = kAbsent;
  double time_s = kAbsent;         // removal: time in the paper's perforation
  double depth_mm = kAbsent;       // depth of the tip at time_s
  double removed_mm3 = kAbsent;    // removal
  double exact_mm3 = kAbsent;      // removal: volume of the exact bur on the same path
  double deviation_um_mean = kAbsent;  // removal: remaining surface against the swept bur's
  double deviation_um_max = kAbsent;
  std::string place;               // removal: place of deviation_um_max, mm: x along the path, z out of the face
  double excess_um_p99 = kAbsent;  // removal: recession of the surface in a tick beyond the wear
  double excess_um_max = kAbsent;
  double ridge_um = kAbsent;       // removal: height of a ridge below the exact one
  double speed_mm_s = kAbsent;
  double bur_radius_mm = kAbsent;
  double voxel_mm = kAbsent;
  std::int64_t seed = -1;
  bool unresolved = false;          // a feature thinner than 2.5 voxels, or a radius below 3: outside every goal
  std::int64_t samples = -1;        // ticks (slide) or presses in the means
  std::int64_t skipped = -1;        // not averaged: exact force below 50 um of spring
  double angle_deg_mean = kAbsent;  // between the method's force and the exact one
  double angle_deg_p95 = kAbsent;
  double angle_deg_p99 = kAbsent;
  double angle_deg_max = kAbsent;
  double depth_um_mean = kAbsent;  // |exact signed clearance| of the bur at the method's proxy
  double depth_um_p95 = kAbsent;
  double depth_um_max = kAbsent;
  double pose_um_mean = kAbsent;  // distance between the method's proxy and the exact one
  double pose_um_p95 = kAbsent;
  double pose_um_max = kAbsent;
  double apart_percent = kAbsent;             // heads: samples more than a voxel, at least 50 um, from the exact proxy
  double force_error_percent_rms = kAbsent;   // |force - exact| over the exact force's rms
  double force_step_excess_mn_p99 = kAbsent;  // change from tick to tick over the exact proxy's, p99
  double force_step_excess_mn_max = kAbsent;
  double minutes = kAbsent;                   // cavity: milled for so long
  double tremor_mm = kAbsent;                 // cavity: rms of the hand's tremor
  double encoder_mm = kAbsent;                // cavity: step of the device's reading while it milled; 0: 0.1 um
  double other_minimum_percent = kAbsent;     // cavity: ticks over 50 um from the exact proxy, in no other figure
  double force_missing_percent = kAbsent;     // cavity: ticks without force where the exact proxy has one
  double force_spurious_percent = kAbsent;    // cavity: ticks with force where the exact proxy has none
  double follow_ticks = kAbsent;              // where the exact minimum vanishes: ticks until the method follows, mean
  std::int64_t infeasible_ticks = -1;
  std::int64_t max_candidates = -1;
  std::int64_t runs = -1;             // stability: approaches, presses or motions; samples counts their ticks
  double k_max_n_per_mm = kAbsent;    // stability: this and the following as in engine/lab/measures.h
  double k_exact_n_per_mm = kAbsent;  // k_max of the exact proxy on the same shape, with the same hand and device
  std::int64_t k_sets = -1;           // sets of seeds whose medians k_max and k_exact are; above 1:
  double k_first_n_per_mm = kAbsent;  // k_max of the first set, and from least to most
  double k_least_n_per_mm = kAbsent;
  double k_most_n_per_mm = kAbsent;
  double k_exact_first_n_per_mm = kAbsent;  // the exact proxy's
  double k_exact_least_n_per_mm = kAbsent;
  double k_exact_most_n_per_mm = kAbsent;
  double energy_mj = kAbsent;
  double energy_exact_mj = kAbsent;
  double late_mj = kAbsent;   // force times travel in milliseconds without a controller output
  double energy_left_mj = kAbsent;        // energy_mj without that of each episode's late milliseconds
  double energy_exact_left_mj = kAbsent;  // the same of the exact proxy
  double cycle_um = kAbsent;  // at rest; with k_max at the first failing stiffness
  double cycle_hz = kAbsent;
  double cycle_exact_um = kAbsent;  // of the exact proxy in the same loop
  double force_max_n = kAbsent;     // largest rendered force
  double force_step_mn = kAbsent;   // the largest
  double force_step_p99_mn = kAbsent;
  double guard_step_mn = kAbsent;
  double penetration_um = kAbsent;   // largest exact overlap at the method's proxy
  std::int64_t passed_through = -1;  // runs whose pivot entered the tissue or passed behind it
  std::int64_t stuck = -1;           // times
  double stuck_ms = kAbsent;         // the longest; removal: ticks in a row whose search did not end
  double vibration_mn = kAbsent;     // tasks: peak to peak of force less exact force above 20 Hz
  double zero_ms = kAbsent;     // faults: from the first faulty input until the force is zero for good; absent: never;
                                // fragment: from the cut
  double back_ms = kAbsent;     // faults: from re-arming until within 5 % of the final force
  double back_share = kAbsent;  // faults: of the exact force, half a second after re-arming
  std::string failures;           // stability: kinds of verdict.h, separated by spaces
  double updates_per_s = kAbsent;
  double tick_us_mean = kAbsent;  // rate: of mill
  double tick_us_p50 = kAbsent;
  double tick_us_p99 = kAbsent;
  double tick_us_p999 = kAbsent;
  double tick_us_p9999 = kAbsent;
  double tick_us_max = kAbsent;
  double work_us_max = kAbsent;       // rate: of mill with a catalogue bur: most counted work of a tick, by the line that fits the row's ticks
  double deferred_percent = kAbsent;  // rate: the same: ticks whose search went on in the next one
  double ratio_to_occupancy = kAbsent;  // rate: updates_per_s over the occupancy proxy's in the same run
  double cached_share = kAbsent;        // rate: ticks answered from the cached clearance, 0 to 1
  std::int64_t volume_voxels = -1;      // scale
  double memory_mb = kAbsent;           // scale; cavity: of the engine's state, without the specimen
  double cost_to_smallest = kAbsent;    // scale: a tick's cost over the one in the smallest volume, same run
};

/// Names of the method, case, device and shape.
template <class R, class Visit>
void visit_identity(R& row, Visit& visit) {
  visit("method", row.method);
  visit("case", row.case_name);
  visit("sweep", row.sweep);
  visit("guard", row.guard);
  visit("device", row.device);
  visit("grip", row.grip);
  visit("mass_kg", row.mass_kg);
  visit("damping_n_s_m", row.damping_n_s_m);
  visit("friction_n", row.friction_n);
  visit("delay_ms", row.delay_ms);
  visit("shape", row.shape);
  visit("variant", row.variant);
  visit("motion", row.motion);
  visit("axis", row.axis);
  visit("task", row.task);
}

/// Fields of `removal`.
template <class R, class Visit>
void visit_removal(R& row, Visit& visit) {
  visit("measure", row.measure);
  visit("bur", row.bur);
  visit("tissue", row.tissue);
  visit("direction", row.direction);
  visit("tick_ms", row.tick_ms);
  visit("alpha", row.alpha);
  visit("target_mm_s", row.target_mm_s);
  visit("measured_mm_s", row.measured_mm_s);
  visit("error_percent", row.error_percent);
  visit("deepest_mm_s", row.deepest_mm_s);
  visit("volume_mm_s", row.volume_mm_s);
  visit("time_s", row.time_s);
  visit("depth_mm", row.depth_mm);
  visit("removed_mm3", row.removed_mm3);
  visit("exact_mm3", row.exact_mm3);
  visit("deviation_um_mean", row.deviation_um_mean);
  visit("deviation_um_max", row.deviation_um_max);
  visit("place", row.place);
  visit("excess_um_p99", row.excess_um_p99);
  visit("excess_um_max", row.excess_um_max);
  visit("ridge_um", row.ridge_um);
}

/// Sizes and the fields of `accuracy`.
template <class R, class Visit>
void visit_contact(R& row, Visit& visit) {
  visit("speed_mm_s", row.speed_mm_s);
  visit("bur_radius_mm", row.bur_radius_mm);
  visit("voxel_mm", row.voxel_mm);
  visit("seed", row.seed);
  visit("unresolved", row.unresolved);
  visit("samples", row.samples);
  visit("skipped", row.skipped);
  visit("angle_deg_mean", row.angle_deg_mean);
  visit("angle_deg_p95", row.angle_deg_p95);
  visit("angle_deg_p99", row.angle_deg_p99);
  visit("angle_deg_max", row.angle_deg_max);
  visit("depth_um_mean", row.depth_um_mean);
  visit("depth_um_p95", row.depth_um_p95);
  visit("depth_um_max", row.depth_um_max);
  visit("pose_um_mean", row.pose_um_mean);
  visit("pose_um_p95", row.pose_um_p95);
  visit("pose_um_max", row.pose_um_max);
  visit("apart_percent", row.apart_percent);
  visit("force_error_percent_rms", row.force_error_percent_rms);
  visit("force_step_excess_mn_p99", row.force_step_excess_mn_p99);
  visit("force_step_excess_mn_max", row.force_step_excess_mn_max);
  visit("minutes", row.minutes);
  visit("tremor_mm", row.tremor_mm);
  visit("encoder_mm", row.encoder_mm);
  visit("other_minimum_percent", row.other_minimum_percent);
  visit("force_missing_percent", row.force_missing_percent);
  visit("force_spurious_percent", row.force_spurious_percent);
  visit("follow_ticks", row.follow_ticks);
  visit("infeasible_ticks", row.infeasible_ticks);
  visit("max_candidates", row.max_candidates);
}

/// Fields of `stability`.
template <class R, class Visit>
void visit_stability(R& row, Visit& visit) {
  visit("runs", row.runs);
  visit("k_max_n_per_mm", row.k_max_n_per_mm);
  visit("k_exact_n_per_mm", row.k_exact_n_per_mm);
  visit("k_sets", row.k_sets);
  visit("k_first_n_per_mm", row.k_first_n_per_mm);
  visit("k_least_n_per_mm", row.k_least_n_per_mm);
  visit("k_most_n_per_mm", row.k_most_n_per_mm);
  visit("k_exact_first_n_per_mm", row.k_exact_first_n_per_mm);
  visit("k_exact_least_n_per_mm", row.k_exact_least_n_per_mm);
  visit("k_exact_most_n_per_mm", row.k_exact_most_n_per_mm);
  visit("energy_mj", row.energy_mj);
  visit("energy_exact_mj", row.energy_exact_mj);
  visit("late_mj", row.late_mj);
  visit("energy_left_mj", row.energy_left_mj);
  visit("energy_exact_left_mj", row.energy_exact_left_mj);
  visit("cycle_um", row.cycle_um);
  visit("cycle_hz", row.cycle_hz);
  visit("cycle_exact_um", row.cycle_exact_um);
  visit("force_max_n", row.force_max_n);
  visit("force_step_mn", row.force_step_mn);
  visit("force_step_p99_mn", row.force_step_p99_mn);
  visit("guard_step_mn", row.guard_step_mn);
  visit("penetration_um", row.penetration_um);
  visit("passed_through", row.passed_through);
  visit("stuck", row.stuck);
  visit("stuck_ms", row.stuck_ms);
  visit("vibration_mn", row.vibration_mn);
  visit("zero_ms", row.zero_ms);
  visit("back_ms", row.back_ms);
  visit("back_share", row.back_share);
  visit("failures", row.failures);
}

/// Rates, tick times and the fields of `rate` and `scale`.
template <class R, class Visit>
void visit_cost(R& row, Visit& visit) {
  visit("updates_per_s", row.updates_per_s);
  visit("tick_us_mean", row.tick_us_mean);
  visit("tick_us_p50", row.tick_us_p50);
  visit("tick_us_p99", row.tick_us_p99);
  visit("tick_us_p999", row.tick_us_p999);
  visit("tick_us_p9999", row.tick_us_p9999);
  visit("tick_us_max", row.tick_us_max);
  visit("work_us_max", row.work_us_max);
  visit("deferred_percent", row.deferred_percent);
  visit("ratio_to_occupancy", row.ratio_to_occupancy);
  visit("cached_share", row.cached_share);
  visit("volume_voxels", row.volume_voxels);
  visit("memory_mb", row.memory_mb);
  visit("cost_to_smallest", row.cost_to_smallest);
}

/// Calls visit(name, member) for each field, in the order in which files have them.
template <class R, class Visit>
void for_each_field(R& row, Visit&& visit) {
  visit_identity(row, visit);
  visit_removal(row, visit);
  visit_contact(row, visit);
  visit_stability(row, visit);
  visit_cost(row, visit);
}

/// What measured the rows of a report.
struct Source {
  std::string commit;      // commit_of_build()
  int engine_version = 0;  // kEngineVersion; 0 if unknown
  std::string machine;     // the CPU's name
  friend bool operator==(const Source&, const Source&) = default;
};
/// Of this program on this machine.
Source this_source();
/// "# commit …, engine …, machine …", the first line of a table; nullopt for any other line.
std::string source_line(const Source& source);
std::optional<Source> source_from_line(const std::string& line);

struct Report {
  Source source;
  std::vector<Row> rows;
};

enum class RowsError : std::uint8_t { cannot_open, not_json, wrong_type };
using RowsFailure = Failure<RowsError>;

/// A report of this tree and machine, without rows.
Report empty_report();

std::string to_json(const Report& report);
Result<Report, RowsFailure> from_json(const std::string& text);
/// To a file, or to stdout for "-".
Result<void, RowsFailure> print_json(const Report& report, const std::string& path);
Result<Report, RowsFailure> read_json(const std::string& path);

/// source_line(), then the names of all fields that any row holds, then a line for each row.
std::string to_csv(const Report& report);
Result<Report, RowsFailure> from_csv(const std::string& text);

/// The main figures in columns; absent ones as a dash.
void print_table(const std::vector<Row>& rows, std::ostream& out);

/// Writes the rows as JSON to the file `json` ("-": stdout), or prints them with print() if it is empty. Returns the exit
/// code and reports a failure on stderr.
int write_report(const Report& report, const std::string& json, void (*print)(const std::vector<Row>&));

}  // namespace cusp::bench
