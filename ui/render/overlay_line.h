/// Lines drawn at the tooth's surface: the outlines of target and leeway. Plain values, any thread.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "engine/volume/volume.h"
#include "ui/modules.h"
#include "ui/render/baked_patch.h"
#include "ui/render/colours.h"

namespace cusp::ui {

struct LineStyle {
  Colour colour = kTargetLine;
  Colour casing = kTargetCasing;  // drawn under it, a little wider
  float width_px = 3.0f;
  float dash_mm = 0.0f;           // 0: solid
  float gap_mm = 0.0f;
};

inline constexpr LineStyle kTargetStyle{kTargetLine, kTargetCasing, 3.5f, 0.0f, 0.0f};
inline constexpr LineStyle kLeewayStyle{kLeewayLine, kLeewayCasing, 2.5f, 0.28f, 0.2f};

struct OverlayLine {
  std::vector<Vec3f> points_mm;   // along the line; closed when the last equals the first
  std::vector<Vec3f> normals;     // of the surface, as many; empty: always seen unless something is before it
  LineStyle style;
};

/// Where a scalar field of the place is `level`, along the surface of these patches: chained into lines, only where the
/// surface faces up (normal.z above `least_up`).
std::vector<OverlayLine> contour_lines(std::span<const BakedPatch* const> patches,
                                       const std::function<double(Vec3 mm)>& field, double level, double least_up,
                                       const LineStyle& style);

/// The outlines on the specimen's own surface, before any cut: `sideways_mm` is the signed distance to the target's
/// walls as seen along its approach (below 0 inside), the leeway line lies at `leeway_mm`.
std::vector<OverlayLine> target_lines(const Volume& uncut, const std::function<double(Vec3 mm)>& sideways_mm,
                                      double leeway_mm);

}  // namespace cusp::ui
