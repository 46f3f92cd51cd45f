/// What changed between two versions of an exercise, in words for the instructor. Pure functions.
#pragma once

#include <QStringList>

#include "scenarios/format/compare.h"
#include "ui/modules.h"

namespace cusp::ui {

/// "Depth: 1.50 mm, was 2.00 mm". `whole`: the target of the exercise that has it, for the titles of several.
QString change_message(const Change& change, const Region* whole = nullptr);
/// One line for each difference, none twice.
QStringList change_messages(const Scenario& before, const Scenario& after);

}  // namespace cusp::ui
