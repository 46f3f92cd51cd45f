/// Where the average tooth of a number lies in a specimen, seen from above: what names peaks and valleys. Inside of this folder.
#pragma once

#include "scenarios/landmarks/tooth_surface.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

class ToothShape;

/// Whether a table's tooth is to be mirrored: quadrants 2 and 4.
enum class Hand : std::uint8_t { as_table, mirrored };

struct PlanFit {
  Vec2 mesial{1.0, 0.0}, buccal{0.0, 1.0};  // of length 1
  Vec2 centre_mm{0.0};                      // specimen
  Vec2 table_centre_mm{0.0};                // the same place in the table's frame
  Vec2 scale{1.0};                          // along mesial, buccal
  double off_mm = 0;                        // mean difference of heights, where one of the two stands

  Vec2 to_specimen(Vec2 table) const noexcept {
    const Vec2 from = scale * (table - table_centre_mm);
    return centre_mm + from.x * mesial + from.y * buccal;
  }
};

/// The turn, shift and scales with the least mean difference of heights below the highest place. Tries every 15 degrees, then
/// descends from the best three. A tenth of a second. Pre: the surface is not empty.
[[nodiscard]] PlanFit fit_plan(const ToothSurface& tooth, const ToothShape& table, Hand hand);

}  // namespace cusp::scenarios
