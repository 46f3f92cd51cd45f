/// What changed between two versions of an exercise, in words for the instructor. Pure functions.
#pragma once

#include <QStringList>

#include "scenarios/format/compare.h"
#include "ui/modules.h"
#include "ui/text/names.h"

namespace cusp::ui {

/// "Depth: 1.50 mm, was 2.00 mm". `whole`: the target of the exercise that has it, for the titles of several. `own`: the
/// specimen's names of its tissues.
QString change_message(const Change& change, const Region* whole = nullptr, const TissueNames& own = {});
/// One line for each difference, none twice. `own`: of the tissues of `after`.
QStringList change_messages(const Scenario& before, const Scenario& after, const TissueNames& own = {});

}  // namespace cusp::ui
