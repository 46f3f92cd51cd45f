/// Landmarks read off the fields of a grown tooth.
#pragma once

#include "scenarios/teeth/landmarks.h"
#include "scenarios/teeth/shape.h"

namespace cusp::scenarios {

ToothLandmarks find_landmarks(const ToothShape& shape);

/// The same with x turned round.
ToothLandmarks mirrored(ToothLandmarks landmarks);

}  // namespace cusp::scenarios
