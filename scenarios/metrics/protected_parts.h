/// What an attempt was to spare: the protected tissues and regions of the scenario, and their damage.
///
/// protected_removed (mm3): tissue that is gone of them all; what two of them hold counts twice.
/// protected_damage (count): how many are damaged at their severity, beyond the uncertainty: removal, some of it is gone;
/// touch, it lies bare; depth, the cut reaches deeper into the region than depth_mm.
/// Source: dentistry.md ("protected regions with a severity each"). Needs: a scenario that protects something.
#pragma once

#include <optional>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/metrics/patch_faces.h"
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

enum class ProtectedMeasure : std::uint8_t { removed, damage };

/// The cut surface that the measure is about: in a region or a tissue of which some is gone; of `damage`, where it is damaged at its
/// severity: of touch also where it lies bare, of depth what is deeper. Where a tissue is gone wholly, the cut surface that lies nearest
/// to where it stood. Empty where the measure is zero. `sum`: of all bricks. Walks the cut bricks as protected_damage().
[[nodiscard]] std::vector<Triangle> protected_faces(const Reference& reference, const Volume& volume, const RegionShares& sum, ProtectedMeasure measure);

/// The same of a tissue alone: where the cut went into it, or laid it bare.
[[nodiscard]] std::vector<Triangle> bare_faces(const Volume& volume, Tissue tissue);

}  // namespace cusp::scenarios
