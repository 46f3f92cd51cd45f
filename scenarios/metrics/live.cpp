#include "scenarios/metrics/live.h"

#include <algorithm>
#include <cmath>

namespace cusp::scenarios {

LiveMetrics::LiveMetrics(std::shared_ptr<const Reference> reference) : reference_(std::move(reference)) { reset(); }

void LiveMetrics::reset() {
  bricks_.clear();
  reading_ = {};
  reading_.target_measured = reference_->target_mm3() > 0.0;
}

void LiveMetrics::update(const Volume& volume, std::span<const std::int32_t> changed) {
  if (changed.empty()) return;

  // A brick's cells read that brick and those beyond its upper faces; a filled voxel's faces read both sides.
  const Specimen& specimen = volume.specimen();
  const int above = specimen.reading() == Reading::filled ? 1 : 0;
  dirty_.clear();
  for (const std::int32_t brick : changed) {
    const IVec3 at = specimen.brick_at(brick);
    for (int z = -1; z <= above; ++z)
      for (int y = -1; y <= above; ++y)
        for (int x = -1; x <= above; ++x) {
          const int b = specimen.brick_index(at + IVec3(x, y, z));
          if (b >= 0) dirty_.push_back(b);
        }
  }
  std::sort(dirty_.begin(), dirty_.end());
  dirty_.erase(std::unique(dirty_.begin(), dirty_.end()), dirty_.end());
  for (const int b : dirty_) bricks_[b] = shares_of_brick(*reference_, volume, b);

  RegionShares sum;
  for (const auto& [brick, shares] : bricks_) sum.add(shares);
  reading_.overcut_mm3 = sum.removed_mm3;
  reading_.removed_mm3 = sum.tissue_mm3;
  constexpr auto kTarget = static_cast<std::size_t>(Place::target);
  if (reading_.target_measured)
    reading_.target_removed = 100.0 * std::clamp(sum.removed_mm3[kTarget] / reference_->target_mm3(), 0.0, 1.0);
  reading_.remaining_over_pulp_mm =
      !reference_->pulp().empty() && std::isfinite(sum.pulp_mm) ? std::optional(sum.pulp_mm) : std::nullopt;
}

}  // namespace cusp::scenarios
