/// To which landmark a handle of the target goes. Frame: specimen, z up. Millimetres. Pure functions. Thread: any.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scenarios/format/landmark.h"
#include "ui/modules.h"

namespace cusp::scenarios {
struct ToothLandmarks;
}

namespace cusp::ui {

/// Cusp tips, pits, fissures, ridges and contacts of a grown tooth, as an exercise keeps those of a tooth from a file.
std::vector<Landmark> marks_of(const scenarios::ToothLandmarks& grown);

struct SnapPlace {
  std::size_t mark = 0;  // index
  Vec3 at_mm{0.0};
  double far_mm = 0.0;   // seen from above
};

/// The nearest place seen from above, at most `reach_mm` away: of a cusp tip, a pit, a contact or a contour, else of a line on the
/// biting surface. Axes and the cemento-enamel junction have none.
std::optional<SnapPlace> nearest_place(std::span<const Landmark> marks, Vec3 at_mm, double reach_mm);

}  // namespace cusp::ui
