/// An audit's result for other programs. Keys are stable and the same in every language; the figures too, but for those of
/// "cost", which are times.
#pragma once

#include <string>

#include "scenarios/audit/audit.h"

namespace cusp::scenarios {

[[nodiscard]] std::string audit_json(const AuditReport& report);

}  // namespace cusp::scenarios
