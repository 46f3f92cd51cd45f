#include "scenarios/metrics/evidence_patch.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "scenarios/format/keys.h"
#include "scenarios/metrics/depth.h"
#include "scenarios/metrics/patch_faces.h"
#include "scenarios/metrics/remaining.h"
#include "scenarios/metrics/width.h"
#include "scenarios/shapes/place.h"

namespace cusp::scenarios {

namespace {

/// Metrics, or beginnings of them that end in '_', and the faces that they are about.
struct OfFaces {
  std::string_view metric;
  std::array<FaceName, 2> faces;
};
constexpr std::array kOfFaces = {
    OfFaces{"wall_angle_mesial", {FaceName::mesial_wall, FaceName::mesial_wall}},
    OfFaces{"wall_angle_distal", {FaceName::distal_wall, FaceName::distal_wall}},
    OfFaces{"wall_angle_buccal", {FaceName::buccal_wall, FaceName::buccal_wall}},
    OfFaces{"wall_angle_lingual", {FaceName::lingual_wall, FaceName::lingual_wall}},
    OfFaces{"convergence_mesiodistal", {FaceName::mesial_wall, FaceName::distal_wall}},
    OfFaces{"convergence_buccolingual", {FaceName::buccal_wall, FaceName::lingual_wall}},
    OfFaces{"floor_", {FaceName::pulpal_floor, FaceName::pulpal_floor}},
    OfFaces{"depth_", {FaceName::pulpal_floor, FaceName::pulpal_floor}},
    OfFaces{"gingival_above_cej", {FaceName::gingival_floor, FaceName::gingival_floor}},
    OfFaces{"gingival_floor_mesiodistal", {FaceName::gingival_floor, FaceName::gingival_floor}},
    OfFaces{"box_height", {FaceName::gingival_floor, FaceName::pulpal_floor}},
    OfFaces{"axial_past_junction_", {FaceName::axial_wall, FaceName::axial_wall}}};

bool is_meant(std::string_view metric, std::string_view row) noexcept { return row.ends_with('_') ? metric.starts_with(row) : metric == row; }

/// "overcut_beyond_floor", "overcut_leeway_axial_wall": whether a place beside the target is in that zone, off that face.
bool is_overcut(std::string_view metric, const Near& near, const Leeway& leeway) noexcept {
  constexpr std::string_view kLeeway = "overcut_leeway_", kBeyond = "overcut_beyond_";
  const bool tolerated = metric.starts_with(kLeeway);
  const Place place = place_of(near, leeway);
  if (place == Place::target) return false;
  const bool is_tolerated = place == Place::tolerated_floor || place == Place::tolerated_side;
  if (tolerated != is_tolerated) return false;
  const std::string_view face = metric.substr(tolerated ? kLeeway.size() : kBeyond.size());
  if (face == "floor") return place == Place::tolerated_floor || place == Place::beyond_floor;
  if (face == "side") return place == Place::tolerated_side || place == Place::beyond_side;
  return key_of(near.face) == face;
}

/// The limit of "surface_within_200", mm; kOffMm of the other measures of the surface.
double limit_mm(std::string_view metric) noexcept {
  constexpr std::string_view kWithin = "surface_within_";
  int micrometres = 0;
  if (!metric.starts_with(kWithin)) return EvidencePatches::kOffMm;
  const auto [end, error] = std::from_chars(metric.data() + kWithin.size(), metric.data() + metric.size(), micrometres);
  return error == std::errc() ? micrometres / 1000.0 : EvidencePatches::kOffMm;
}

}  // namespace

EvidencePatches::EvidencePatches(std::shared_ptr<const Reference> reference, std::shared_ptr<const Volume> volume)
    : reference_(std::move(reference)), volume_(std::move(volume)), faces_(*reference_, *volume_, floor_depth(*reference_, *volume_)),
      margin_(margin_points(*volume_)), tissues_(std::make_shared<TissuePatches>(reference_, volume_)) {
  for (const SeveralTargets::One& one : reference_->targets().asked())
    targets_.try_emplace(one.name, one.reference, std::make_shared<const Volume>(reference_->targets().cavity(*volume_, one)));
}

EvidencePatch EvidencePatches::of(std::string_view key) const {
  const auto [metric, target] = split_metric(key);
  if (!target.empty()) {
    const auto own = targets_.find(target);
    return own == targets_.end() ? EvidencePatch{} : own->second.of(metric);
  }
  if (TissuePatches::has(metric)) return tissues_->of(metric, faces_, margin_);
  if (reference_->shape().empty()) return {};
  EvidencePatch out = faces_of(metric);
  if (out.empty()) out = lines_of(metric);
  if (out.empty()) out = surface_of(metric);
  return out;
}

EvidencePatch EvidencePatches::faces_of(std::string_view metric) const {
  EvidencePatch out;
  const auto row = std::ranges::find_if(kOfFaces, [metric](const OfFaces& one) { return is_meant(metric, one.metric); });
  if (row == kOfFaces.end()) return out;
  for (std::size_t i = 0; i < (row->faces[0] == row->faces[1] ? 1u : 2u); ++i)
    for (const CutFace& face : faces_.of(row->faces[i])) out.triangles.push_back(face.corners_mm);
  return out;
}

EvidencePatch EvidencePatches::lines_of(std::string_view metric) const {
  EvidencePatch out;
  if (metric == "isthmus_width") {
    if (const auto narrow = isthmus(margin_, *reference_)) out.lines.push_back({narrow->from_mm, narrow->to_mm});
  } else if (metric == "ridge_mesial" || metric == "ridge_distal") {
    const FaceName wall = metric == "ridge_mesial" ? FaceName::mesial_wall : FaceName::distal_wall;
    if (const auto ridge = ridge_thickness(faces_, *reference_, *volume_, wall)) out.lines.push_back({ridge->wall_at_mm, ridge->contour_at_mm});
  } else if (metric.starts_with("cavosurface_")) {
    for (const MarginPoint& m : margin_) {
      if (!m.angle_deg || (*m.angle_deg >= kLeastCavosurfaceDeg && *m.angle_deg <= kMostCavosurfaceDeg)) continue;
      const Vec3 along = glm::cross(m.out, m.into_void);
      const double length = glm::length(along), half = 0.5 * volume_->grid().voxel_mm;
      if (length > 0.0) out.lines.push_back({m.at_mm - half / length * along, m.at_mm + half / length * along});
    }
  }
  return out;
}

EvidencePatch EvidencePatches::surface_of(std::string_view metric) const {
  const TargetShape& shape = reference_->shape();
  EvidencePatch out;
  if (metric.starts_with("overcut_")) {
    const double outside = reference_->point_sigma_mm();  // a face on the target's own surface is no over-cut
    out.triangles = cut_where(*volume_, [&](const Triangle& t, Tissue) {
      const Near near = shape.near(middle_of(t));
      return near.distance_mm > outside && is_overcut(metric, near, reference_->leeway());
    });
  } else if (metric.starts_with("surface_")) {
    const double limit = limit_mm(metric);
    out.triangles = cut_where(*volume_, [&](const Triangle& t, Tissue) { return std::fabs(shape.distance_mm(middle_of(t))) > limit; });
  } else if (metric == "target_removed" || metric == "uncut_remainder") {
    const double inside = -reference_->point_sigma_mm();
    const auto stands = [&](const Triangle& t, Tissue) { return shape.distance_mm(middle_of(t)) < inside; };
    out.triangles = cut_where(*volume_, stands);
    std::ranges::copy(standing_where(*volume_, stands), std::back_inserter(out.triangles));
  } else if (metric == "remaining_over_pulp" && !reference_->pulp().empty()) {
    constexpr double kFurthestMm = 10.0;  // no crown has more dentine over its pulp
    const auto to_pulp = [&](const Triangle& t) { return reference_->pulp().distance_mm(middle_of(t), kFurthestMm); };
    double least = kFurthestMm;
    (void)cut_where(*volume_, [&](const Triangle& t, Tissue) { return (least = std::min(least, to_pulp(t))) < 0.0; });
    if (least < kFurthestMm) out.triangles = cut_where(*volume_, [&](const Triangle& t, Tissue) { return to_pulp(t) < least + kThinMm; });
  }
  return out;
}

}  // namespace cusp::scenarios
