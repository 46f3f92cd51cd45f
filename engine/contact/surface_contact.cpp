// Planes from candidates, the search among them, and the polish; surface_gather.cpp finds the candidates.
#include "engine/contact/surface_contact.h"

#include <algorithm>
#include <cmath>


namespace cusp {

namespace {

double length_of(Vec3 v) noexcept { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

constexpr double kTolerance = 1e-7;         // mm: planes closer than a tenth of a nanometre count as met
constexpr double kLongestStep = 0.08;       // mm: one search looks no further
constexpr double kSameNormal = 0.9396926;   // cos 20 deg: planes of one smooth surface
constexpr double kTurned = 0.8480481;       // cos 32 deg: a normal that turns further belongs to something else
constexpr double kPlaneReach = 0.8;         // voxels from its point within which a plane stands for the surface
constexpr double kSlowStep = 0.016;          // mm in a tick (16 mm/s): below, what was gathered is kept ...
constexpr double kSlowMargin = 0.024;        // ... for as long as the burr stays this near to where it was
constexpr int kSearches = 16;               // steps of the proxy in a tick, the rest next tick
constexpr double kTogether = 2e-3;          // mm: slack that a polished pose may take from a plane it leaves out
constexpr double kMemorySlack = 5e-4;       // mm

/// Crossing cells within reach of the widest burr: the ball's own area twice over (two fields), and the shank's.
std::size_t candidate_room(const Scene& scene) {
  const double h = scene.specimen->grid().voxel_mm;
  double most = 0.0;
  for (const Burr& burr : scene.burrs) {
    const double r = (burr.radius_mm + 0.1) / h;
    const double shank = (burr.neck_radius_mm + 0.1) * burr.neck_length_mm / (h * h);
    most = std::max(most, 4.0 * 3.15 * r * r * 3.0 + 6.3 * shank * 1.5);
  }
  return std::clamp<std::size_t>(static_cast<std::size_t>(most) + 2048, 4096, 65536);
}

}  // namespace

SurfaceContact::SurfaceContact(const Scene& scene, const Volume& volume)
    : voxel_mm_(scene.specimen->grid().voxel_mm),
      candidates_(candidate_room(scene)),
      planes_(candidates_.size()),
      origins_(candidates_.size()),
      cut_(volume) {}

void SurfaceContact::planes(const Burr& burr, Vec3 axis, Vec3 y, double r_base, double r_cut,
                            double slack_mm) noexcept {
  plane_count_ = 0;
  const double lateral_most = kPlaneReach * voxel_mm_;
  for (std::size_t i = 0; i < count_; ++i) {
    const Candidate& c = candidates_[i];
    const double r = c.field == Field::base ? r_base : r_cut;
    Plane plane;
    bool trusted = false;
    if (c.kind == Kind::surface) {
      const Vec3 d = y - c.point;
      const double height = glm::dot(c.normal, d);
      const Vec3 lateral = d - c.normal * height;
      if (height > 0.0 && glm::dot(lateral, lateral) <= lateral_most * lateral_most &&
          !(c.near_other && c.other_d_mm + glm::dot(c.other_normal, lateral) > 0.0)) {
        plane.n = c.normal;
        plane.c = glm::dot(c.normal, c.point) + r;
        trusted = true;
      } else {
        const double distance = length_of(d);
        if (distance < 1e-9) continue;
        plane.n = d / distance;
        plane.c = glm::dot(plane.n, c.point) + r;
      }
    } else if (c.kind == Kind::edge) {
      double t = glm::dot(y - c.point, c.normal);
      const double half = 0.7 * voxel_mm_;
      t = t < -half ? -half : t > half ? half : t;
      const Vec3 on = c.point + c.normal * t;
      const Vec3 d = y - on;
      const double distance = length_of(d);
      if (distance < 1e-9) continue;
      plane.n = d / distance;
      plane.c = glm::dot(plane.n, on) + r;
    } else {
      // Neck and shank: capsules along the axis; the nearer of the two holds the point off.
      const double along = glm::dot(c.point - y, axis);
      bool any = false;
      double best = 0.0;
      for (int part = 0; part < 2; ++part) {
        const double from = part == 0 ? 0.0 : burr.neck_length_mm + burr.shank_radius_mm;
        const double to = part == 0 ? burr.neck_length_mm : burr.neck_length_mm + burr.shank_length_mm;
        const double radius = part == 0 ? burr.neck_radius_mm : burr.shank_radius_mm;
        const double t = along < from ? from : along > to ? to : along;
        const Vec3 d = y + axis * t - c.point;
        const double distance = length_of(d);
        if (distance < 1e-9) continue;
        const double gap = distance - radius;
        if (any && gap >= best) continue;
        any = true;
        best = gap;
        plane.n = d / distance;
        plane.c = glm::dot(plane.n, c.point - axis * t) + radius;
      }
      if (!any) continue;
    }
    if (glm::dot(plane.n, y) - plane.c > slack_mm) continue;
    plane.from = static_cast<std::int32_t>(i);
    planes_[plane_count_] = plane;
    origins_[plane_count_] = {static_cast<std::int32_t>(i), trusted, false};
    ++plane_count_;
  }
}

void SurfaceContact::relax_by_memory(const CutMemory& memory, Vec3 y, double radius) noexcept {
  std::array<Vec3, 24> past;
  const int n = memory.near(y, radius, past);
  if (n == 0) return;
  for (std::size_t i = 0; i < plane_count_; ++i) {
    Plane& plane = planes_[i];
    double least = plane.c;
    for (int m = 0; m < n; ++m) {
      const double reached = glm::dot(plane.n, past[static_cast<std::size_t>(m)]) - kMemorySlack;
      least = reached < least ? reached : least;
    }
    if (least < plane.c) {
      plane.c = least;
      origins_[i].relaxed = true;
    }
  }
}

SurfaceContact::Polished SurfaceContact::polish(const Volume& volume, Vec3 y, Vec3 device, const PlaneSearch& found,
                                                double r_base, double r_cut) const noexcept {
  Polished out;
  // Active planes of one smooth surface stand for one contact: their mean normal, corrected on the field itself.
  struct Group {
    Vec3 normal{0.0};
    double weight = 0.0, heaviest = -1.0;
    Field field = Field::base;
    std::int32_t candidate = 0;
  };
  Group group[3];
  int groups = 0;
  for (int a = 0; a < found.active; ++a) {
    const Origin& origin = origins_[static_cast<std::size_t>(found.index[a])];
    const Candidate& c = candidates_[static_cast<std::size_t>(origin.candidate)];
    if (!origin.trusted_plane || origin.relaxed || c.near_other) return out;
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
  for (int g = 0; g < groups; ++g) group[g].normal = group[g].normal / length_of(group[g].normal);

  // Wholly enclosed contact has no single foot to correct.
  int tight = 0;
  for (std::size_t i = 0; i < plane_count_; ++i) {
    if (glm::dot(planes_[i].n, found.y) - planes_[i].c > 0.003) continue;
    bool apart = true;
    for (int g = 0; g < groups; ++g) apart = apart && glm::dot(planes_[i].n, group[g].normal) < kSameNormal;
    if (apart && ++tight >= 4) return out;
  }

  Plane corrected[3];
  Vec3 at = found.y;
  PlaneSearch search = found;
  for (int pass = 0; pass < 4; ++pass) {
    for (int g = 0; g < groups; ++g) {
      const double r = group[g].field == Field::base ? r_base : r_cut;
      const Vec3 x = at - group[g].normal * r;
      const FieldPoint field = field_at(volume, group[g].field, x);
      if (!field.known || std::fabs(field.d_mm) > 0.3 * voxel_mm_ || glm::dot(field.normal, group[g].normal) < kTurned)
        return out;
      group[g].normal = field.normal;
      corrected[g].n = field.normal;
      corrected[g].c = glm::dot(field.normal, x - field.normal * field.d_mm) + r;
      corrected[g].from = group[g].candidate;
    }
    search = closest_point(device, {corrected, static_cast<std::size_t>(groups)}, kTolerance);
    if (!search.feasible) return out;
    const double moved = length_of(search.y - at);
    at = search.y;
    if (length_of(at - y) > kLongestStep + voxel_mm_ || length_of(at - found.y) > voxel_mm_) return out;
    if (moved < 1e-7) break;
  }
  // What the polish left out must still be clear of the ball.
  for (std::size_t i = 0; i < plane_count_; ++i) {
    const Candidate& c = candidates_[static_cast<std::size_t>(origins_[i].candidate)];
    if (c.kind != Kind::surface) {
      if (glm::dot(planes_[i].n, at) - planes_[i].c < -kTogether) return out;
      continue;
    }
    bool apart = true;
    for (int g = 0; g < groups; ++g)
      apart = apart && !(group[g].field == c.field && glm::dot(c.normal, group[g].normal) > kTurned);
    if (apart && glm::dot(planes_[i].n, at) - planes_[i].c < -kTogether) return out;
  }
  out.accepted = true;
  out.search = search;
  for (int a = 0; a < search.active; ++a) {
    out.normal[a] = corrected[search.index[a]].n;
    out.candidate[a] = corrected[search.index[a]].from;
  }
  return out;
}

void SurfaceContact::keep(const Volume& volume, const Scene& scene, const Kept& kept) noexcept {
  cut_.forget();
  kept_ = kept;
  if (!kept.valid) return;
  const Burr& burr = scene.burrs[kept.burr];
  gather(volume, burr, scene.tool_axis, kept.centre, burr.radius_mm + kept.margin_mm, kept.margin_mm, true);
  gathered_ = count_;
}

Contact SurfaceContact::solve(const Volume& volume, const Scene& scene, std::uint16_t burr_index, Vec3 axis,
                              Vec3 from, Vec3 device, double reach_mm, const CutMemory* memory) noexcept {
  const Burr& burr = scene.burrs[burr_index];
  Contact out;
  out.pose_mm = from;
  if (clear_path(volume, burr, axis, from, device)) {
    out.pose_mm = device;
    return out;
  }
  overflow_ = false;
  const double r_base = burr.radius_mm;
  const double r_cut = burr.radius_mm - kClearanceMm;
  double step = std::min(kLongestStep, std::max(0.004, reach_mm));
  Vec3 y = from;
  bool arrived = false;

  for (int search = 0; search < kSearches && !arrived; ++search) {
    const Vec3 centre = y;
    if (!(kept_.valid && kept_.burr == burr_index && length_of(y - kept_.centre) + step <= kept_.margin_mm)) {
      // A small step looks a little further than it must, so that the next ones find all they need.
      kept_ = {y, step < kSlowStep ? kSlowMargin : step, burr_index, true};
      gather(volume, burr, axis, y, burr.radius_mm + kept_.margin_mm, kept_.margin_mm, true);
      gathered_ = count_;
    }
    if (gathered_ == 0) {
      // Nothing near: free space, or deep in tissue where there is no surface to follow.
      const Vec3 x = (y - volume.grid().origin_mm) / voxel_mm_;
      const IVec3 v(static_cast<int>(std::floor(x.x + 0.5)), static_cast<int>(std::floor(x.y + 0.5)),
                    static_cast<int>(std::floor(x.z + 0.5)));
      if (volume.s(v) >= kHalf) {
        out.infeasible = true;
        break;
      }
    }
    bool left = false;  // the search ran out of what it gathered
    for (int pass = 0; pass < 8; ++pass) {
      count_ = gathered_;
      foot(volume, y, device, burr.radius_mm);
      planes(burr, axis, y, r_base, r_cut, 2.0 * step);
      if (memory) relax_by_memory(*memory, y, burr.radius_mm);
      const std::span<Plane> all(planes_.data(), plane_count_);
      PlaneSearch found = closest_point(device, all, kTolerance);
      if (!found.feasible) {
        // Tangents of points contradict each other: what the pose already stands in cannot be asked of it.
        out.infeasible = true;
        for (Plane& plane : all) plane.c = std::min(plane.c, glm::dot(plane.n, y));
        found = closest_point(device, all, kTolerance);
        if (!found.feasible) {
          arrived = true;
          break;
        }
      }
      Vec3 target = found.y;
      bool only_planes = true;
      for (int a = 0; a < found.active; ++a)
        only_planes = only_planes && origins_[static_cast<std::size_t>(found.index[a])].trusted_plane;
      const double whole = length_of(target - centre);
      const bool clipped = whole > step;
      Polished polished;
      if (clipped) {
        target = centre + (target - centre) * (step / whole);
      } else if (found.active > 0 && only_planes) {
        polished = polish(volume, y, device, found, r_base, r_cut);
        if (polished.accepted) target = polished.search.y;
      }
      const double moved = length_of(target - y);
      y = target;

      out.active = found.active;
      out.shank = false;
      for (int a = 0; a < found.active; ++a) {
        const Candidate& c = candidates_[static_cast<std::size_t>(origins_[static_cast<std::size_t>(found.index[a])].candidate)];
        out.normal[a] = planes_[static_cast<std::size_t>(found.index[a])].n;
        out.weight[a] = found.weight[a];
        out.tissue[a] = c.tissue;
        if (c.kind == Kind::shank) {
          out.shank = true;
          out.shank_normal = out.normal[a];
        }
      }
      if (polished.accepted) {
        out.active = polished.search.active;
        for (int a = 0; a < out.active; ++a) {
          out.normal[a] = polished.normal[a];
          out.weight[a] = polished.search.weight[a];
          out.tissue[a] = candidates_[static_cast<std::size_t>(polished.candidate[a])].tissue;
        }
      }
      if (clipped) {
        left = true;
        break;
      }
      if (polished.accepted && moved < 0.06) {
        arrived = true;
        break;
      }
      if (moved < 2e-6) {
        arrived = true;
        break;
      }
    }
    if (!left) arrived = true;
    step = kLongestStep;
  }
  out.pose_mm = y;
  out.deferred = !arrived;
  out.overflow = overflow_;
  return out;
}

bool SurfaceContact::fits(const Volume& volume, const Burr& burr, Vec3 axis, Vec3 pose) noexcept {
  if (clear_path(volume, burr, axis, pose, pose)) return true;
  const Vec3 x = (pose - volume.grid().origin_mm) / voxel_mm_;
  if (volume.s({static_cast<int>(std::floor(x.x + 0.5)), static_cast<int>(std::floor(x.y + 0.5)),
                static_cast<int>(std::floor(x.z + 0.5))}) >= kHalf)
    return false;
  kept_.valid = false;
  gather(volume, burr, axis, pose, burr.radius_mm + voxel_mm_, voxel_mm_, true);
  planes(burr, axis, pose, burr.radius_mm, burr.radius_mm - kClearanceMm, 0.0);
  return plane_count_ == 0;
}

bool SurfaceContact::push_out(const Volume& volume, Vec3 pose, double radius_mm, Vec3& out) noexcept {
  static const Burr none{};
  constexpr double kMost = 0.02;
  kept_.valid = false;
  gather(volume, none, Vec3(0.0, 0.0, 1.0), pose, radius_mm + kMost + 0.01, 0.0, false);
  Vec3 y = pose;
  for (int pass = 0; pass < 4; ++pass) {
    planes(none, Vec3(0.0, 0.0, 1.0), y, radius_mm, radius_mm, 0.1);
    const PlaneSearch found = closest_point(pose, {planes_.data(), plane_count_}, kTolerance);
    if (!found.feasible || length_of(found.y - pose) > kMost) return false;
    const double moved = length_of(found.y - y);
    y = found.y;
    if (moved < 1e-6) break;
  }
  out = y;
  return true;
}

}  // namespace cusp
