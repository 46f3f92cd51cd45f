/// How deep under enamel the next other tissue lies, everywhere in a specimen. Of the specimen as it was: cutting changes
/// none of it. Costs some 20 ms for a molar. Any thread once made.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/volume/specimen.h"
#include "ui/modules.h"

namespace cusp::ui {

class JunctionDepth {
 public:
  static constexpr float kMostMm = 2.5f;

  JunctionDepth() = default;
  explicit JunctionDepth(const Specimen& specimen);

  /// Distance to dentine, cementum, pulp or a lesion, at least 0 and at most kMostMm. `voxel`: in voxels, whole at their
  /// centres.
  float mm_at(Vec3f voxel) const noexcept;

 private:
  void seed(const Specimen& specimen);
  void sweep();
  void blur();
  void relax(IVec3 cell);
  std::size_t index(IVec3 c) const noexcept { return static_cast<std::size_t>(c.x + size_.x * (c.y + size_.y * c.z)); }

  int edge_ = 4;         // voxels of a cell: 4, or 8 where the specimen has very many
  float cell_mm_ = 0.0f;
  IVec3 size_{0};
  std::vector<float> distance_;       // [cell] in cells; empty where no enamel lies beside anything else
  std::vector<std::uint8_t> fixed_;   // [cell] while sweeping: measured in the cell itself
};

bool is_enamel(Tissue tissue) noexcept;

}  // namespace cusp::ui
