/// The tooth that an assessment draws for a candidate. Any thread but the haptic one.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "engine/base/ids.h"
#include "engine/volume/specimen.h"
#include "scenarios/format/scenario.h"
#include "ui/modules.h"
#include "ui/session/session_error.h"

namespace cusp::ui {

/// Teeth tried for one candidate. A third of the teeth of each exercise suits (other_tooth_test): one candidate in 17,000 gets none.
inline constexpr int kMostDraws = 24;

/// Of the tooth that is tried after `draw` others. The same on every station and at every attempt; below 2^53, never 0.
std::uint64_t drawn_seed(AssignmentId assignment, UserId student, int draw);

using GrowSpecimen = std::function<Outcome<std::shared_ptr<const Specimen>>(const Scenario& exercise)>;

/// The exercise on the candidate's tooth: the first one tried that it fits without an error of check_exercise(). A criterion that
/// cannot be measured, or a target that does not pass itself, is none where the exercise's own tooth has it too. Fails as `grow` does, or with no_tooth. Seconds.
Outcome<Scenario> draw_tooth(const Scenario& exercise, AssignmentId assignment, UserId student, const GrowSpecimen& grow);

}  // namespace cusp::ui
