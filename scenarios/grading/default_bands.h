/// Bands that an author is offered for the measurements of a preparation's form.
#pragma once

#include <optional>
#include <string_view>

#include "scenarios/format/scenario.h"

namespace cusp::scenarios {

/// For form (scenarios/metrics/form.h) and the measurement groups (groups.h); nullopt for any other metric, as for over-cut and
/// firm caries over the pulp, which the exercise decides. `fdi`: the tooth, 0 for
/// none; a molar's ridge is wider than a premolar's. Sources: dental.md 2.2, row sets A and B, and 2.6; each has an edge that is
/// general knowledge, [M], and the editor says so.
[[nodiscard]] std::optional<Bands> default_bands(std::string_view metric, int fdi) noexcept;

}  // namespace cusp::scenarios
