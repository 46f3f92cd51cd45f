/// What a new criterion begins with, and the bands of one outline for another. No widget. Any thread.
#pragma once

#include <string>

#include "scenarios/format/scenario.h"
#include "ui/modules.h"

namespace cusp::ui {

/// First bands of a criterion: scenarios/grading/default_bands.h for the form of a preparation on tooth `fdi` (0: none), else those
/// of the built-in exercises. An outline moves them to its width and depth, and over-cut to its floor and wall. If none of them has
/// the metric, bands that cost no points.
Bands first_bands(const std::string& metric, const Region& target, int fdi = 0);

/// The bands of `pattern` for another outline. Depths move with its depth; over-cut is volume, and grows with the floor or wall it lies
/// on; others stay.
Bands fitted_bands(const Bands& bands, const std::string& metric, const Outline& target, const Outline& pattern);

/// What isthmus_width reads where an upright outline is cut exactly: its buccolingual width, mm.
double isthmus_mm(const Outline& outline);

}  // namespace cusp::ui
