/// An operator's path as bytes for the cache of grown teeth.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "scenarios/operators/plan.h"
#include "ui/modules.h"

namespace cusp::ui {

std::vector<std::byte> plan_bytes(const Plan& plan);
/// nullopt when the bytes are no whole path with a bur below `burs`.
std::optional<Plan> plan_from_bytes(std::span<const std::byte> bytes, std::size_t burs);

}  // namespace cusp::ui
