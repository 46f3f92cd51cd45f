#include "scenarios/metrics/cut_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "engine/volume/cell_field.h"
#include "engine/volume/cut_volume.h"
#include "scenarios/metrics/evidence.h"
#include "scenarios/metrics/region_shares.h"
#include "scenarios/teeth/two_threads.h"

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

using FacesByName = std::array<std::vector<CutFace>, kFaceNames>;

void append(const FacesByName& from, FacesByName& to) {
  for (std::size_t name = 0; name < kFaceNames; ++name) to[name].insert(to[name].end(), from[name].begin(), from[name].end());
}

/// Of a lone upright outline, by normals.
class UprightFaces final : public FaceSink {
 public:
  UprightFaces(const Reference& reference, const Volume& volume, const std::optional<FloorDepth>& depth)
      : FaceSink(volume), reference_(reference) {
    const double floor = depth ? reference.shape().top_mm() - depth->mean_mm : reference.shape().floor_mm();
    wall_from_mm_ = floor + reference.shape().corner_mm() + 0.5 * volume.grid().voxel_mm;
  }
  const FacesByName& faces() const noexcept { return faces_; }
  const FacesByName& feet() const noexcept { return feet_; }

 private:
  void take(const CutFace& face, double mm2) override {
    const auto name = name_of(face, mm2);
    if (!name) return;
    const bool foot = !is_floor(*name) && face.middle_mm.z < wall_from_mm_;
    (foot ? feet_ : faces_)[static_cast<std::size_t>(*name)].push_back(face);
  }
  std::optional<FaceName> name_of(const CutFace& face, double mm2) const noexcept {
    const Vec3 n = face.area_mm2 / mm2;
    const double u = reference_.shape().outline_mm({face.middle_mm.x, face.middle_mm.y});
    if (n.z >= kFloorCosine) return u <= -floor_inset_mm(reference_) ? std::optional(FaceName::pulpal_floor) : std::nullopt;
    if (n.z <= -kFloorCosine || u > kWallReachMm) return std::nullopt;
    return wall_by_normal(n, reference_.mesial_x());
  }

  const Reference& reference_;
  FacesByName faces_, feet_;
  double wall_from_mm_ = 0;
};

/// Of a tree, by the faces that they face.
class TreeFaces final : public FaceSink {
 public:
  struct Candidate {
    CutFace face;
    double mm2, beyond_mm, floor_mm;  // of Facing
    FaceName name, floor;
  };
  TreeFaces(const Reference& reference, const Volume& volume) : FaceSink(volume), reference_(reference) {}
  const std::vector<Candidate>& candidates() const noexcept { return candidates_; }

 private:
  void take(const CutFace& face, double mm2) override {
    const std::optional<Facing> facing = reference_.shape().facing(face.middle_mm, face.area_mm2 / mm2);
    if (!facing || facing->beyond_mm > reach_mm(facing->face) || facing->beside_mm > kWallReachMm) return;
    if (is_floor(facing->face) && (facing->wall_mm > -floor_inset_mm(reference_) || !reference_.shape().bounded_by(*facing, face.middle_mm))) return;
    candidates_.push_back({face, mm2, facing->beyond_mm, facing->floor_mm, facing->face, facing->floor});
  }

  const Reference& reference_;
  std::vector<Candidate> candidates_;
};

/// Parts of the cut surface in the order of their bricks, each a sink of its own: two threads fill them.
template <class Sink, class Make>
std::vector<std::unique_ptr<Sink>> sinks_of(const Volume& volume, Make make) {
  constexpr std::size_t kBricks = 16;  // of a part
  const std::vector<int> bricks = bricks_to_measure(volume);
  std::vector<std::unique_ptr<Sink>> out((bricks.size() + kBricks - 1) / kBricks);
  in_two_threads(static_cast<int>(out.size()), [&](int i) {
    auto& sink = out[static_cast<std::size_t>(i)] = make();
    const std::size_t first = static_cast<std::size_t>(i) * kBricks;
    for (std::size_t k = first; k < std::min(first + kBricks, bricks.size()); ++k) emit_removed(volume, bricks[k], *sink);
  });
  return out;
}

