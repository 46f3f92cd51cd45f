/// What was removed, divided by place (target, tolerance zone, beyond; floor and sides) and by tissue, brick by brick: the
/// final measures are the sum over all bricks, the live scores keep the sum by redoing the bricks that changed.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/metrics/evidence.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

struct RegionShares {
  std::array<double, kPlaces> removed_mm3{};           // by Place
  std::array<double, kPlaces> cut_face_mm2{};          // area that the bur left, by Place
  double target_boundary_mm2 = 0;                      // of the target's own boundary, what was removed with it
  std::array<Evidence, kPlaces> worst{};               // by Place: on a floor the deepest, on a wall the furthest out
  std::array<double, kTissueCodes> tissue_mm3{};       // removed
  std::array<double, kTissueCodes> tissue_face_mm2{};  // cut face in that tissue
  std::array<double, kTissueCodes> tissue_seam_mm2{};  // removed border between this tissue and another
  double pulp_mm = std::numeric_limits<double>::infinity();  // least distance from the cut face to the pulp
  Vec3 pulp_at_mm{0.0};

  void add(const RegionShares& other) noexcept;
};

/// remaining_over_pulp, mm. 0 once nothing of the pulp is left: then no cut surface passes it, and of a tooth that is gone whole
/// there is none. nullopt: no pulp, or one that no cut surface is near.
/// `sum`: of all bricks.
[[nodiscard]] std::optional<double> over_pulp_mm(const Reference& reference, const Volume& volume, const RegionShares& sum);

/// Of the cells of one brick (see cut_volume.h); depends on this brick and its 26 neighbours.
[[nodiscard]] RegionShares shares_of_brick(const Reference& reference, const Volume& volume, int brick);

/// removed_mm3 of the target alone. It cuts no cell of a brick that the target does not reach.
[[nodiscard]] double removed_of_target_mm3(const Reference& reference, const Volume& volume, int brick);

/// Bricks whose cells can have lost something: those that were cut and their neighbours, ascending.
[[nodiscard]] std::vector<int> bricks_to_measure(const Volume& volume);

}  // namespace cusp::scenarios
