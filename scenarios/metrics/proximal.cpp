#include "scenarios/metrics/proximal.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "scenarios/metrics/surface_search.h"
#include "scenarios/teeth/own_tissues.h"

namespace cusp::scenarios {

namespace {

/// A neighbour's surface where it borders on air (measured: groups_test): a line towards its nearest voxel meets it aslant.
constexpr double kNeighbourVoxels = 0.3;
/// A margin faces a neighbour if its normal leans less than 60 degrees from mesial or distal.
constexpr double kProximalCosine = 0.5;
constexpr double kFurthestNeighbourMm = 5.0;
/// Along the way across a contact.
constexpr double kGapStepVoxels = 0.05;

TissueSet neighbours() noexcept {
  TissueSet out{};
  out[index_of(kNeighbourEnamel)] = out[index_of(kNeighbourDentine)] = true;
  return out;
}

/// Sides of the tooth by the sign of x: [0] below 0, [1] above.
std::size_t side_at(double x) noexcept { return x > 0.0 ? 1 : 0; }

/// A place of the tooth and how far it is from there to the neighbour.
struct Clear {
  Vec3 at_mm{0.0};
  double mm = 0;
  Vec3 neighbour_mm{0.0};  // of a clearance: its end
};

class Proximal {
 public:
  Proximal(const Reference& reference, const Volume& volume)
      : reference_(reference), volume_(volume), original_(volume, Solid::original), search_(volume, Solid::remaining),
        neighbours_(reference.specimen(), neighbours()) {
    find_contacts();
  }
  bool prepared(double x) const noexcept { return prepared_[side_at(x)]; }
  bool any_prepared() const noexcept { return prepared_[0] || prepared_[1]; }
  /// The least gap between the tooth that is left and a neighbour, on the prepared sides, and the tooth's last voxels
  /// before it where the contact is not open. Pre: any_prepared().
  MeasuredLength least_gap(double sigma_mm, std::vector<IVec3>& touching) {
    MeasuredLength out{kContactReachMm, sigma_mm, contact_};
    for (const IVec3 own : facing_) {
      const Vec3 at = volume_.grid().centre_mm(own);
      if (!prepared(at.x) || !volume_.occupied(own)) continue;
      const auto gap = gap_at(at, search_);
      const double off = gap ? glm::dot(gap->at_mm - at, gap->at_mm - at) : 0.0;
      if (gap && gap->mm < kOpenContactMm && off <= volume_.grid().voxel_mm * volume_.grid().voxel_mm) touching.push_back(own);
      if (gap && gap->mm < out.mm) out = {gap->mm, sigma_mm, gap->at_mm};
    }
    return out;
  }
  /// From a place of the margin to the neighbour as it stood; nullopt where the tooth itself stands between, or none is near.
  std::optional<Clear> clearance(Vec3 from) {
    const Grid& grid = volume_.grid();
    const double far = neighbours_.distance_mm(from, kFurthestNeighbourMm);
    if (far >= kFurthestNeighbourMm) return std::nullopt;
    const Vec3 way = towards(from, far);
    const double step = 0.25 * grid.voxel_mm;
    for (double mm = grid.voxel_mm; mm <= far + 2.0 * grid.voxel_mm; mm += step) {
      const Vec3 p = from + mm * way;
      if (!search_.inside(p)) continue;
      if (!is_neighbour(volume_.tissue(nearest_voxel(grid, p)))) return std::nullopt;
      return nearest_from(from, search_.between(p - grid.voxel_mm * way, p + 0.5 * grid.voxel_mm * way));
    }
    return to_cut_neighbour(from, way, far);
  }

