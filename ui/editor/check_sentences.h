/// What stands against an exercise, in a instructor's words: one sentence, and where in the editor it is mended.
#pragma once

#include <QString>

#include "scenarios/format/validate.h"
#include "ui/modules.h"

namespace cusp::ui {

enum class EditorPlace { title, tooth, shape, points, burs, tissues };

/// "The target reaches out of the tooth: its edge lies at 12.3 mm, the tooth ends at 11.0 mm."
QString check_sentence(const Finding& finding);
EditorPlace place_of(const Finding& finding);

}  // namespace cusp::ui
