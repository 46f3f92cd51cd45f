/// Where a camera begins: about the place of work. Pure.
#pragma once

#include "engine/volume/voxel_volume.h"
#include "ui/render/target_look.h"

namespace cusp::ui {

struct StartView {
  Vec3 centre_mm{0.0};
  double radius_mm = 1;
};

/// Shows the target with about two millimetres round it; without a target, the specimen.
StartView start_view(const Grid& specimen, const TargetLook& look);

}  // namespace cusp::ui
