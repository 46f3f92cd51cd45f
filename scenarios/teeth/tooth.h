/// Whole permanent teeth, grown from the tables of teeth.json: enamel, dentine, cementum and pulp as a banded volume,
/// and the landmarks that belong to it.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "engine/base/result.h"
#include "engine/volume/voxel_volume.h"
#include "scenarios/modules.h"
#include "scenarios/teeth/caries.h"
#include "scenarios/teeth/landmarks.h"
#include "scenarios/teeth/scenery.h"

namespace cusp::scenarios {

enum class ToothError : std::uint8_t {
  unknown_fdi,     // not 11..18, 21..28, 31..38, 41..48
  bad_voxel_size,  // not within kMinToothVoxelMm .. kMaxToothVoxelMm (NaN too)
  bad_tables,      // teeth.json does not fit its schema: a broken build
  cancelled,
  unknown_site,  // a lesion is asked for where the tooth has no such place
};
using ToothFailure = Failure<ToothError>;

/// Below, one tooth takes more than half a gigabyte; above, a canal (0.3 mm) and a fissure fall between two voxels.
inline constexpr double kMinToothVoxelMm = 0.04;
inline constexpr double kMaxToothVoxelMm = 0.4;

struct ToothRequest {
  int fdi = 36;            // FDI number
  std::uint64_t seed = 0;  // 0: the average tooth; others vary within the spread of teeth.md
  double voxel_mm = 0.1;
  bool typodont = false;        // of plastic throughout, as in a training model; then no lesion is grown
  std::vector<Lesion> lesions = {};  // where two reach, the first of them counts
  bool neighbours = false;      // the teeth that touch it, in tissues of their own (own_tissues.h)
  bool gingiva = false, bone = false;
};

/// A tooth that stands beside the one that was asked for, touching it.
struct Neighbour {
  int fdi = 0;
  Vec3 contact_mm{0.0};  // where the two come nearest
  double gap_mm = 0.0;   // there: below 0.05
};

/// Stops early, with ToothError::cancelled, once *cancel is true. May be written by any thread.
using ToothCancel = const std::atomic<bool>*;
/// Called with a rising share in [0, 1], from the calling thread.
using ToothProgress = std::function<void(double)>;

struct Tooth {
  VoxelVolume volume;
  ToothLandmarks landmarks;
  std::vector<Neighbour> neighbours;  // mesial first
};

/// Grows a tooth and its landmarks. Banded s is the signed distance within the band; the tissue is set wherever s > 0.
/// Cementum and enamel are never thinner than 1.2 voxels, so that each tissue is one component. The same request gives the
/// same voxels on one build; voxels are stored and hashed, never grown again at replay. Quadrants 2 and 4 are those of
/// 1 and 3 mirrored in x, bit for bit. Uses up to two threads of its own. Not for the haptic thread.
[[nodiscard]] Result<Tooth, ToothFailure> grow_tooth(const ToothRequest& request, ToothCancel cancel = nullptr,
                                                     const ToothProgress& progress = {});

/// A tooth, or the gums, of a jaw beyond the reach of the bur.
struct JawSurface {
  int fdi = 0;       // 0: the gums
  SceneryMesh mesh;  // in the tooth's frame
};
inline constexpr double kSceneryStepMm = 0.3;  // fine enough behind the bur [M]

/// The jaw about a tooth and its neighbours as scenery of about `scenery_step_mm`: the other teeth, and the gums about
/// those if the request asks for gums. From the patient's right to the left; gums last. Pre: 0.1 <= scenery_step_mm <= 1.
[[nodiscard]] Result<std::vector<JawSurface>, ToothFailure> rest_of_jaw(const ToothRequest& request,
                                                                        double scenery_step_mm = kSceneryStepMm,
                                                                        ToothCancel cancel = nullptr);

/// grow_tooth for callers that need the voxels alone.
[[nodiscard]] Result<VoxelVolume, ToothFailure> make_tooth(const ToothRequest& request, ToothCancel cancel = nullptr,
                                                           const ToothProgress& progress = {});

/// The landmarks alone, without growing voxels (about a tenth of the time). Those of grow_tooth for the same request.
[[nodiscard]] Result<ToothLandmarks, ToothFailure> tooth_landmarks(const ToothRequest& request);

}  // namespace cusp::scenarios
