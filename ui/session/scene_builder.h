/// Scenario and device to what the engine runs.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>

#include "engine/scene/scene.h"
#include "engine/step/stiffness_rule.h"
#include "scenarios/format/scenario.h"
#include "ui/modules.h"
#include "ui/session/session_error.h"

namespace cusp::ui {

/// The scenario's voxels in the reading of its method. Up to seconds. `folder`: where a volume that it names lies.
/// stop: set by another thread, it ends early and fails (specimen); may be null.
Outcome<std::shared_ptr<const Specimen>> build_specimen(const Scenario& scenario, const std::filesystem::path& folder,
                                                    const std::atomic<bool>* stop = nullptr);

/// What a device leaves of a scenario's stiffness: all tissues get the same share, so that they keep their order.
struct StiffnessCut {
  double share = 1.0;              // (0, 1]
  double asked_n_per_mm = 0.0;     // of the stiffest tissue
  StiffnessRule rule;
  bool cuts() const noexcept { return share < 1.0; }
};
StiffnessCut stiffness_cut(const Scenario& scenario, double voxel_mm, const DeviceLimits& device) noexcept;

/// Axes that the device senses: the three of its place, and those of its orientation. For grade().
inline int sensed_axes(const DeviceLimits& device) noexcept { return 3 + device.rotation_axes; }

/// device_axes: a device that senses fewer axes than the scenario needs. A script may play every exercise.
Outcome<void> check_axes(const Scenario& scenario, const DeviceLimits& device);

/// Refuses (scene) a tissue of the specimen that the scenario does not describe, no instruments, and values out of the
/// engine's range; (device_class) a device that the scenario does not admit; (device_axes) as check_axes() does. Stiffness is cut by
/// stiffness_cut().
Outcome<std::shared_ptr<const Scene>> build_scene(const Scenario& scenario, std::shared_ptr<const Specimen> specimen,
                                              const DeviceLimits& device);
/// The same with the guard's settings and the share of stiffness of a stored session, whatever axes its device had.
Outcome<std::shared_ptr<const Scene>> build_scene(const Scenario& scenario, std::shared_ptr<const Specimen> specimen,
                                              const DeviceLimits& device, const GuardSettings& guard,
                                              double stiffness_share);

}  // namespace cusp::ui