/// Divides candidates by name, once it is known how deep each floor was cut.
class TreeDivision {
 public:
  TreeDivision(const Reference& reference, double voxel_mm) : reference_(reference), above_floor_(reference.shape().corner_mm() + 0.5 * voxel_mm) {}
  void sum_floors(const std::vector<TreeFaces::Candidate>& candidates) {
    for (const TreeFaces::Candidate& one : candidates) {
      if (!is_floor(one.name)) continue;
      const auto floor = static_cast<std::size_t>(one.name);
      floor_sum_[floor] += one.mm2 * one.beyond_mm;
      floor_mm2_[floor] += one.mm2;
    }
  }
  /// A wall in the line angle beside the floor that was cut there, or below it.
  bool is_foot(const TreeFaces::Candidate& one) const noexcept {
    const auto floor = static_cast<std::size_t>(one.floor);
    const double cut_beyond = floor_mm2_[floor] > 0.0 ? floor_sum_[floor] / floor_mm2_[floor] : 0.0;
    return !is_floor(one.name) && one.floor_mm > cut_beyond - above_floor_;
  }
  FaceName name_of(const TreeFaces::Candidate& one) const noexcept {
    return one.name == FaceName::side_wall && reference_.mesial_x() != 0 ? wall_by_normal(one.face.normal, reference_.mesial_x()) : one.name;
  }
  bool knows_side(const TreeFaces::Candidate& one) const noexcept { return one.name != FaceName::side_wall || reference_.mesial_x() != 0; }

 private:
  const Reference& reference_;
  double above_floor_;
  std::array<double, kFaceNames> floor_sum_{}, floor_mm2_{};  // mm3, mm2: how far beyond the target's floors the cut ones lie
};

}  // namespace

double reach_mm(FaceName face) noexcept {
  if (is_floor(face)) return std::numeric_limits<double>::max();
  return face == FaceName::axial_wall ? kBoxReachMm : kWallReachMm;
}

FaceName wall_by_normal(Vec3 into_void, int mesial_x) noexcept {
  if (std::fabs(into_void.x) >= std::fabs(into_void.y)) {
    const double mesial = mesial_x == 0 ? into_void.x : into_void.x * mesial_x;
    return mesial < 0.0 ? FaceName::mesial_wall : FaceName::distal_wall;
  }
  return into_void.y < 0.0 ? FaceName::buccal_wall : FaceName::lingual_wall;
}

CutFaces::CutFaces(const Reference& reference, const Volume& volume, const std::optional<FloorDepth>& depth) {
  if (reference.shape().empty() || volume.specimen().reading() == Reading::filled) return;
  if (reference.shape().upright() != nullptr) {
    side_known_.fill(reference.mesial_x() != 0);
    for (const auto& sink : sinks_of<UprightFaces>(volume, [&] { return std::make_unique<UprightFaces>(reference, volume, depth); })) {
      append(sink->faces(), faces_);
      append(sink->feet(), feet_);
    }
    return;
  }
  auto sinks = sinks_of<TreeFaces>(volume, [&] { return std::make_unique<TreeFaces>(reference, volume); });
  TreeDivision division(reference, volume.grid().voxel_mm);
  for (const auto& sink : sinks) division.sum_floors(sink->candidates());
  std::array<std::size_t, kFaceNames> count{};
  for (const auto& sink : sinks)
    for (const TreeFaces::Candidate& one : sink->candidates())
      if (!division.is_foot(one)) ++count[static_cast<std::size_t>(division.name_of(one))];
  for (std::size_t name = 0; name < kFaceNames; ++name) faces_[name].reserve(count[name]);
  for (auto& sink : sinks) {
    for (const TreeFaces::Candidate& one : sink->candidates()) {
      const auto name = static_cast<std::size_t>(division.name_of(one));
      if (division.is_foot(one)) {
        feet_[name].push_back(one.face);
        continue;
      }
      faces_[name].push_back(one.face);
      side_known_[name] = division.knows_side(one);
    }
    sink.reset();
  }
}

}  // namespace cusp::scenarios
