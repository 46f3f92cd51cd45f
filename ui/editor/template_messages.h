/// What the dialog of templates says in plain words: a parameter's range, default and source, and why no exercise is made.
/// Pure functions. Thread: any.
#pragma once

#include <QString>

#include "scenarios/templates/templates.h"
#include "ui/modules.h"

namespace cusp::ui {

/// Yes or no: without a unit, from 0 to 1. A share of something has a narrower range.
bool is_choice(const TemplateParameter& parameter);
/// "1.2 to 2.6 mm, default 1.8 mm" in one line and the source in the next. A source marked [M] is called not verified.
QString parameter_note(const TemplateParameter& parameter, double usual);
/// "Depth of the pulpal floor: 9 mm is outside 1.2 to 2.6 mm." `typed`: the text in the field, without its unit.
QString outside_message(const TemplateParameter& parameter, const QString& typed);
/// Why fit_template() made no exercise of `chosen`.
QString fit_message(const ExerciseTemplate& chosen, const FitFailure& failure);

}  // namespace cusp::ui
