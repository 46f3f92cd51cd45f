/// Landmarks of a tooth from a file, proposed: the author corrects them.
/// The long axis is that of least inertia; peaks, valleys and crests of the biting surface take the names of the average tooth of
/// that number, laid over it (plan_fit.h). What is not found is left out. Frame: specimen, z occlusal. Millimetres.
#pragma once

#include "engine/base/result.h"
#include "engine/volume/voxel_volume.h"
#include "scenarios/format/landmark.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

enum class ProposeError : std::uint8_t {
  unknown_fdi,  // where: the number
  no_tooth,     // the volume holds no hard tissue of a tooth
};

/// Some 0.5 s. Any thread; not the haptic one. Pre: one tooth, its crown up (z).
[[nodiscard]] Result<SpecimenLandmarks, Failure<ProposeError>> propose_landmarks(const VoxelVolume& volume, int fdi);

/// How far a proposal may be off, mm; of an axis in degrees. Measured: README.md; tests/scenarios/landmarks holds it.
[[nodiscard]] double proposal_error(MarkKind kind, double voxel_mm) noexcept;

}  // namespace cusp::scenarios