 private:
  /// The same where nothing of the neighbour is left on the way: damage of the neighbour is no clearance.
  std::optional<Clear> to_cut_neighbour(Vec3 from, Vec3 way, double far) {
    const Grid& grid = volume_.grid();
    for (double mm = grid.voxel_mm; mm <= far + 2.0 * grid.voxel_mm; mm += 0.25 * grid.voxel_mm) {
      const Vec3 p = from + mm * way;
      if (original_.inside(p) && is_neighbour(volume_.tissue(nearest_voxel(grid, p))))
        return nearest_from(from, original_.between(p - grid.voxel_mm * way, p + 0.5 * grid.voxel_mm * way));
    }
    return std::nullopt;
  }
  void find_contacts() {
    const Specimen& specimen = reference_.specimen();
    const Grid& grid = specimen.grid();
    const int reach = static_cast<int>(std::ceil(kContactReachMm / grid.voxel_mm)) + 1;
    for (const IVec3 v : neighbours_.surface_voxels())
      for (int axis = 0; axis < 3; ++axis)
        for (int step = -reach; step <= reach; ++step) {
          IVec3 own = v;
          own[axis] += step;
          if (was_solid(specimen, own) && is_own_hard(specimen.tissue(own))) facing_.push_back(own);
        }
    const auto order = [](IVec3 v) { return std::array{v.z, v.y, v.x}; };
    std::ranges::sort(facing_, {}, order);
    facing_.erase(std::ranges::unique(facing_).begin(), facing_.end());
    double least = kOpenContactMm;
    for (const IVec3 own : facing_) {
      const Vec3 at = grid.centre_mm(own);
      if (reference_.shape().distance_mm(at) >= 0.0) continue;
      const std::optional<Clear> gap = gap_at(at, original_);
      if (!gap || gap->mm >= kOpenContactMm) continue;
      prepared_[side_at(at.x)] = true;
      if (gap->mm < least) contact_ = gap->at_mm;
      least = std::min(least, gap->mm);
    }
  }
  /// From a place in the tooth: how much air lies before the neighbour on the straight way there. nullopt where there is none near.
  std::optional<Clear> gap_at(Vec3 from, SurfaceSearch& search) {
    const Grid& grid = volume_.grid();
    const double far = neighbours_.distance_mm(from, 2.0 * kContactReachMm);
    const Vec3 way = towards(from, far);
    const double step = kGapStepVoxels * grid.voxel_mm;
    double air = 0.0, since_air = 0.0;
    for (double mm = 0.0; mm <= far + grid.voxel_mm; mm += step) {
      const Vec3 p = from + mm * way;
      if (search.distance(p) >= 0.0) {
        air += step;
        since_air = 0.0;
        continue;
      }
      if (is_neighbour(volume_.tissue(nearest_voxel(grid, p)))) return Clear{from + (mm - air) * way, air};
      // Where air ends, the nearest voxel may still be the tooth's own.
      if (since_air > grid.voxel_mm) air = 0.0;
      since_air += step;
    }
    return std::nullopt;
  }
  /// Distance to the surface about a place of it: the foot of a perpendicular, in a few steps along the surface. Gums lead from
  /// one tooth to the other: it ends where the surface is no longer the neighbour's.
  Clear nearest_from(Vec3 from, Vec3 on) noexcept {
    const auto length = [](Vec3 v) { return std::sqrt(glm::dot(v, v)); };
    Clear best{from, length(on - from), on};
    for (int pass = 0; pass < 6; ++pass) {
      const FieldPoint field = cells_.at(volume_, Field::base, on);
      if (!field.known) break;
      on -= field.d_mm * field.normal;
      const double within = 0.5 * volume_.grid().voxel_mm;
      if (!is_neighbour(volume_.tissue(nearest_voxel(volume_.grid(), on - within * field.normal)))) break;
      const bool met = std::fabs(field.d_mm) < 0.1 * volume_.grid().voxel_mm;
      if (const double mm = length(on - from); met && mm < best.mm) best = {from, mm, on};
      const Vec3 back = from - on;
      on += back - glm::dot(back, field.normal) * field.normal;
    }
    return best;
  }
  /// Direction to the nearest place of the nearest voxel: the distance's own slope.
  Vec3 towards(Vec3 p, double far) const noexcept {
    const double step = 0.5 * volume_.grid().voxel_mm;
    Vec3 slope(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 low = p, high = p;
      low[axis] -= step;
      high[axis] += step;
      slope[axis] = neighbours_.distance_mm(low, far + 1.0) - neighbours_.distance_mm(high, far + 1.0);
    }
    const double length = std::sqrt(glm::dot(slope, slope));
    return length > 0.0 ? slope / length : Vec3(0.0, 0.0, 1.0);
  }

