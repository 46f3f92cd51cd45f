#include "scenarios/metrics/protected_parts.h"

#include <algorithm>

#include "scenarios/metrics/region_classifier.h"

namespace cusp::scenarios {

namespace {

/// Rms distance of a plane from the nearest voxel border: how a border between tissues is known.
constexpr double kSeamSigmaVoxels = 0.2887;  // 1 / sqrt(12)

/// How deep below the region's surface the cut surface is damage of a severity other than removal.
double least_depth_mm(const Reference& reference, const ProtectedPart& part) noexcept {
  return part.severity == Damage::touch ? -reference.point_sigma_mm() : part.depth_mm + reference.point_sigma_mm();
}

/// What was cut of one region.
class RegionDamage final : public RegionClassifier {
 public:
  /// `least_mm`: deeper faces are kept, as those within the region.
  RegionDamage(const TargetShape& shape, const Leeway& none, double least_mm) : RegionClassifier(shape, none), least_mm_(least_mm) {}
  double mm3 = 0, face_mm2 = 0;
  double depth_mm = -1e9;  // of the cut surface below the region's own; below 0 outside
  double gone_mm = -1e9;   // of what was removed: a region that is gone wholly has no cut surface within
  Vec3 at_mm{0.0};
  struct Face {
    Triangle corners;
    double depth_mm;
    bool within;
  };
  std::vector<Face> faces;

  void face(const std::array<Vec3, 3>& corners, double mm2, Tissue) override {
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    double d = 0;
    const bool within = place_at(middle, d) == Place::target;
    if (within) face_mm2 += mm2;
    if (within || -d > least_mm_) faces.push_back({corners, -d, within});
    if (-d <= depth_mm) return;
    depth_mm = -d;
    at_mm = middle;
  }
  void box(Vec3 low, Vec3 high, Tissue tissue) override {
    note_gone(0.5 * (low + high));
    RegionClassifier::box(low, high, tissue);
  }
  void tetrahedron(const std::array<Vec3, 4>& corners, double volume, Tissue tissue) override {
    note_gone(0.25 * (corners[0] + corners[1] + corners[2] + corners[3]));
    RegionClassifier::tetrahedron(corners, volume, tissue);
  }

