/// Plays an audit's models with scripted operators, in virtual time: the loop's ticks, measures and grades of a real attempt.
/// Nothing is kept. Thread: the caller's. Up to minutes.
#pragma once

#include <filesystem>

#include "scenarios/audit/operators.h"
#include "ui/modules.h"

namespace cusp::ui {

/// For one exercise at a time, one thread at a time; `folder`: where a volume that it names lies.
[[nodiscard]] AuditRunner audit_runner(std::filesystem::path folder);

/// How the attempts are played; the costs are measured in ticks of 1 ms.
inline constexpr std::uint32_t kAuditTickUs = 8000;

}  // namespace cusp::ui
