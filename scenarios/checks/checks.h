/// What stands against an exercise beyond its form: what its target does to the tooth, whether somebody passes who has
/// hardly touched it, and whether its text still describes the exercise that it was copied from. Findings as those of
/// scenarios/format/validate.h, which comes first. Not for the haptic thread.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "engine/volume/specimen.h"
#include "scenarios/format/validate.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Target and tolerance zone against the tissues of the specimen; some 10 ms.
/// Errors: target_opens_pulp (value mm deep; opening it fails the attempt, or it holds too little pulp to be an access),
/// target_cuts_protected (detail: tissue), target_without_tissue, target_uncuttable (value mm3 of a
/// tissue of speed 0; detail: tissue). Warnings: target_holds_pulp (value mm3: an endodontic
/// access), pulp_rule_off (opening the pulp fails nobody), leeway_opens_pulp (value mm away), leeway_cuts_protected.
[[nodiscard]] std::vector<Finding> check_regions(const Scenario& scenario, const Specimen& specimen);

/// The scenario's own rubric on the untouched specimen, on two that lack a twentieth of the target, its top and a shaft to the floor,
/// and on one without the target. Some tenths of a second, with a box's measures seconds. Errors: idle_earns (value points: nothing was
/// cut), token_passes (value points), criterion_unmeasured (detail: a metric that the finished target has not: it would drop out of
/// every grade), target_fails (whoever cuts the target and nothing else does not pass; value points, limit: the pass mark, detail: the
/// critical event, if one fails it). Warning: token_earns (value: points, limit: what such a cut may earn). Pre:
/// has_error(validate(scenario)) is false, and the specimen is the scenario's in its method's reading.
[[nodiscard]] std::vector<Finding> check_attempts(const Scenario& scenario, std::shared_ptr<const Specimen> specimen);

/// Title and briefing, in every language there is, against those of `patterns`: what an author began from. Warnings:
/// text_of_template (the same text, though specimen or target differ), text_other_tooth (value: the tooth that a title
/// names, limit: the exercise's), text_figure (value: a length in mm that the text names and the target has not). detail: the language.
[[nodiscard]] std::vector<Finding> check_texts(const Scenario& scenario, std::span<const Scenario> patterns);
/// The exercises that come with the program: what check_texts() is given where nothing more is known.
[[nodiscard]] const std::vector<Scenario>& library_patterns();

/// All of the above, errors first.
[[nodiscard]] std::vector<Finding> check_exercise(const Scenario& scenario, std::shared_ptr<const Specimen> specimen);

}  // namespace cusp::scenarios
