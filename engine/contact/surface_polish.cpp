// The polish: what one smooth surface holds is corrected on the field itself, by Newton.
#include <cmath>

#include "engine/contact/surface_contact.h"

namespace cusp::engine {

namespace {

constexpr double kSameNormal = 0.9396926;   // cos 20 deg: planes of one smooth surface
constexpr double kTurned = 0.8480481;       // cos 32 deg: a normal that turns further belongs to something else
constexpr double kFootReach = 1.2;          // voxels from its point within which a polished foot is that surface's
constexpr double kTogether = 2e-3;          // mm: slack that a polished pose may take from a plane it leaves out
constexpr double kPolishedMm = 1e-6;        // mm: a polish that would move less has arrived

}  // namespace

/// Of the head, thinned against a field: its place (from the pivot) that stands on a surface with this normal, about a point.
HeadFoot SurfaceContact::foot_of(const Tool& tool, Field field, Vec3 normal, Vec3 point, Vec3 pose) const noexcept {
  const double thin = tool.thin(field);
  if (tool.ball()) return {normal * -(tool.bur->radius_mm - thin), normal, true};
  ByHead place = by_axis(tool.axis, point - pose);
  HeadFoot foot = head_foot(*tool.bur, tool.axis, normal, point - pose, place, kPlaneReach * voxel_mm_);
  foot.at += foot.normal * thin;
  return foot;
}

/// Active planes of one smooth surface stand for one contact: their mean normal, corrected on the field itself.
struct SurfaceContact::Touching {
  struct Surface {
    Vec3 normal{0.0};
    double weight = 0.0, heaviest = -1.0;
    Field field = Field::base;
    std::int32_t candidate = 0;
    Vec3 point{0.0};  // of the candidate
  };
  Surface surface[3];
  Plane corrected[3];
  int count = 0;
};

/// False where another thing than a smooth surface holds the head.
bool SurfaceContact::group_surfaces(const PlaneSearch& found, Touching& t) const noexcept {
  for (int a = 0; a < found.active; ++a) {
    const Origin& origin = origins_[static_cast<std::size_t>(found.index[a])];
    const Candidate& c = candidates_[static_cast<std::size_t>(origin.candidate)];
    if (c.kind != Kind::surface || origin.relaxed || c.others > 0) return false;
    int g = 0;
    while (g < t.count && !(t.surface[g].field == c.field &&
                            glm::dot(candidates_[static_cast<std::size_t>(t.surface[g].candidate)].normal, c.normal) > kSameNormal))
      ++g;
    Touching::Surface& s = t.surface[g];
    if (g == t.count) {
      s.field = c.field;
      ++t.count;
    }
    const double w = found.weight[a] > 1e-12 ? found.weight[a] : 1e-12;
    s.normal += c.normal * w;
    s.weight += w;
    if (w <= s.heaviest) continue;
    s.heaviest = w;
    s.candidate = origin.candidate;
  }
  for (int g = 0; g < t.count; ++g) {
    Touching::Surface& s = t.surface[g];
    s.normal = s.normal / length_of(s.normal);
    s.point = candidates_[static_cast<std::size_t>(s.candidate)].point;
  }
  return true;
}

/// Wholly enclosed contact has no single foot to correct.
bool SurfaceContact::enclosed(const PlaneSearch& found, const Touching& t) const noexcept {
  int tight = 0;
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (planes_.slack(i, found.y) > 0.003) continue;
    bool apart = true;
    for (int g = 0; g < t.count; ++g) apart = apart && glm::dot(planes_.n(i), t.surface[g].normal) < kSameNormal;
    if (apart && ++tight >= 4) return true;
  }
  return false;
}

/// The planes of the surfaces under a head at `at`, from the fields. False where a field does not know its surface there.
bool SurfaceContact::correct(const Volume& volume, const Tool& tool, Vec3 at, Touching& t) noexcept {
  for (int g = 0; g < t.count; ++g) {
    Touching::Surface& s = t.surface[g];
    const HeadFoot foot = foot_of(tool, s.field, s.normal, s.point, at);
    const Vec3 x = at + foot.at;
    const FieldPoint field = fields_.at(volume, s.field, x);
    if (!field.known || (field.inner_edge && !tool.ball()) ||
        (field.creased && (all_resolved_ || s.field == Field::base)) || std::fabs(field.d_mm) > 0.3 * voxel_mm_ ||
        glm::dot(field.normal, s.normal) < kTurned)
      return false;
    s.normal = field.normal;
    Plane& plane = t.corrected[g];
    if (tool.ball()) {
      plane.n = field.normal;
      plane.c = glm::dot(field.normal, x - field.normal * field.d_mm) + (tool.bur->radius_mm - tool.thin(s.field));
    } else {
      plane.n = foot.deepest ? field.normal : foot.normal;
      plane.c = glm::dot(plane.n, at) - field.d_mm / glm::dot(field.normal, plane.n);
    }
  }
  return true;
}

/// True if each foot belongs to its surface, and what the polish left out is still clear of the head.
bool SurfaceContact::polish_holds(const Tool& tool, Vec3 at, const Touching& t) const noexcept {
  // The foot belongs to the cell that it came from (a wide ball's foot is nearer to it than its centre is beside it).
  for (int g = 0; g < t.count; ++g) {
    const Touching::Surface& s = t.surface[g];
    const Vec3 off = at + foot_of(tool, s.field, tool.ball() ? t.corrected[g].n : s.normal, s.point, at).at - s.point;
    if (glm::dot(off, off) > kFootReach * kFootReach * voxel_mm_ * voxel_mm_) return false;
  }
  // Of a ball, planes beside its foot stand for the same place.
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (planes_.slack(i, at) >= -kTogether) continue;
    const Candidate& c = candidates_[static_cast<std::size_t>(origins_[i].candidate)];
    bool same = false;
    for (int g = 0; g < t.count; ++g)
      same = same || (tool.ball() && c.kind == Kind::surface && t.surface[g].field == c.field &&
                      glm::dot(c.normal, t.surface[g].normal) > kTurned);
    if (!same) return false;
  }
  return true;
}

SurfaceContact::Polished SurfaceContact::polish(const Volume& volume, const Tool& tool, Vec3 y, Vec3 device,
                                                const PlaneSearch& found) noexcept {
  Polished out;
  Touching t;
  if (!group_surfaces(found, t) || enclosed(found, t)) return out;
  Vec3 at = found.y;
  PlaneSearch search = found;
  double before = 0.01;
  for (int pass = 0; pass < 5; ++pass) {
    if (!correct(volume, tool, at, t)) return out;
    search = closest_point(device, {t.corrected, static_cast<std::size_t>(t.count)}, kTolerance);
    if (!search.feasible) return out;
    const double moved = length_of(search.y - at);
    at = search.y;
    if (length_of(at - y) > kLongestStep + voxel_mm_ || length_of(at - found.y) > voxel_mm_) return out;
    // Each pass leaves the same share of the error before: the next one would move by moved^2 / before.
    if (moved * moved < kPolishedMm * before || moved < kPolishedMm) break;
    before = moved;
  }
  if (!polish_holds(tool, at, t)) return out;
  out.accepted = true;
  out.search = search;
  for (int a = 0; a < search.active; ++a) {
    out.normal[a] = t.corrected[search.index[a]].n;
    out.candidate[a] = t.surface[search.index[a]].candidate;
  }
  return out;
}

}  // namespace cusp::engine
