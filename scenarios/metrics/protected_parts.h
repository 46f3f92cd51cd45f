/// What an attempt was to spare: the protected tissues and regions of the scenario, and their damage.
///
/// protected_removed (mm3): tissue that is gone of them all; what two of them hold counts twice.
/// protected_damage (count): how many are damaged at their severity, beyond the uncertainty: removal, some of it is gone;
/// touch, it lies bare; depth, the cut reaches deeper into the region than depth_mm.
/// Source: dentistry.md ("protected regions with a severity each"). Needs: a scenario that protects something.
#pragma once

#include <optional>

#include "engine/volume/volume.h"
#include "scenarios/metrics/region_shares.h"

namespace cusp::scenarios {

struct ProtectedDamage {
  double removed_mm3 = 0;
  double uncertainty_mm3 = 0;
  int damaged = 0;
  std::optional<Vec3> at_mm;  // of the first that is damaged, where its cut is known to lie
};

/// How uncertain the mm3 of a removed tissue is: its cut faces and its borders with other tissues.
[[nodiscard]] double tissue_sigma_mm3(const Reference& reference, const RegionShares& sum, Tissue tissue) noexcept;

/// `sum`: of all bricks. nullopt where the scenario protects nothing. Walks the cut bricks once for each region, and for each
/// tissue of severity touch.
[[nodiscard]] std::optional<ProtectedDamage> protected_damage(const Reference& reference, const Volume& volume, const RegionShares& sum);

}  // namespace cusp::scenarios
