// The polish: what one smooth surface holds is corrected on the field itself, by Newton.
#include <cmath>

#include "engine/contact/surface_contact.h"

namespace cusp::engine {

namespace {

double length_of(Vec3 v) noexcept { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

constexpr double kSameNormal = 0.9396926;   // cos 20 deg: planes of one smooth surface
constexpr double kTurned = 0.8480481;       // cos 32 deg: a normal that turns further belongs to something else
constexpr double kFootReach = 1.2;          // voxels from its point within which a polished foot is that surface's
constexpr double kTogether = 2e-3;          // mm: slack that a polished pose may take from a plane it leaves out
constexpr double kPolishedMm = 1e-6;        // mm: a polish that would move less has arrived

}  // namespace

/// Of the head, thinned against a field: its place (from the pivot) that stands on a surface with this normal, about a point.
SurfaceContact::HeadFoot SurfaceContact::foot_of(const Tool& tool, Field field, Vec3 normal, Vec3 point, Vec3 pose) const noexcept {
  const double thin = tool.thin(field);
  if (tool.ball()) return {normal * -(tool.bur->radius_mm - thin), normal, true};
  const double beside = kPlaneReach * voxel_mm_;
  HeadFoot foot = head_foot(tool, normal, point - pose, beside * beside);
  foot.at += foot.normal * thin;
  return foot;
}

SurfaceContact::Polished SurfaceContact::polish(const Volume& volume, const Tool& tool, Vec3 y, Vec3 device,
                                                const PlaneSearch& found) noexcept {
  Polished out;
  // Active planes of one smooth surface stand for one contact: their mean normal, corrected on the field itself.
  struct Group {
    Vec3 normal{0.0};
    double weight = 0.0, heaviest = -1.0;
    Field field = Field::base;
    std::int32_t candidate = 0;
    Vec3 point{0.0};  // of the candidate
  };
  Group group[3];
  int groups = 0;
  for (int a = 0; a < found.active; ++a) {
    const Origin& origin = origins_[static_cast<std::size_t>(found.index[a])];
    const Candidate& c = candidates_[static_cast<std::size_t>(origin.candidate)];
    if (c.kind != Kind::surface || origin.relaxed || c.others > 0) return out;
    int g = 0;
    while (g < groups && !(group[g].field == c.field && glm::dot(candidates_[static_cast<std::size_t>(group[g].candidate)].normal, c.normal) > kSameNormal)) ++g;
    if (g == groups) {
      group[groups] = Group{};
      group[groups].field = c.field;
      ++groups;
    }
    const double w = found.weight[a] > 1e-12 ? found.weight[a] : 1e-12;
    group[g].normal += c.normal * w;
    group[g].weight += w;
    if (w > group[g].heaviest) {
      group[g].heaviest = w;
      group[g].candidate = origin.candidate;
    }
  }
  for (int g = 0; g < groups; ++g) {
    group[g].normal = group[g].normal / length_of(group[g].normal);
    group[g].point = candidates_[static_cast<std::size_t>(group[g].candidate)].point;
  }

  // Wholly enclosed contact has no single foot to correct.
  int tight = 0;
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (planes_.slack(i, found.y) > 0.003) continue;
    bool apart = true;
    for (int g = 0; g < groups; ++g) apart = apart && glm::dot(planes_.n(i), group[g].normal) < kSameNormal;
    if (apart && ++tight >= 4) return out;
  }

  Plane corrected[3];
  Vec3 at = found.y;
  PlaneSearch search = found;
  double before = 0.01;
  for (int pass = 0; pass < 5; ++pass) {
    for (int g = 0; g < groups; ++g) {
      const HeadFoot foot = foot_of(tool, group[g].field, group[g].normal, group[g].point, at);
      const Vec3 x = at + foot.at;
      const FieldPoint field = fields_.at(volume, group[g].field, x);
      if (!field.known || (field.creased && (all_resolved_ || group[g].field == Field::base)) || std::fabs(field.d_mm) > 0.3 * voxel_mm_ || glm::dot(field.normal, group[g].normal) < kTurned)
        return out;
      group[g].normal = field.normal;
      if (tool.ball()) {
        corrected[g].n = field.normal;
        corrected[g].c = glm::dot(field.normal, x - field.normal * field.d_mm) + (tool.bur->radius_mm - tool.thin(group[g].field));
      } else {
        corrected[g].n = foot.deepest ? field.normal : foot.normal;
        corrected[g].c = glm::dot(corrected[g].n, at) - field.d_mm / glm::dot(field.normal, corrected[g].n);
      }
      corrected[g].from = group[g].candidate;
    }
    search = closest_point(device, {corrected, static_cast<std::size_t>(groups)}, kTolerance);
    if (!search.feasible) return out;
    const double moved = length_of(search.y - at);
    at = search.y;
    if (length_of(at - y) > kLongestStep + voxel_mm_ || length_of(at - found.y) > voxel_mm_) return out;
    // Each pass leaves the same share of the error before: the next one would move by moved^2 / before.
    if (moved * moved < kPolishedMm * before || moved < kPolishedMm) break;
    before = moved;
  }
  // The foot belongs to the cell that it came from (a wide ball's foot is nearer to it than its centre is beside it).
  for (int g = 0; g < groups; ++g) {
    const Vec3 off = at + foot_of(tool, group[g].field, tool.ball() ? corrected[g].n : group[g].normal, group[g].point, at).at - group[g].point;
    if (glm::dot(off, off) > kFootReach * kFootReach * voxel_mm_ * voxel_mm_) return out;
  }
  // What the polish left out must still be clear of the head; of a ball, planes beside its foot stand for the same place.
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (planes_.slack(i, at) >= -kTogether) continue;
    const Candidate& c = candidates_[static_cast<std::size_t>(origins_[i].candidate)];
    bool same = false;
    for (int g = 0; g < groups; ++g)
      same = same || (tool.ball() && c.kind == Kind::surface && group[g].field == c.field &&
                      glm::dot(c.normal, group[g].normal) > kTurned);
    if (!same) return out;
  }
  out.accepted = true;
  out.search = search;
  for (int a = 0; a < search.active; ++a) {
    out.normal[a] = corrected[search.index[a]].n;
    out.candidate[a] = corrected[search.index[a]].from;
  }
  return out;
}

}  // namespace cusp::engine
