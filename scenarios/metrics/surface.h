/// How near the cut surface came to the target's. Source: dentistry.md, group "surface"; dental.md 2.6 (Sadid-Zadeh 2019: passed
/// at 72 % within 200 µm; Dai 2024: 300 µm for class I, 400 µm for class II).
///
/// surface_within_<x> (%): share of the target's surface, by area, that has the cut surface within x µm.
/// surface_rms, surface_p95, surface_greatest (mm): of the distances from the target's surface to the cut surface.
/// The target's surface is what an exact cut would leave: the part of its boundary within the tooth.
/// Needs: a target, a banded volume, a cut.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/volume/volume.h"
#include "scenarios/grading/grade.h"
#include "scenarios/metrics/reference.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

inline constexpr std::array<int, 5> kToleranceUm = {100, 200, 300, 400, 500};

struct SurfaceMatch {
  std::array<double, kToleranceUm.size()> share{}, share_uncertainty{};  // 0 to 1; 95 %: every distance off by a place's
  double rms_mm = 0, p95_mm = 0, greatest_mm = 0;
  double uncertainty_mm = 0;           // 95 %, of rms and p95: a place's
  double greatest_uncertainty_mm = 0;  // 95 %
  Vec3 greatest_at_mm{0.0};   // on the target's surface
};

/// Some tenths of a second for a molar at 0.1 mm. nullopt where one of the needs is missing.
[[nodiscard]] std::optional<SurfaceMatch> surface_match(const Reference& reference, const Volume& volume);

void add_surface(const Reference& reference, const Volume& volume, std::vector<Measure>& out);

}  // namespace cusp::scenarios
