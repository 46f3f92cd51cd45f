#include "scenarios/format/validate_region.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scenarios/format/keys.h"
#include "scenarios/format/landmark.h"
#include "scenarios/format/ranges.h"
#include "scenarios/teeth/landmarks.h"

namespace cusp::scenarios {
namespace {

/// Below this a shape is not resolved by the voxels (contact trials: a cut of the band is not distinct from its noise).
constexpr double kLeastFeatureVoxels = 2.5;
/// Two directions nearer than this (sine of their angle) make no box.
constexpr double kLeastSine = 0.01;

/// The rounding that an upright bur leaves between wall and floor: that of its tip, or none below a flat end.
double corner_of(const Bur& bur) noexcept {
  if (bur.head.ball()) return bur.radius_mm;
  const OutlinePiece& tip = bur.head.piece(0);
  if (tip.radius > 0.0 || bur.head.size() < 2) return tip.radius;
  return bur.head.piece(1).radius;
}

/// Whether a region ends on all sides but upwards, where an outline has no lid.
bool ends(const Region& region) {
  const auto part_ends = [](const Region& part) { return ends(part); };
  switch (region.kind) {
    case RegionKind::half_space: return false;
    case RegionKind::common: return std::ranges::any_of(region.parts, part_ends);
    case RegionKind::difference: return !region.parts.empty() && ends(region.parts.front());
    default: return std::ranges::all_of(region.parts, part_ends);
  }
}

class RegionChecks {
 public:
  RegionChecks(const Scenario& scenario, const SpecimenFacts* facts, std::vector<Finding>& out)
      : s_(scenario), facts_(facts), out_(out) {}

  void tree(const Region& region, const std::string& where) {
    if (region.kind == RegionKind::outline) {
      paths(region.outline, where);
      size(region.outline, where);
    } else if (!is_node(region.kind)) {
      leaf(region, where);
    }
    for (std::size_t i = 0; i < region.parts.size(); ++i) tree(region.parts[i], where + "/parts/" + std::to_string(i));
  }
  /// A lone outline: a part of a tree may be deeper than what is cut of it.
  void alone(const Outline& t, const std::string& where) {
    reach(t, where);
    if (facts_ != nullptr) within(t, *facts_, where);
  }
  void error(std::string path, std::string code, std::map<std::string, double> args = {}, std::string detail = {}) {
    out_.push_back({Severity::error, std::move(path), std::move(code), std::move(args), std::move(detail)});
  }

 private:
  void warn(std::string path, std::string code, std::map<std::string, double> args = {}, std::string detail = {}) {
    out_.push_back({Severity::warning, std::move(path), std::move(code), std::move(args), std::move(detail)});
  }
  void reach(const Outline& t, const std::string& where);
  void within(const Outline& t, const SpecimenFacts& f, const std::string& where);
  void paths(const Outline& t, const std::string& where);
  void size(const Outline& t, const std::string& where);
  void leaf(const Region& region, const std::string& where);
  void of_voxels(const Region& region, const std::string& where);

