#include "scenarios/metrics/cut_faces.h"

#include <cmath>

#include "engine/volume/cell_field.h"
#include "engine/volume/cut_volume.h"
#include "scenarios/metrics/evidence.h"
#include "scenarios/metrics/region_shares.h"

namespace cusp::scenarios {

namespace {

/// Hands each triangle of the cut surface to take(), with its normal.
class FaceSink : public SolidSink {
 public:
  explicit FaceSink(const Volume& volume) : volume_(volume) {}
  void cell(Vec3, Vec3) override {}
  void box(Vec3, Vec3, Tissue) override {}
  void tetrahedron(const std::array<Vec3, 4>&, double, Tissue) override {}
  void face(const std::array<Vec3, 3>& corners, double mm2, Tissue) override {
    const Vec3 cross = 0.5 * glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double area = std::sqrt(glm::dot(cross, cross));
    if (!(area > 0.0)) return;
    CutFace out{(corners[0] + corners[1] + corners[2]) / 3.0, cross * (mm2 / area), Vec3(0.0), corners};
    const FieldPoint cut = cells_.at(volume_, Field::cut, out.middle_mm);
    if (!cut.known) return;
    out.normal = cut.normal;
    if (glm::dot(cut.normal, out.area_mm2) < 0.0) out.area_mm2 = -out.area_mm2;
    take(out, mm2);
  }

 protected:
  virtual void take(const CutFace& face, double mm2) = 0;
  const Volume& volume_;

 private:
  FieldCells cells_;
};

/// As floor_depth(): a quarter of a voxel more than the inset, so that a slot as wide as the bur keeps its floor.
double floor_inset_mm(const Reference& reference) noexcept {
  return reference.shape().corner_mm() - 0.25 * reference.specimen().grid().voxel_mm;
}

/// Of a lone upright outline, by normals.
class UprightFaces final : public FaceSink {
 public:
  UprightFaces(const Reference& reference, const Volume& volume, const std::optional<FloorDepth>& depth,
               std::array<std::vector<CutFace>, kFaceNames>& faces)
      : FaceSink(volume), reference_(reference), faces_(faces) {
    const double floor = depth ? reference.shape().top_mm() - depth->mean_mm : reference.shape().floor_mm();
    wall_from_mm_ = floor + reference.shape().corner_mm() + 0.5 * volume.grid().voxel_mm;
  }

 private:
  void take(const CutFace& face, double mm2) override {
    if (const auto name = name_of(face, mm2)) faces_[static_cast<std::size_t>(*name)].push_back(face);
  }
  std::optional<FaceName> name_of(const CutFace& face, double mm2) const noexcept {
    const Vec3 n = face.area_mm2 / mm2;
    const double u = reference_.shape().outline_mm({face.middle_mm.x, face.middle_mm.y});
    if (n.z >= kFloorCosine) return u <= -floor_inset_mm(reference_) ? std::optional(FaceName::pulpal_floor) : std::nullopt;
    if (n.z <= -kFloorCosine || face.middle_mm.z < wall_from_mm_ || u > kWallReachMm) return std::nullopt;
    return wall_by_normal(n, reference_.mesial_x());
  }

  const Reference& reference_;
  std::array<std::vector<CutFace>, kFaceNames>& faces_;
  double wall_from_mm_ = 0;
};

/// Of a tree, by the faces that they face. Walls wait until it is known how deep each floor was cut.
class TreeFaces final : public FaceSink {
 public:
  TreeFaces(const Reference& reference, const Volume& volume) : FaceSink(volume), reference_(reference) {}

  void divide(std::array<std::vector<CutFace>, kFaceNames>& faces, std::array<bool, kFaceNames>& side_known) const {
    const double above_floor = reference_.shape().corner_mm() + 0.5 * volume_.grid().voxel_mm;
    for (const Candidate& one : candidates_) {
      const auto floor = static_cast<std::size_t>(one.facing.floor);
      const double cut_beyond = floor_mm2_[floor] > 0.0 ? floor_sum_[floor] / floor_mm2_[floor] : 0.0;
      if (!is_floor(one.facing.face) && one.facing.floor_mm > cut_beyond - above_floor) continue;
      FaceName name = one.facing.face;
      const bool named = name != FaceName::side_wall;
      if (!named && reference_.mesial_x() != 0) name = wall_by_normal(one.face.normal, reference_.mesial_x());
      faces[static_cast<std::size_t>(name)].push_back(one.face);
      side_known[static_cast<std::size_t>(name)] = named || reference_.mesial_x() != 0;
    }
  }

 private:
  struct Candidate {
    CutFace face;
    Facing facing;
  };
  void take(const CutFace& face, double mm2) override {
    const std::optional<Facing> facing = reference_.shape().facing(face.middle_mm, face.area_mm2 / mm2);
    if (!facing || facing->beyond_mm > kWallReachMm || facing->beside_mm > kWallReachMm) return;
    if (is_floor(facing->face)) {
      if (facing->wall_mm > -floor_inset_mm(reference_) || !reference_.shape().bounded_by(*facing, face.middle_mm)) return;
      const auto floor = static_cast<std::size_t>(facing->face);
      floor_sum_[floor] += mm2 * facing->beyond_mm;
      floor_mm2_[floor] += mm2;
    }
    candidates_.push_back({face, *facing});
  }

  const Reference& reference_;
  std::vector<Candidate> candidates_;
  std::array<double, kFaceNames> floor_sum_{}, floor_mm2_{};  // mm3, mm2: how far beyond the target's floors the cut ones lie
};

}  // namespace

FaceName wall_by_normal(Vec3 into_void, int mesial_x) noexcept {
  if (std::fabs(into_void.x) >= std::fabs(into_void.y)) {
    const double mesial = mesial_x == 0 ? into_void.x : into_void.x * mesial_x;
    return mesial < 0.0 ? FaceName::mesial_wall : FaceName::distal_wall;
  }
  return into_void.y < 0.0 ? FaceName::buccal_wall : FaceName::lingual_wall;
}

CutFaces::CutFaces(const Reference& reference, const Volume& volume, const std::optional<FloorDepth>& depth) {
  if (reference.shape().empty() || volume.specimen().reading() == Reading::filled) return;
  const std::vector<int> bricks = bricks_to_measure(volume);
  if (reference.shape().upright() != nullptr) {
    side_known_.fill(reference.mesial_x() != 0);
    UprightFaces sink(reference, volume, depth, faces_);
    for (const int brick : bricks) emit_removed(volume, brick, sink);
    return;
  }
  TreeFaces sink(reference, volume);
  for (const int brick : bricks) emit_removed(volume, brick, sink);
  sink.divide(faces_, side_known_);
}

}  // namespace cusp::scenarios
