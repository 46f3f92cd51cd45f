/// An exercise of a template on another grown tooth of the same number: each candidate of an assessment may get one. Thread: any.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/base/result.h"
#include "scenarios/format/scenario.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

enum class OtherToothError : std::uint8_t {
  by_hand,       // no template made it, or its tooth comes from a file
  edited,        // where: JSON pointer to what the template did not make: "/target"
  does_not_fit,  // where: key of the FitError, or JSON pointer to what the other tooth has not
};
using OtherToothFailure = Failure<OtherToothError>;

/// Why the exercise stays on its own tooth; nullopt: on_other_tooth() fits it to others. Some 50 ms.
[[nodiscard]] std::optional<OtherToothFailure> bound_to_its_tooth(const Scenario& exercise);

/// Whether title or briefing are no longer the template's: figures in them stay those of the exercise's own tooth.
/// Pre: it is not bound_to_its_tooth(). As long.
[[nodiscard]] bool keeps_its_texts(const Scenario& exercise);

/// The exercise on the tooth that `seed` grows: target, protected regions, lesions, and the bands and texts that are still the
/// template's, fitted anew. All else is the exercise's. Some 100 ms. Whether it suits its specimen is for scenarios/checks.
[[nodiscard]] Result<Scenario, OtherToothFailure> on_other_tooth(const Scenario& exercise, std::uint64_t seed);

}  // namespace cusp::scenarios