  const Scenario& s_;
  const SpecimenFacts* facts_;
  std::vector<Finding>& out_;
};

void RegionChecks::paths(const Outline& t, const std::string& where) {
  const bool box = t.shape == "box";
  const bool channel = t.shape == "channel";
  if (t.paths.empty()) return error(where + "/paths", "no_target");
  if ((box || channel) && t.paths.size() != 1)
    error(where + "/paths", "path_count", {{"value", static_cast<double>(t.paths.size())}, {"limit", 1}}, t.shape);
  const double floor = t.top_mm - t.depth_mm;
  for (std::size_t i = 0; i < t.paths.size(); ++i) {
    const std::string path = where + "/paths/" + std::to_string(i);
    const std::size_t points = t.paths[i].size();
    const std::size_t wanted = channel ? 2 : 1;  // an outline about one point is a disc
    if (points < wanted || ((box || channel) && points != wanted))
      error(path, "point_count", {{"value", static_cast<double>(points)}, {"limit", static_cast<double>(wanted)}}, t.shape);
    for (std::size_t k = 0; k < points; ++k)
      if (std::abs(t.paths[i][k].z - floor) > 1e-6)
        warn(path + "/" + std::to_string(k), "point_off_floor", {{"value", t.paths[i][k].z}, {"limit", floor}});
  }
}

void RegionChecks::size(const Outline& t, const std::string& where) {
  if (t.paths.empty()) return;
  const bool box = t.shape == "box";
  const double least = range_of("/target/width_mm")->least;
  if (box && (below(t.box_size_mm.x, least) || below(t.box_size_mm.y, least))) error(where + "/box_size_mm", "empty_target");
  const double narrow = box ? std::min(t.box_size_mm.x, t.box_size_mm.y) : t.width_mm;
  const std::string narrow_path = where + (box ? "/box_size_mm" : "/width_mm");
  const double resolved = kLeastFeatureVoxels * s_.specimen.voxel_mm;
  if (narrow > 0 && below(narrow, resolved)) warn(narrow_path, "feature_thin", {{"value", narrow}, {"limit", resolved}});
  if (below(t.depth_mm, resolved)) warn(where + "/depth_mm", "feature_thin", {{"value", t.depth_mm}, {"limit", resolved}});
  if (s_.instruments.empty()) return;
  const auto by_radius = [](const Bur& a, const Bur& b) { return a.radius_mm < b.radius_mm; };
  const Bur& smallest = *std::ranges::min_element(s_.instruments, by_radius);
  if (narrow > 0 && below(narrow, 2 * smallest.radius_mm))
    warn(narrow_path, "bur_wider_than_target", {{"value", 2 * smallest.radius_mm}, {"limit", narrow}}, smallest.name);
  const auto by_corner = [](const Bur& a, const Bur& b) { return corner_of(a) < corner_of(b); };
  const Bur& sharpest = *std::ranges::min_element(s_.instruments, by_corner);
  if (below(t.corner_radius_mm, corner_of(sharpest)))
    warn(where + "/corner_radius_mm", "corner_below_bur", {{"value", t.corner_radius_mm}, {"limit", corner_of(sharpest)}},
         sharpest.name);
}

void RegionChecks::leaf(const Region& r, const std::string& where) {
  const auto length = [](Vec3 v) { return std::sqrt(glm::dot(v, v)); };
  const RegionKind k = r.kind;
  if (is_of_voxels(k)) return of_voxels(r, where);
  const double least = range_of("/target/width_mm")->least;
  if (k == RegionKind::box || k == RegionKind::half_space) {
    if (!(length(r.z_axis) > 0.0)) return error(where + "/z_axis", "no_direction");
    if (k == RegionKind::box && !(length(glm::cross(r.x_axis, r.z_axis)) > kLeastSine * length(r.x_axis) * length(r.z_axis)))
      return error(where + "/x_axis", "no_direction");
  }
  const bool ends = k == RegionKind::cylinder || k == RegionKind::cone || k == RegionKind::capsule;
  if (ends && k != RegionKind::capsule && below(length(r.to_mm - r.from_mm), least)) error(where + "/to_mm", "empty_target");
  if ((ends || k == RegionKind::sphere) && below(2 * std::max(r.radius_mm, r.end_radius_mm), least))
    error(where + "/radius_mm", "empty_target");
}

/// Whether a bur gets to the floor: its shank does not cut, and goes in only where it is narrower than the outline.
void RegionChecks::reach(const Outline& t, const std::string& where) {
  const double narrow = t.shape == "box" ? std::min(t.box_size_mm.x, t.box_size_mm.y) : t.width_mm;
  double longest = 0;
  for (const Bur& bur : s_.instruments) {
    if (below(narrow, 2 * bur.radius_mm)) continue;
    if (!below(narrow, 2 * bur.shank_radius_mm)) return;
    longest = std::max(longest, bur.radius_mm + bur.neck_length_mm);  // the neck begins at the pivot
  }
  if (longest > 0 && below(longest, t.depth_mm)) warn(where + "/depth_mm", "bur_short", {{"value", longest}, {"limit", t.depth_mm}});
}

/// A tissue is one of the exercise's and occurs in the specimen; a lesion needs a grown tooth with one, not of plastic, or carious tissue.
void RegionChecks::of_voxels(const Region& r, const std::string& where) {
  const auto listed = [&](Tissue t) { return std::ranges::any_of(s_.tissues, [t](const ScenarioTissue& own) { return own.tissue == t; }); };
  const auto occurs = [&](Tissue t) { return facts_ == nullptr || std::ranges::find(facts_->tissues, t) != facts_->tissues.end(); };
  if (r.kind == RegionKind::tissue) {
    if (!listed(r.tissue) || !occurs(r.tissue))
      error(where + "/tissue", "target_tissue_missing", {}, std::string(key_of_scenario_tissue(r.tissue)));
    return;
  }
  const auto carious = [&](Tissue t) { return listed(t) && occurs(t); };
  const bool grown = s_.specimen.generator == "tooth";
  if (grown ? s_.specimen.lesions.empty() || s_.specimen.typodont : !carious(Tissue::carious_dentine) && !carious(Tissue::carious_enamel))
    error(where, "lesion_missing");
}

/// A lone outline lies within the specimen.
void RegionChecks::within(const Outline& t, const SpecimenFacts& f, const std::string& where) {
  const double floor = t.top_mm - t.depth_mm;
  if (below(floor, f.low_mm.z)) error(where + "/depth_mm", "target_outside", {{"value", floor}, {"limit", f.low_mm.z}});
  if (floor >= f.high_mm.z) error(where + "/depth_mm", "target_outside", {{"value", floor}, {"limit", f.high_mm.z}});
  const bool box = t.shape == "box";
  const Vec3 half = box ? Vec3(t.box_size_mm.x / 2, t.box_size_mm.y / 2, 0) : Vec3(t.width_mm / 2, t.width_mm / 2, 0);
  for (std::size_t i = 0; i < t.paths.size(); ++i)
    for (std::size_t k = 0; k < t.paths[i].size(); ++k)
      for (int axis = 0; axis < 2; ++axis) {
        const double low = t.paths[i][k][axis] - half[axis];
        const double high = t.paths[i][k][axis] + half[axis];
        if (!below(low, f.low_mm[axis]) && !below(f.high_mm[axis], high)) continue;
        const bool under = low < f.low_mm[axis];
        error(where + "/paths/" + std::to_string(i) + "/" + std::to_string(k), "target_outside",
              {{"value", under ? low : high}, {"limit", under ? f.low_mm[axis] : f.high_mm[axis]}});
        break;
      }
}

/// 1 where mesial lies along x in the specimen's frame, -1 where distal does, 0 where nobody knows.
int mesial_way(const SpecimenSource& specimen) {
  if (!specimen.generator.empty()) return mesial_x(specimen.grown_fdi());
  const bool turned = std::abs(turn_deg(specimen.landmarks).value_or(180.0)) > kMostTurnedDeg;
  return turned ? 0 : mesial_x(specimen.landmarks.fdi);
}

bool names_a_side(const Region& region) {
  const auto is_side = [](const auto& face) { return face.second == FaceName::mesial_wall || face.second == FaceName::distal_wall; };
  return std::ranges::any_of(region.faces, is_side) || std::ranges::any_of(region.parts, names_a_side);
}

/// How far the slot "x_high" of a leaf points along x: 1, -1, or 0 for a leaf that may face any side.
double way_of_high(const Region& leaf) {
  if (leaf.kind == RegionKind::outline) return 1.0;
  if (leaf.kind != RegionKind::box) return 0.0;
  const Vec3 x = leaf.x_axis, z = leaf.z_axis;
  if (2 * x.x * x.x <= glm::dot(x, x) || 2 * z.z * z.z <= glm::dot(z, z)) return 0.0;
  return x.x > 0 ? 1.0 : -1.0;
}

/// Pointer to a wall that stands on one side of the tooth and is named after the other; nullopt without one. The walls that a
/// difference takes from its first part face the other way, and none is searched.
std::optional<std::string> wall_of_other_side(const Region& region, int mesial, const std::string& where) {
  for (const auto& [slot, face] : region.faces) {
    const double named = face == FaceName::mesial_wall ? 1.0 : face == FaceName::distal_wall ? -1.0 : 0.0;
    const double stands = slot == "x_high" ? way_of_high(region) : slot == "x_low" ? -way_of_high(region) : 0.0;
    if (named * stands * mesial < 0.0) return where + "/faces/" + slot;
  }
  const std::size_t searched = region.kind == RegionKind::difference ? std::min<std::size_t>(1, region.parts.size()) : region.parts.size();
  for (std::size_t i = 0; i < searched; ++i)
    if (auto found = wall_of_other_side(region.parts[i], mesial, where + "/parts/" + std::to_string(i))) return found;
  return std::nullopt;
}

/// Of a file without a number or mesial axis nobody can compare them.
void check_sides(const Scenario& s, std::vector<Finding>& out) {
  if (!names_a_side(s.target)) return;
  const int way = mesial_way(s.specimen);
  if (way == 0 && s.specimen.generator.empty() && !turn_deg(s.specimen.landmarks))
    out.push_back({Severity::warning, "/specimen/landmarks", "sides_unknown", {}, {}});
  if (const auto wall = wall_of_other_side(s.target, way, "/target"))
    out.push_back({Severity::warning, *wall, "wall_of_other_side", {}, {}});
}

}  // namespace

void check_target(const Scenario& scenario, const SpecimenFacts* specimen, std::vector<Finding>& out) {
  RegionChecks checks(scenario, specimen, out);
  checks.tree(scenario.target, "/target");
  if (!ends(scenario.target)) checks.error("/target", "target_endless");
  check_sides(scenario, out);
  if (scenario.target.kind == RegionKind::outline) checks.alone(scenario.target.outline, "/target");
  for (std::size_t i = 0; i < scenario.protected_parts.size(); ++i)
    if (const auto& region = scenario.protected_parts[i].region) checks.tree(*region, "/protected/" + std::to_string(i) + "/region");
}

}  // namespace cusp::scenarios
