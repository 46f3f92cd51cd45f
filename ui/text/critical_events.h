/// A grade's critical events with what is known of them besides: when it happened, and where. Needs no window.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/format/scenario.h"
#include "scenarios/grading/grade.h"
#include "storage/store.h"
#include "ui/modules.h"

namespace cusp::ui {

struct CriticalEvent {
  std::string key;               // "pulp_exposure", "dry_cutting"
  std::optional<double> at_s;    // since the attempt's start, at most a second late; none: not known
  std::optional<Vec3> place_mm;  // none: not known
};

/// In the order of the grade; the opened pulp before all others. `store` may be null: then no time is known.
std::vector<CriticalEvent> critical_events(const Grade& grade, Store* store, const SessionId& session);

/// "The pulp was exposed after 1:12 min, distobuccal".
QString critical_text(const CriticalEvent& event, const SpecimenSource& specimen);
/// What to do next time.
QString critical_advice(const std::string& key);

/// "mesiobuccal", "lingual": the side of a tooth on which a place lies; empty in its middle and for what is no tooth.
QString side_text(const SpecimenSource& specimen, Vec3 place_mm);

}  // namespace cusp::ui
