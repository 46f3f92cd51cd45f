/// A template's body to a scenario.json in the table's frame: expressions to numbers, fissures to lines, marks in texts to
/// figures. Thread: any.
#pragma once

#include <nlohmann/json.hpp>

#include "scenarios/teeth/landmarks.h"
#include "scenarios/templates/expression.h"
#include "scenarios/templates/templates.h"

namespace cusp::scenarios {

/// `common`: tissues, device and the like of every template. A part or criterion with "when" is left out where that is 0; a
/// node with one part left is that part, without its name. A part with a name is left out where nothing of its fissures remains;
/// "names" are expressions, or several with "when", that others may name. "when" may name has.NAME: 1 where that part is one of several targets, else 0. The rubric may name outline.floor and
/// outline.wall: mm² of all outlines along lines. A text may stand in parts, which have "when" likewise. In texts "{depth}" is the
/// parameter with one or two digits after the decimal sign, "{tooth}" the number, "{boxes}" MO, MOD, and DO in English, OD elsewhere.
/// "needs" are expressions by name: a value of 0 refuses the fit (unmet_need).
[[nodiscard]] Result<nlohmann::ordered_json, FitFailure> fill_template(const nlohmann::ordered_json& body,
                                                                       const nlohmann::ordered_json& common, const FitRequest& request,
                                                                       const ToothLandmarks& landmarks, const Scope& scope);

}  // namespace cusp::scenarios
