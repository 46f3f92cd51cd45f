/// Text for the findings of an audit: for the verb and for the editor's page.
#pragma once

#include "scenarios/audit/audit.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"

namespace cusp::ui {

/// "Detail of 0.20 mm", "Pulp left out". `own`: the names that the tooth's volume gives its tissues.
QString choice_name(const Choice& choice, const TissueNames& own = {});
QString verdict_name(Verdict verdict);
/// What was found: "Every attempt keeps its score within 2 points: Vibration left out. An update takes 31 µs instead of 40, …"
QString leanest_sentence(const AuditReport& report, const TissueNames& own = {});
Message describe(const AuditFailure& failure);

}  // namespace cusp::ui
