#include "scenarios/metrics/cut_faces.h"

#include <cmath>

#include "engine/volume/cell_field.h"
#include "engine/volume/cut_volume.h"
#include "scenarios/metrics/evidence.h"
#include "scenarios/metrics/region_shares.h"

namespace cusp::scenarios {

namespace {

class FaceSink final : public SolidSink {
 public:
  FaceSink(const Reference& reference, const Volume& volume, const std::optional<FloorDepth>& depth,
           std::array<std::vector<CutFace>, kFaceNames>& faces)
      : reference_(reference), volume_(volume), faces_(faces) {
    const double floor = depth ? reference.shape().top_mm() - depth->mean_mm : reference.shape().floor_mm();
    wall_from_mm_ = floor + reference.shape().corner_mm() + 0.5 * volume.grid().voxel_mm;
  }

  void cell(Vec3, Vec3) override {}
  void box(Vec3, Vec3, Tissue) override {}
  void tetrahedron(const std::array<Vec3, 4>&, double, Tissue) override {}
  void face(const std::array<Vec3, 3>& corners, double mm2, Tissue) override {
    const Vec3 cross = 0.5 * glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double area = std::sqrt(glm::dot(cross, cross));
    if (!(area > 0.0)) return;
    CutFace out{(corners[0] + corners[1] + corners[2]) / 3.0, cross * (mm2 / area), Vec3(0.0)};
    const FieldPoint cut = cells_.at(volume_, Field::cut, out.middle_mm);
    if (!cut.known) return;
    out.normal = cut.normal;
    if (glm::dot(cut.normal, out.area_mm2) < 0.0) out.area_mm2 = -out.area_mm2;
    if (const auto name = name_of(out, mm2)) faces_[static_cast<std::size_t>(*name)].push_back(out);
  }

 private:
  std::optional<FaceName> name_of(const CutFace& face, double mm2) const noexcept {
    const Vec3 n = face.area_mm2 / mm2;
    const TargetShape& shape = reference_.shape();
    const bool tree = shape.upright() == nullptr;
    const Near near = tree ? shape.near(face.middle_mm) : Near{};
    const double u = tree ? near.wall_mm : shape.outline_mm({face.middle_mm.x, face.middle_mm.y});
    if (n.z >= kFloorCosine) {
      // As floor_depth(): a quarter of a voxel more than the inset, so that a slot as wide as the bur keeps its floor.
      const double inset = reference_.shape().corner_mm() - 0.25 * volume_.grid().voxel_mm;
      return u <= -inset && (!tree || near.face == FaceName::pulpal_floor) ? std::optional(FaceName::pulpal_floor) : std::nullopt;
    }
    if (n.z <= -kFloorCosine || face.middle_mm.z < wall_from_mm_ || u > kWallReachMm) return std::nullopt;
    if (std::fabs(n.x) >= std::fabs(n.y)) {
      const double mesial = reference_.mesial_x() == 0 ? n.x : n.x * reference_.mesial_x();
      return mesial < 0.0 ? FaceName::mesial_wall : FaceName::distal_wall;
    }
    return n.y < 0.0 ? FaceName::buccal_wall : FaceName::lingual_wall;
  }

  const Reference& reference_;
  const Volume& volume_;
  std::array<std::vector<CutFace>, kFaceNames>& faces_;
  FieldCells cells_;
  double wall_from_mm_ = 0;
};

}  // namespace

CutFaces::CutFaces(const Reference& reference, const Volume& volume, const std::optional<FloorDepth>& depth)
    : sides_known_(reference.mesial_x() != 0) {
  if (reference.shape().empty() || volume.specimen().reading() == Reading::filled) return;
  FaceSink sink(reference, volume, depth, faces_);
  for (const int brick : bricks_to_measure(volume)) emit_removed(volume, brick, sink);
}

}  // namespace cusp::scenarios
