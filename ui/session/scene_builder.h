/// Scenario and device to what the engine runs.
#pragma once

#include <filesystem>
#include <memory>

#include "engine/step/scene.h"
#include "scenarios/format/scenario.h"
#include "ui/session/run_error.h"

namespace cusp {

/// The scenario's voxels in the reading of its method. Up to seconds. `folder`: where a volume that it names lies.
Run<std::shared_ptr<const Specimen>> build_specimen(const Scenario& scenario, const std::filesystem::path& folder);

/// Refuses (scene) a tissue of the specimen that the scenario does not describe, no instruments, and values out of the
/// engine's range; (device_class) a device that the scenario does not admit. Stiffness is cut to the device's.
Run<std::shared_ptr<const Scene>> build_scene(const Scenario& scenario, std::shared_ptr<const Specimen> specimen,
                                              const DeviceLimits& device);
/// The same with the guard's settings of a stored session.
Run<std::shared_ptr<const Scene>> build_scene(const Scenario& scenario, std::shared_ptr<const Specimen> specimen,
                                              const DeviceLimits& device, const GuardSettings& guard);

}  // namespace cusp
