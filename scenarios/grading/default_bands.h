/// Bands that an author is offered for the measurements of a preparation's form.
#pragma once

#include <optional>
#include <string_view>

#include "scenarios/format/scenario.h"

namespace cusp::scenarios {

/// For walls, floor, isthmus and ridges (scenarios/metrics/form.h); nullopt for any other metric. `fdi`: the tooth, 0 for
/// none; a molar's ridge is wider than a premolar's. Sources: dental.md 2.2, row sets A and B; each has an edge that is
/// general knowledge, [M], and the editor says so.
[[nodiscard]] std::optional<Bands> default_bands(std::string_view metric, int fdi) noexcept;

}  // namespace cusp::scenarios
