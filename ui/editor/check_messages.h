/// The findings of the checks as messages for the instructor, and the form of the editor that corrects each of them.
/// Pure functions.
#pragma once

#include <QString>

#include "scenarios/format/scenario.h"
#include "scenarios/format/validate.h"
#include "ui/modules.h"
#include "ui/text/names.h"

namespace cusp::ui {

enum class EditorPlace { title, tooth, shape, points, burs, tissues };

/// "The target reaches out of the tooth: its edge lies at 12.3 mm, the tooth ends at 11.0 mm." `whole`: the exercise's target, for
/// the titles of several. `tissues`: the specimen's names of its own.
QString check_message(const Finding& finding, const Region* whole = nullptr, const TissueNames& tissues = {});
EditorPlace place_of(const Finding& finding);

}  // namespace cusp::ui
