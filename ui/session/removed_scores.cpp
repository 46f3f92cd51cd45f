#include "ui/session/removed_scores.h"

#include <algorithm>

namespace cusp::ui {

void RemovedScores::update(const Volume& volume, std::span<const std::int32_t> changed) {
  const Specimen& specimen = volume.specimen();
  const bool filled = specimen.reading() == Reading::filled;
  for (const std::int32_t brick : changed) {
    std::array<std::uint32_t, kTissueCodes> gone{};
    const std::uint16_t* cut = volume.cut_of(brick);
    for (int o = 0; o < kBrickVoxels; ++o) {
      const std::uint16_t base = specimen.s_in(brick, o);
      const bool was = filled ? base > 0 : base >= kHalf;
      const bool is = filled ? std::min(base, cut[o]) > 0 : std::min(base, cut[o]) >= kHalf;
      if (was && !is) ++gone[index_of(specimen.tissue_in(brick, o))];
    }
    auto& before = gone_voxels_[brick];
    for (std::size_t t = 0; t < kTissueCodes; ++t) gone_total_[t] += gone[t] - before[t];
    before = gone;
  }
  live_.update(volume, changed);
}

std::vector<RemovedTissue> RemovedScores::removed() const {
  std::vector<RemovedTissue> out;
  for (std::size_t t = 1; t < kTissueCodes; ++t) {
    const double mm3 = live_.reading().removed_mm3[t];
    if (gone_total_[t] > 0 || mm3 > 0) out.push_back({static_cast<Tissue>(t), gone_total_[t], mm3});
  }
  return out;
}

}  // namespace cusp::ui