 private:
  void note_gone(Vec3 p) noexcept {
    if (!whole() || wholly_in_target()) gone_mm = std::max(gone_mm, -near_at(p).distance_mm);
  }
  void solid(Place place, double volume, Tissue) override {
    if (place == Place::target) mm3 += volume;
  }
  double least_mm_;
};

struct Damaged {
  double mm3 = 0, sigma_mm3 = 0;
  bool damaged = false;
  std::optional<Vec3> at_mm;
  std::vector<Triangle> removed_faces, damage_faces;  // of a region
};

Damaged damage_of_region(const Reference& reference, const Volume& volume, const ProtectedPart& part) {
  constexpr double kNone = 0.0;
  const Leeway none{kNone, kNone};
  const double least = least_depth_mm(reference, part);
  RegionDamage sum(*part.shape, none, least);
  for (const int brick : bricks_to_measure(volume)) emit_removed_by_place(volume, brick, sum);
  Damaged out{sum.mm3, reference.surface_sigma_mm() * sum.face_mm2, false, std::nullopt, {}, {}};
  out.damaged = part.severity == Damage::removal ? out.mm3 > out.sigma_mm3 : std::max(sum.depth_mm, sum.gone_mm) > least;
  if (out.damaged) out.at_mm = sum.at_mm;
  for (const RegionDamage::Face& face : sum.faces) {
    if (face.within) out.removed_faces.push_back(face.corners);
    const bool of_damage = part.severity == Damage::removal ? face.within : face.depth_mm > least;
    if (out.damaged && of_damage) out.damage_faces.push_back(face.corners);
  }
  return out;
}

bool is_gone(const Volume& volume, IVec3 v) noexcept { return was_solid(volume.specimen(), v) && !volume.occupied(v); }

/// Visits each voxel that is gone until the visit says that it has seen enough.
template <class Visit>
void each_gone(const Volume& volume, Visit&& visit) {
  const Specimen& specimen = volume.specimen();
  for (const std::int32_t brick : volume.cut_bricks()) {
    const IVec3 corner = specimen.brick_at(brick) * kBrickEdge;
    for (int o = 0; o < kBrickVoxels; ++o) {
      const IVec3 v = corner + IVec3(o & 7, o >> 3 & 7, o >> 6);
      if (is_gone(volume, v) && visit(v)) return;
    }
  }
}

/// Voxels of the tissue beside a voxel that is gone: visit(gone, bare), as above.
template <class Visit>
void each_bare(const Volume& volume, Tissue tissue, Visit&& visit) {
  each_gone(volume, [&](IVec3 v) {
    for (int axis = 0; axis < 3; ++axis)
      for (int step = -1; step <= 1; step += 2) {
        IVec3 next = v;
        next[axis] += step;
        if (volume.specimen().tissue(next) == tissue && volume.occupied(next) && visit(v, next)) return true;
      }
    return false;
  });
}

/// A place where the tissue borders on what was removed.
std::optional<Vec3> bare_place(const Volume& volume, Tissue tissue) {
  const Grid& grid = volume.grid();
  std::optional<Vec3> out;
  each_bare(volume, tissue, [&](IVec3 gone, IVec3 bare) {
    out = 0.5 * (grid.centre_mm(gone) + grid.centre_mm(bare));
    return true;
  });
  return out;
}

/// The cut surface that lies nearest to where the tissue stood that is gone.
std::vector<Triangle> nearest_to_gone(const Volume& volume, Tissue tissue) {
  std::vector<IVec3> gone;
  each_gone(volume, [&](IVec3 v) {
    if (volume.specimen().tissue(v) == tissue) gone.push_back(v);
    return false;
  });
  if (gone.empty()) return {};
  const VoxelIndex index(volume.grid(), std::move(gone));
  constexpr double kFurthestMm = 10.0;
  double least = kFurthestMm;
  const auto to_gone = [&](const Triangle& t) { return index.distance_mm(middle_of(t), kFurthestMm); };
  (void)cut_where(volume, [&](const Triangle& t, Tissue) { return (least = std::min(least, to_gone(t))) < 0.0; });
  return cut_where(volume, [&](const Triangle& t, Tissue) { return to_gone(t) <= least + volume.grid().voxel_mm; });
}

std::vector<Triangle> faces_in(const Volume& volume, Tissue tissue) {
  std::vector<Triangle> out = cut_where(volume, [tissue](const Triangle&, Tissue t) { return t == tissue; });
  return out.empty() ? nearest_to_gone(volume, tissue) : out;
}

Damaged damage_of_tissue(const Reference& reference, const Volume& volume, const RegionShares& sum, const ProtectedPart& part) {
  Damaged out{sum.tissue_mm3[index_of(part.tissue)], tissue_sigma_mm3(reference, sum, part.tissue), false, std::nullopt, {}, {}};
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

std::vector<Triangle> bare_faces(const Volume& volume, Tissue tissue) {
  std::vector<IVec3> bare;
  each_bare(volume, tissue, [&](IVec3, IVec3 v) {
    bare.push_back(v);
    return false;
  });
  const VoxelSet set(volume.grid(), bare);
  std::vector<Triangle> out = cut_where(volume, [&](const Triangle& t, Tissue of) { return of == tissue || set.has(voxel_under(volume, t)); });
  return out.empty() ? nearest_to_gone(volume, tissue) : out;
}

std::vector<Triangle> protected_faces(const Reference& reference, const Volume& volume, const RegionShares& sum, ProtectedMeasure measure) {
  std::vector<Triangle> out;
  for (const ProtectedPart& part : reference.protected_parts()) {
    std::vector<Triangle> faces;
    if (part.shape) {
      Damaged one = damage_of_region(reference, volume, part);
      faces = std::move(measure == ProtectedMeasure::removed ? one.removed_faces : one.damage_faces);
    } else if (measure == ProtectedMeasure::removed) {
      if (sum.tissue_mm3[index_of(part.tissue)] > 0.0) faces = faces_in(volume, part.tissue);
    } else if (damage_of_tissue(reference, volume, sum, part).damaged) {
      faces = part.severity == Damage::touch ? bare_faces(volume, part.tissue) : faces_in(volume, part.tissue);
    }
    out.insert(out.end(), faces.begin(), faces.end());
  }
  return out;
}

}  // namespace cusp::scenarios
