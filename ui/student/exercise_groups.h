/// The groups in which a student meets the exercises. Found by what the target is, so that published ones fall into them too. No widget.
#pragma once

#include <QString>
#include <array>

#include "scenarios/format/scenario.h"
#include "ui/modules.h"

namespace cusp::ui {

enum class ExerciseGroup : std::uint8_t { class_1, class_2, caries, other, block };
inline constexpr std::array kExerciseGroups = {ExerciseGroup::class_1, ExerciseGroup::class_2, ExerciseGroup::caries, ExerciseGroup::other,
                                               ExerciseGroup::block};

/// Caries: a leaf is a lesion, or the specimen has one. Class II: a face is a gingival floor. Class I: any other target on a
/// grown tooth. Block: a practice block. Other: an imported specimen.
ExerciseGroup group_of(const Scenario& scenario);
QString group_name(ExerciseGroup group);

}  // namespace cusp::ui
