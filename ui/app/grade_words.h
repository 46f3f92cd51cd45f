/// What a grade says, put into words: criteria, what they want, why points went, what to do next time. Needs no window.
#pragma once

#include <QString>
#include <string>

#include "scenarios/format/scenario.h"
#include "scenarios/grading/grade.h"

namespace cusp {

/// "Floor depth, deepest" for a key of scenarios/metrics; the key itself for one that has no words yet.
QString metric_name(const std::string& metric);
QString metric_unit(const std::string& metric);
QString critical_name(const std::string& critical);

/// "1.5 to 2.0", "under 0.3", "99 or more": what earns full points.
QString wanted_text(const Criterion& criterion);
/// Why points went: "2.41 mm, 0.41 mm deeper than 2 mm", "0.2 % removed; full points from 97 %".
QString reason_text(const CriterionGrade& grade);
/// What to give tr() as %n for points that may be a fraction: only a plain "1" is singular, "1.5" and "0.5" are not.
int point_forms(double points);
/// "Floor depth, deepest: 1 point lost".
QString lost_text(const CriterionGrade& grade);
/// What to do next time, for a criterion that lost points by what was done; empty for the others.
QString advice_text(const CriterionGrade& grade);

}  // namespace cusp
