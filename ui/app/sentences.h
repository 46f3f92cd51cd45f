/// Codes of every room, put into words: what happened, where, what was kept, and one way out. The rooms below ui have
/// codes only; whoever shows one to a person comes here. Needs no window.
#pragma once

#include <QString>
#include <string>

#include "engine/base/haptic_port.h"
#include "engine/loop/realtime.h"
#include "engine/step/step.h"
#include "engine/volume/tissue.h"
#include "scenarios/format/format_error.h"
#include "scenarios/format/scenario.h"
#include "scenarios/grading/grade.h"
#include "scenarios/import/import_error.h"
#include "storage/error.h"
#include "storage/repositories/sessions.h"
#include "storage/rights.h"
#include "ui/session/exercise_run.h"

namespace cusp {

/// A failure as people read it: one bold sentence, and what else there is to know.
struct Told {
  QString what;
  QString more;
  QString line() const { return more.isEmpty() ? what : what + u' ' + more; }
};

Told tell(const StorageFailure& failure);
Told tell(const FormatFailure& failure);
Told tell(const ImportFailure& failure);
Told tell(const PortFailure& failure);
Told tell(const RunFailure& failure);
Told tell(Fault fault);
/// How the loop of a device stands among other programs.
Told tell(const RealtimeGrant& grant);

/// Text in the installed language, English where there is none.
QString local(const LocalText& text);

QString role_name(Role role);
QString state_name(SessionState state);
QString kind_name(SessionKind kind);
QString device_name(const std::string& device_class);
QString tissue_name(Tissue tissue);
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
