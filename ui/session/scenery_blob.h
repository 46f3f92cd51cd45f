/// Scenery as bytes for the cache of grown specimens.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "scenarios/teeth/tooth.h"
#include "ui/modules.h"

namespace cusp::ui {

std::vector<std::byte> scenery_bytes(const std::vector<JawSurface>& scenery);
/// nullopt when the bytes are not whole, or name a point that is not there. Sizes are checked before memory is taken.
std::optional<std::vector<JawSurface>> scenery_from_bytes(std::span<const std::byte> bytes);

}  // namespace cusp::ui
