#include "scenarios/teeth/tooth.h"

#include "scenarios/teeth/find_landmarks.h"
#include "scenarios/teeth/tables.h"
#include "scenarios/teeth/voxels.h"

namespace cusp {
namespace {


bool stopped(ToothCancel cancel) { return cancel != nullptr && cancel->load(); }

}  // namespace

Result<Tooth, ToothFailure> grow_tooth(const ToothRequest& request, ToothCancel cancel, const ToothProgress& progress) {
  if (!(request.voxel_mm >= kMinToothVoxelMm && request.voxel_mm <= kMaxToothVoxelMm)) {
    return fail(ToothError::bad_voxel_size, "voxel_mm", std::to_string(request.voxel_mm));
  }
  const auto choice = table_for(request.fdi);
  if (!choice) return std::unexpected(choice.error());
  if (stopped(cancel)) return fail(ToothError::cancelled, "tooth");
  const ToothShape shape(*choice->table, request.seed, request.voxel_mm);
  constexpr double kShapeShare = 0.25;  // of the time, measured at 0.1 mm
  if (progress) progress(kShapeShare);
  if (stopped(cancel)) return fail(ToothError::cancelled, "tooth");
  ToothLandmarks landmarks = find_landmarks(shape);
  auto volume = voxels_of(shape, request.voxel_mm, cancel, progress, kShapeShare);
  if (!volume) return std::unexpected(volume.error());
  if (choice->mirrored) return Tooth{mirrored(*volume), mirrored(std::move(landmarks))};
  return Tooth{std::move(*volume), std::move(landmarks)};
}

Result<VoxelVolume, ToothFailure> make_tooth(const ToothRequest& request, ToothCancel cancel,
                                             const ToothProgress& progress) {
  auto tooth = grow_tooth(request, cancel, progress);
  if (!tooth) return std::unexpected(tooth.error());
  return std::move(tooth->volume);
}

Result<ToothLandmarks, ToothFailure> tooth_landmarks(const ToothRequest& request) {
  if (!(request.voxel_mm >= kMinToothVoxelMm && request.voxel_mm <= kMaxToothVoxelMm)) {
    return fail(ToothError::bad_voxel_size, "voxel_mm", std::to_string(request.voxel_mm));
  }
  const auto choice = table_for(request.fdi);
  if (!choice) return std::unexpected(choice.error());
  ToothLandmarks landmarks = find_landmarks(ToothShape(*choice->table, request.seed, request.voxel_mm));
  return choice->mirrored ? mirrored(std::move(landmarks)) : landmarks;
}

Result<ToothDims, ToothFailure> average_dims(int fdi) {
  const auto choice = table_for(fdi);
  if (!choice) return std::unexpected(choice.error());
  return choice->table->dims;
}

}  // namespace cusp
