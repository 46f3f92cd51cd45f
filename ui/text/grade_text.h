/// Text for a grade: criteria, what they want, why points were lost, what to do next time. Needs no window.
#pragma once

#include <QString>
#include <string>
#include <string_view>

#include "scenarios/format/scenario.h"
#include "scenarios/grading/changes.h"
#include "storage/records/self_assessment.h"
#include "ui/modules.h"
#include "ui/text/names.h"

namespace cusp::ui {

/// "Floor depth, deepest" for a key of scenarios/metrics; the key itself for one that has no name yet. Of one of several targets
/// "Floor depth, deepest (mesial pit)": by its title in `whole`, the exercise's target, else by its name. `own`: the names that the
/// tooth's volume gives its tissues.
QString metric_name(const std::string& metric, const Region* whole = nullptr, const TissueNames& own = {});
/// The title of one of several targets; its name in words where it has none.
QString target_title(std::string_view name, const Region* whole);
QString metric_unit(const std::string& metric);
/// Whether the values of a metric are 1 for yes and 0 for no.
bool is_yes_or_no(const std::string& metric);
/// "1.84 mm ± 0.03"; "yes" or "no" alone for a metric of these. Pre: measured.
QString measure_text(const Measure& measure);
/// The two halves of the above; the second is empty for "yes" and "no".
QString measure_value(const Measure& measure);
QString measure_uncertainty(const Measure& measure);
QString critical_name(const std::string& critical);

/// "1.5 to 2.0", "under 0.3", "99 or more": what earns full points.
QString wanted_text(const Criterion& criterion);
/// Why points were lost: "2.41 mm, 0.41 mm deeper than 2 mm", "0.2 % removed; full points from 97 %".
QString reason_text(const CriterionGrade& grade);
/// What to give tr() as %n for points that may be a fraction: only a plain "1" is singular, "1.5" and "0.5" are not.
int point_forms(double points);
/// "1 point", "1.5 points", "−3 points".
QString points_text(double points);
/// "Floor depth, deepest: 1 point lost". `lost`: scaled points (scenarios/grading/maxima.h).
QString lost_text(const CriterionGrade& grade, double lost, const Region* whole = nullptr, const TissueNames& own = {});
/// The one sentence about criteria that count for less because their target is left, with share_counted(), which is not the
/// share that was removed. Empty where no target is left, or where no criterion has its mark (mark_counted_with_target).
QString counted_text(const Grade& grade, const Rubric& rubric);
/// "met", "partly met", "not met": a student's own rating of a criterion.
QString own_rating_name(OwnRating rating);
/// A grade that was made anew against the stored one: its evaluator, its points, and the criteria and critical events that differ.
QString changes_text(const GradeChanges& changes, const Region* whole = nullptr, const TissueNames& own = {});
/// What to do next time, for a criterion that lost points by what was done; empty for the others.
QString advice_text(const CriterionGrade& grade);

}  // namespace cusp::ui