  const Reference& reference_;
  const Volume& volume_;
  SurfaceSearch original_, search_;
  FieldCells cells_;
  VoxelIndex neighbours_;
  std::vector<IVec3> facing_;       // own voxels so near to a neighbour's that the contact may be there
  Vec3 contact_{0.0};               // where the target holds it
  std::array<bool, 2> prepared_{};  // [side]
};

std::optional<Clearance> least_of(const std::vector<Clear>& all, double low, double high, double sigma) {
  std::optional<Clearance> out;
  for (const Clear& one : all)
    if (one.at_mm.z >= low && one.at_mm.z <= high && (!out || one.mm < out->length.mm)) out = Clearance{{one.mm, sigma, one.at_mm}, one.neighbour_mm};
  return out;
}

std::array<std::optional<Clearance>, 3> by_height(const std::vector<Clear>& all, double sigma) {
  std::array<std::optional<Clearance>, 3> out;
  if (all.empty()) return out;
  const auto [low, high] = std::ranges::minmax_element(all, {}, [](const Clear& c) { return c.at_mm.z; });
  const double third = (high->at_mm.z - low->at_mm.z) / 3.0;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = least_of(all, low->at_mm.z + third * static_cast<double>(i), low->at_mm.z + third * static_cast<double>(i + 1), sigma);
  return out;
}

struct NamedMargin {
  MarginPoint point;
  FaceName face;
};

/// The margin's places on the target's faces.
std::vector<NamedMargin> named_margin(const std::vector<MarginPoint>& margin, const TargetShape& shape) {
  std::vector<NamedMargin> out;
  for (const MarginPoint& m : margin) {
    const std::optional<Facing> facing = shape.facing(m.at_mm, m.into_void);
    if (facing && facing->beside_mm <= kWallReachMm && facing->beyond_mm <= std::max(kBoxReachMm, reach_mm(facing->face))) out.push_back({m, facing->face});
  }
  return out;
}

/// In strips of a voxel, from the margin of the gingival floor to the mean place of the axial wall. An MOD has strips on either side.
std::optional<MeasuredLength> floor_mesiodistal(const CutFaces& faces, const std::vector<NamedMargin>& margin, const Reference& reference) {
  const std::vector<CutFace>& wall = faces.of(FaceName::axial_wall);
  if (wall.empty()) return std::nullopt;
  const double voxel = reference.specimen().grid().voxel_mm;
  const auto strip_of = [voxel](Vec3 p) { return std::pair(side_at(p.x), static_cast<int>(std::floor(p.y / voxel))); };
  struct Strip {
    double margin = 0, axial = 0, mm2 = 0;
    int points = 0;
  };
  std::map<std::pair<std::size_t, int>, Strip> strips;
  for (const CutFace& face : wall) {
    Strip& s = strips[strip_of(face.middle_mm)];
    const double mm2 = std::sqrt(glm::dot(face.area_mm2, face.area_mm2));
    s.axial += mm2 * face.middle_mm.x;
    s.mm2 += mm2;
  }
  Vec3 at(0.0);
  double low = 0, high = 0;
  bool any = false;
  for (const NamedMargin& m : margin) {
    const Vec3 p = m.point.at_mm;
    if (m.face != FaceName::gingival_floor) continue;
    low = any ? std::min(low, p.y) : p.y;
    high = any ? std::max(high, p.y) : p.y;
    any = true;
    at = p;
    Strip& s = strips[strip_of(p)];
    s.margin += p.x;
    ++s.points;
  }
  const double quarter = 0.25 * (high - low);
  double sum = 0;
  int count = 0;
  for (const auto& [key, s] : strips) {
    const double y = (key.second + 0.5) * voxel;
    if (s.points == 0 || !(s.mm2 > 0.0) || y < low + quarter || y > high - quarter) continue;
    sum += std::fabs(s.margin / s.points - s.axial / s.mm2);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return MeasuredLength{sum / count, std::sqrt(2.0) * reference.point_sigma_mm(), at};
}

}  // namespace

ProximalForm proximal_form(const CutFaces& faces, const std::vector<MarginPoint>& margin, const Reference& reference, const Volume& volume) {
  ProximalForm out;
  const std::vector<NamedMargin> named = named_margin(margin, reference.shape());
  out.floor_mesiodistal = floor_mesiodistal(faces, named, reference);
  if (!reference.is_grown() || volume.specimen().reading() == Reading::filled) return out;
  Proximal proximal(reference, volume);
  if (!proximal.any_prepared()) return out;
  const double border = kNeighbourVoxels * volume.grid().voxel_mm, place = std::sqrt(2.0) * reference.point_sigma_mm();
  const double sigma = std::sqrt(border * border + place * place);
  out.contact_gap = proximal.least_gap(sigma, out.touching);
  std::map<FaceName, std::vector<Clear>> clear;
  for (const auto& [m, face] : named) {
    if (!proximal.prepared(m.at_mm.x) || m.out.x * (m.at_mm.x > 0.0 ? 1.0 : -1.0) < kProximalCosine) continue;
    if (const auto found = proximal.clearance(m.at_mm)) clear[face].push_back(*found);
  }
  out.buccal = by_height(clear[FaceName::buccal_wall], sigma);
  out.lingual = by_height(clear[FaceName::lingual_wall], sigma);
  constexpr double kAnyHeight = 1e9;
  out.gingival = least_of(clear[FaceName::gingival_floor], -kAnyHeight, kAnyHeight, sigma);
  return out;
}

void add_proximal(const CutFaces& faces, const std::vector<MarginPoint>& margin, const Reference& reference, const Volume& volume,
                  std::vector<Measure>& out) {
  const ProximalForm form = proximal_form(faces, margin, reference, volume);
  if (const auto& gap = form.contact_gap) {
    const double unsure = std::fabs(gap->mm - kOpenContactMm) < gap->uncertainty_mm ? 1.0 : 0.0;
    out.push_back({"contact_broken", true, gap->mm >= kOpenContactMm ? 1.0 : 0.0, unsure, "", gap->at_mm});
  } else {
    out.push_back(not_measured("contact_broken", ""));
  }
  const auto add = [&](std::string key, const std::optional<MeasuredLength>& one) {
    if (one) out.push_back({std::move(key), true, one->mm, one->uncertainty_mm, "mm", one->at_mm});
    else out.push_back(not_measured(std::move(key), "mm"));
  };
  const auto length_of = [](const std::optional<Clearance>& one) { return one ? std::optional(one->length) : std::nullopt; };
  constexpr std::array<const char*, 3> kHeights = {"gingival", "middle", "occlusal"};
  for (std::size_t i = 0; i < 3; ++i) add(std::string("clearance_buccal_") + kHeights[i], length_of(form.buccal[i]));
  for (std::size_t i = 0; i < 3; ++i) add(std::string("clearance_lingual_") + kHeights[i], length_of(form.lingual[i]));
  add("clearance_gingival", length_of(form.gingival));
  add("gingival_floor_mesiodistal", form.floor_mesiodistal);
}

}  // namespace cusp::scenarios
