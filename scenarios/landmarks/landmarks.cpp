#include "scenarios/landmarks/landmarks.h"

#include <cmath>

namespace cusp::scenarios {

namespace {

/// Of kMostTurnedDeg. Measures use no trigonometry of the C library: it differs between processors.
constexpr double kMostTurnedTangent = 0.15838444032453627;

/// The place of a landmark, or nullptr.
const Vec3* place_of(const SpecimenLandmarks& landmarks, MarkKind kind, std::string_view name) noexcept {
  const Landmark* mark = landmarks.find(kind, name);
  return mark == nullptr || mark->points_mm.empty() ? nullptr : &mark->points_mm.front();
}

/// Distance across the crown, between two of its places.
double extent(const Vec3* a, const Vec3* b) noexcept {
  if (a == nullptr || b == nullptr) return 0.0;
  const double x = a->x - b->x, y = a->y - b->y;
  return std::sqrt(x * x + y * y);
}

}  // namespace

ToothLandmarks as_grown(const SpecimenLandmarks& landmarks) {
  ToothLandmarks out;
  for (const Landmark& mark : landmarks.marks) {
    if (mark.points_mm.empty()) continue;
    if (mark.kind == MarkKind::cusp_tip) out.cusp_tips.push_back({mark.name, mark.points_mm.front()});
    if (mark.kind == MarkKind::pit) out.pits.push_back({mark.name, mark.points_mm.front()});
    if (mark.kind == MarkKind::fissure) out.fissures.push_back({mark.name, mark.points_mm});
    if (mark.kind == MarkKind::marginal_ridge) out.marginal_ridges.push_back({mark.name, mark.points_mm});
    if (mark.kind == MarkKind::cej) out.cej = mark.points_mm;
  }
  const Vec3* const mesial = place_of(landmarks, MarkKind::contact, "mesial");
  const Vec3* const distal = place_of(landmarks, MarkKind::contact, "distal");
  if (mesial != nullptr) out.mesial_contact = *mesial;
  if (distal != nullptr) out.distal_contact = *distal;
  out.dims.mesiodistal = extent(mesial, distal);
  out.dims.buccolingual = extent(place_of(landmarks, MarkKind::contour, "buccal"), place_of(landmarks, MarkKind::contour, "lingual"));
  if (const Vec3* pit = place_of(landmarks, MarkKind::pit, "central")) {
    out.central = *pit;
  } else if (const SurfaceLine* groove = out.fissure("central"); groove != nullptr && !groove->points_mm.empty()) {
    out.central = groove->points_mm[groove->points_mm.size() / 2];
  }
  return out;
}

int mesial_x_of(const SpecimenLandmarks& landmarks) noexcept {
  const Landmark* axis = landmarks.find(MarkKind::mesial_axis);
  if (landmarks.fdi == 0 || axis == nullptr || axis->points_mm.size() != 2) return 0;
  const Vec3 way = axis->points_mm[1] - axis->points_mm[0];
  const int out = mesial_x(landmarks.fdi);
  const double along = out * way.x;
  return along > 0.0 && std::fabs(way.y) <= kMostTurnedTangent * along ? out : 0;
}

int sided_fdi(const SpecimenSource& specimen) noexcept {
  if (!specimen.generator.empty()) return specimen.grown_fdi();
  return mesial_x_of(specimen.landmarks) == 0 ? 0 : specimen.landmarks.fdi;
}

}  // namespace cusp::scenarios
