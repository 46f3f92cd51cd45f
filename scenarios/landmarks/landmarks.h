/// An imported tooth's landmarks as a grown tooth has them.
#pragma once

#include "scenarios/format/scenario.h"
#include "scenarios/modules.h"
#include "scenarios/teeth/landmarks.h"

namespace cusp::scenarios {

/// Lists without what is not marked. `central`: the central pit, else the middle of the central groove. `dims`: extents of the
/// crown by contacts and contours, 0 where one of the two is missing. The other lengths stay 0.
[[nodiscard]] ToothLandmarks as_grown(const SpecimenLandmarks& landmarks);

/// The way of mesial along x (mesial_x of the number); 0 without number or mesial axis, and for a tooth that is turned further
/// than kMostTurnedDeg: nobody knows then on which side a wall stands.
[[nodiscard]] int mesial_x_of(const SpecimenLandmarks& landmarks) noexcept;

/// Number of the tooth whose sides the specimen's frame has: of a grown tooth, or by the landmarks of a file (mesial_x_of). 0 where
/// nobody knows a side.
[[nodiscard]] int sided_fdi(const SpecimenSource& specimen) noexcept;

}  // namespace cusp::scenarios
