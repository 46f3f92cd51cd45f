/// The verb `heads`: burs that are no balls, with a fixed, a turning and a jittering axis, against the exact proxy.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "tests/bench/measure.h"
#include "tests/bench/options.h"
#include "tests/bench/rows.h"

namespace cusp::bench {

/// Catalogue numbers: straight fissure, pear, long pear, inverted cone, round-end taper, flame, football.
inline constexpr std::array<std::string_view, 7> kHeadBurs = {"57",      "330",     "245",    "35",
                                                              "856-016", "862-012", "368-023"};

/// A bur of the catalogue on a shape of kHeadShapes with an axis of kAxisMotions.
struct HeadCase {
  std::string_view bur, shape, axis;
};

/// Slides, or presses if `motion` is "press". fixed and jitter take three tilts. Half of the budget goes to the method,
/// the other half to the exact proxy, which follows as many ticks as it has time for. tick_us_*: thread CPU time.
Row measure_head(const HeadCase& of, std::string_view motion, const Measure& what);

/// How a head's cavity is milled, and how much of the exploring is compared.
struct HeadCavity {
  double minutes = 0.5, tremor_mm = 0.05;
  int ticks = 8000, every = 200;
};

/// The shape "cavity": the head mills it at 5 mm/s (cavity.h) and slides in it. Every `every`-th tick is compared with the
/// exact proxy downhill from the method's own pose; one whose search ends on no admissible pose is left out (`skipped`).
Row measure_head_cavity(const HeadCase& of, const Measure& what, const HeadCavity& cavity);

/// Default set: every bur of kHeadBurs, shape and axis at 10/128 mm; presses but in slots, slides at 5 and 50 mm/s. A cavity takes
/// up to a minute of search a row and is measured when asked for by name.
std::vector<Row> heads_rows(const Options& options);

/// Prints or writes heads_rows and returns an exit code of program.h.
int run_heads(const Options& options);

}  // namespace cusp::bench
