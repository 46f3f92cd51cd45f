#include "scenarios/metrics/protected_parts.h"

#include <algorithm>

#include "scenarios/metrics/region_classifier.h"

namespace cusp::scenarios {

namespace {

/// Rms distance of a plane from the nearest voxel border: how a border between tissues is known.
constexpr double kSeamSigmaVoxels = 0.2887;  // 1 / sqrt(12)

/// What was cut of one region.
class RegionDamage final : public RegionClassifier {
 public:
  RegionDamage(const TargetShape& shape, const Leeway& none) : RegionClassifier(shape, none) {}
  double mm3 = 0, face_mm2 = 0;
  double depth_mm = -1e9;  // of the cut surface below the region's own; below 0 outside
  Vec3 at_mm{0.0};

  void face(const std::array<Vec3, 3>& corners, double mm2, Tissue) override {
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    double d = 0;
    if (place_at(middle, d) == Place::target) face_mm2 += mm2;
    if (-d <= depth_mm) return;
    depth_mm = -d;
    at_mm = middle;
  }

 private:
  void solid(Place place, double volume, Tissue) override {
    if (place == Place::target) mm3 += volume;
  }
};

struct Damaged {
  double mm3 = 0, sigma_mm3 = 0;
  bool damaged = false;
  std::optional<Vec3> at_mm;
};

Damaged damage_of_region(const Reference& reference, const Volume& volume, const ProtectedPart& part) {
  constexpr double kNone = 0.0;
  const Leeway none{kNone, kNone};
  RegionDamage sum(*part.shape, none);
  for (const int brick : bricks_to_measure(volume)) emit_removed_by_place(volume, brick, sum);
  Damaged out{sum.mm3, reference.surface_sigma_mm() * sum.face_mm2, false, std::nullopt};
  if (part.severity == Damage::removal) out.damaged = out.mm3 > out.sigma_mm3;
  if (part.severity == Damage::touch) out.damaged = sum.depth_mm > -reference.point_sigma_mm();
  if (part.severity == Damage::depth) out.damaged = sum.depth_mm > part.depth_mm + reference.point_sigma_mm();
  if (out.damaged) out.at_mm = sum.at_mm;
  return out;
}

/// A place where the tissue borders on what was removed.
std::optional<Vec3> bare_place(const Volume& volume, Tissue tissue) {
  const Specimen& specimen = volume.specimen();
  const Grid& grid = volume.grid();
  const auto gone = [&](IVec3 v) {
    const bool was = specimen.reading() == Reading::filled ? specimen.s(v) > 0 : specimen.s(v) >= kHalf;
    return was && !volume.occupied(v);
  };
  for (const std::int32_t brick : volume.cut_bricks()) {
    const IVec3 corner = specimen.brick_at(brick) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
      if (!gone(v)) continue;
      for (int axis = 0; axis < 3; ++axis)
        for (int step = -1; step <= 1; step += 2) {
          IVec3 next = v;
          next[axis] += step;
          if (specimen.tissue(next) == tissue && volume.occupied(next)) return 0.5 * (grid.centre_mm(v) + grid.centre_mm(next));
        }
    }
  }
  return std::nullopt;
}

Damaged damage_of_tissue(const Reference& reference, const Volume& volume, const RegionShares& sum, const ProtectedPart& part) {
  Damaged out{sum.tissue_mm3[index_of(part.tissue)], tissue_sigma_mm3(reference, sum, part.tissue), false, std::nullopt};
  out.damaged = out.mm3 > out.sigma_mm3;
  if (part.severity != Damage::touch || out.damaged) return out;
  out.at_mm = bare_place(volume, part.tissue);
  out.damaged = out.at_mm.has_value();
  return out;
}

}  // namespace

double tissue_sigma_mm3(const Reference& reference, const RegionShares& sum, Tissue tissue) noexcept {
  const std::size_t i = index_of(tissue);
  return reference.surface_sigma_mm() * sum.tissue_face_mm2[i] +
         kSeamSigmaVoxels * reference.specimen().grid().voxel_mm * sum.tissue_seam_mm2[i];
}

std::optional<ProtectedDamage> protected_damage(const Reference& reference, const Volume& volume, const RegionShares& sum) {
  if (reference.protected_parts().empty()) return std::nullopt;
  ProtectedDamage out;
  for (const ProtectedPart& part : reference.protected_parts()) {
    const Damaged one = part.shape ? damage_of_region(reference, volume, part) : damage_of_tissue(reference, volume, sum, part);
    out.removed_mm3 += one.mm3;
    out.uncertainty_mm3 += one.sigma_mm3;
    out.damaged += one.damaged ? 1 : 0;
    if (one.damaged && !out.at_mm) out.at_mm = one.at_mm;
  }
  return out;
}

}  // namespace cusp::scenarios
