/// An audit's result for other programs. Keys are stable and the same in every language: "goes" lists attempts, "hand" names
/// an operator. Figures are stable but for the times of "cost".
#pragma once

#include <string>

#include "scenarios/audit/audit.h"

namespace cusp::scenarios {

[[nodiscard]] std::string audit_json(const AuditReport& report);

}  // namespace cusp::scenarios
