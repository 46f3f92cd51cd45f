/// Carious tissue that is left, and sound tissue that was lost for nothing. Source: dentistry.md, group "caries".
///
/// caries_left_periphery (mm3): soft and firm carious dentine left within 1 mm of the enamel or cementum: it must be hard there.
/// caries_left_pulp (mm3): soft carious dentine left further in, over the pulp.
/// caries_left_pulp_firm (mm3): firm carious dentine left there, which may stay where the exercise says so.
/// caries_left_enamel (mm3): carious enamel left.
/// sound_lost (mm3): sound enamel, dentine and cementum removed outside the target and its tolerance zone, the permitted access.
/// Needs: a specimen with a lesion of that tissue; the last a target.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/grading/grade.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

inline constexpr double kPeripheryMm = 1.0;

struct CariesPart {
  double mm3 = 0;              // left
  double before_mm3 = 0;       // before anything was cut; 0: not measurable
  double uncertainty_mm3 = 0;  // 95 %: its borders with other tissues, and its cut face
  std::optional<Vec3> at_mm;   // where some of it is left
  std::vector<IVec3> voxels;   // that are left
};

struct CariesLeft {
  CariesPart periphery, pulp_soft, pulp_firm, enamel;
};

/// Walks the lesion's bricks. Tenths of a second for a molar at 0.1 mm.
[[nodiscard]] CariesLeft caries_left(const Reference& reference, const Volume& volume);

struct SoundLost {
  double mm3 = 0, uncertainty_mm3 = 0;         // 95 %: its cut face
  std::optional<Vec3> at_mm;                   // furthest from the target
  std::vector<std::array<Vec3, 3>> cut_faces;  // in sound tissue, beyond the tolerance zone
};
/// Walks the cut bricks. Pre: the target is not empty.
[[nodiscard]] SoundLost sound_lost(const Reference& reference, const Volume& volume);

void add_caries(const Reference& reference, const Volume& volume, std::vector<Measure>& out);

}  // namespace cusp::scenarios
