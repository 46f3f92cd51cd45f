// solve(): free space, the cavity, or planes. surface_follow.cpp has the searches by planes, surface_gather.cpp is the broad phase, surface_constraints.cpp and surface_planes.cpp build the
// constraints, plane_search.cpp solves them, surface_polish.cpp corrects on the fields, surface_free.cpp finds free space.
#include "engine/contact/surface_contact.h"

#include <algorithm>

namespace cusp::engine {

namespace {

/// Crossing cells within reach of the widest bur: the ball's own area twice over (two fields), and that of neck and shank, as
/// far as the specimen is long.
std::size_t candidate_room(const Scene& scene) {
  const double h = scene.specimen->grid().voxel_mm;
  const Vec3 size = Vec3(scene.specimen->brick_count() * kBrickEdge) * h;
  const double longest = length_of(size);
  double most = 0.0;
  for (const Bur& bur : scene.burs) {
    const double r = (bur.radius_mm + 0.6) / h;
    const double neck_mm2 = (bur.neck_radius_mm + 0.6) * bur.neck_length_mm;
    const double shank_mm2 = (bur.shank_radius_mm + 0.6) * std::min(bur.shank_length_mm, longest);
    const double shank = (neck_mm2 + shank_mm2) / (h * h);
    const double flank = bur.head.ball() ? 0.0 : 6.3 * r * (bur.head.high() - bur.head.low()) / h;
    most = std::max(most, 4.0 * 3.15 * r * r * 2.0 + 6.3 * shank * 1.5 + 3.0 * flank);
  }
  return std::clamp<std::size_t>(static_cast<std::size_t>(most) + 2048, 4096, 65536);
}

}  // namespace

SurfaceContact::SurfaceContact(const Scene& scene, const Volume& volume, const CutMemory& memory,
                               const Sweeps& sweeps)
    : voxel_mm_(scene.specimen->grid().voxel_mm),
      memory_(memory),
      candidates_(candidate_room(scene)),
      features_(candidates_.size()),
      point_lists_(candidates_.size() + 1),
      sources_(candidates_.size()),
      known_(candidates_.size()),
      faces_(candidates_.size()),
      broad_faces_(candidates_.size()),
      broad_edges_(candidates_.size()),
      broad_others_(candidates_.size()),
      place_x_(candidates_.size() + 7),
      place_y_(candidates_.size() + 7),
      place_z_(candidates_.size() + 7),
      planes_(candidates_.size()),
      origins_(candidates_.size()),
      near_(candidates_.size()),
      low_(candidates_.size()),
      cut_(volume),
      sweeps_(sweeps),
      walls_(volume, sweeps),
      scaled_(candidates_.size()),
      scale_(candidates_.size()) {
  const Specimen& specimen = volume.specimen();
  const IVec3 n = specimen.brick_count();
  boxes_.resize(static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z));
  bricks_low_ = n;
  bricks_high_ = IVec3(-1);
  for (int b = 0; b < static_cast<int>(boxes_.size()); ++b) {
    const BasePoints points = specimen.surface().in(b);
    PointsBox& box = boxes_[static_cast<std::size_t>(b)];
    for (int i = 0; i < points.count; ++i) {
      box.add({points.x[i], points.y[i], points.z[i]});
      box.edges = box.edges || points.normal[i].edge();
    }
    if (!volume.cuttable(b)) continue;
    bricks_low_ = glm::min(bricks_low_, specimen.brick_at(b));
    bricks_high_ = glm::max(bricks_high_, specimen.brick_at(b));
  }
}

void SurfaceContact::forget() noexcept {
  cut_.forget();
  walls_.forget();
  fields_.forget_cut();
  gathered_.valid = free_.valid = unresolved_far_.valid = false;
  shank_free_ = {};
  free_pause_ = 0;
}

bool SurfaceContact::of_shank(const Origin& origin) const noexcept {
  if (origin.kept >= 0) return kept_planes_[origin.kept].of_shank;
  return origin.candidate >= 0 && candidates_[static_cast<std::size_t>(origin.candidate)].kind == Kind::shank;
}

void SurfaceContact::relax_by_past(std::size_t from, std::size_t to) noexcept {
  // Neck and shank do not cut, so the head's past poses leave them no room.
  planes_.recede_to({past_.data(), static_cast<std::size_t>(past_count_)}, kMemorySlack, from, to,
                    [&](std::size_t i) { return !of_shank(origins_[i]); },
                    [&](std::size_t i) { origins_[i].relaxed = true; });
}

/// Poses near `at` where a head that is no ball has cut.
void SurfaceContact::find_past(const Tool& tool, Vec3 at) noexcept {
  past_count_ = tool.ball() ? 0 : memory_.near(at, {tool.index, tool.axis}, past_);
}

/// Solves planes_, starting from the last active set. If they are infeasible, relaxes them to y and solves again.
PlaneSearch SurfaceContact::search_planes(Vec3 y, Vec3 device, bool& infeasible) noexcept {
  PlaneSearch found = closest_point(device, planes_, kTolerance, {active_set_.plane, static_cast<std::size_t>(active_set_.count)});
  if (!found.feasible) {
    // Tangents of points contradict each other: constraints that y violates are relaxed to y.
    infeasible = true;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      const double at = glm::dot(planes_.n(i), y);
      if (at < planes_.c(i)) planes_.set_c(i, at);
    }
    found = closest_point(device, planes_, kTolerance, {});
  }
  active_set_.count = found.active;
  for (int a = 0; a < found.active; ++a) active_set_.plane[a] = found.index[a];
  return found;
}

/// Of the voxel half a voxel under a place of the surface.
Tissue SurfaceContact::tissue_under(const Volume& volume, Vec3 place, Vec3 outwards) const noexcept {
  const Vec3 under = (place - volume.grid().origin_mm) / voxel_mm_ - 0.5 * outwards;
  return volume.tissue(cell_of_voxels(under + 0.5));
}

/// What holds the bur: a candidate, a plane that an earlier pass has kept, or a wall of the cavity.
void SurfaceContact::note(const Volume& volume, const PlaneSearch& found, const Polished& polished, Contact& out) const noexcept {
  const PlaneSearch& held = polished.accepted ? polished.search : found;
  out.active = held.active;
  for (int a = 0; a < held.active; ++a) {
    const auto i = static_cast<std::size_t>(found.index[a]);
    const Origin origin = polished.accepted ? Origin{polished.candidate[a]} : origins_[i];
    out.normal[a] = polished.accepted ? polished.normal[a] : planes_.n(i);
    out.weight[a] = held.weight[a];
    out.of_shank[a] = of_shank(origin);
    if (origin.kept >= 0) {
      out.tissue[a] = kept_planes_[origin.kept].tissue;
    } else if (origin.candidate >= 0) {
      out.tissue[a] = candidates_[static_cast<std::size_t>(origin.candidate)].tissue;
    } else {
      const CavityConstraint& wall = walls_.constraints()[static_cast<std::size_t>(-1 - origin.candidate)];
      out.tissue[a] = tissue_under(volume, wall.foot, wall.n);
    }
  }
}

Contact SurfaceContact::solve(const Volume& volume, const Scene& scene, std::uint16_t bur_index, Vec3 axis,
                              Vec3 from, Vec3 device, Vec3 predicted, double reach_mm, double most_mm) noexcept {
  const Contact out = follow(volume, tool_of(scene.burs[bur_index], axis, bur_index), from, device, predicted, reach_mm, most_mm);
  // Known free space answers some ticks without a look at the cavity: what was found must not depend on that.
  if (out.active == 0) walls_.release();
  return out;
}

Contact SurfaceContact::follow(const Volume& volume, const Tool& tool, Vec3 from, Vec3 device, Vec3 predicted, double reach_mm,
                               double most_mm) noexcept {
  Contact out;
  out.pose_mm = device;
  if (free_.valid && free_.bur == tool.index && free_.axis == tool.axis && free_.contains(from)) {
    // Where it leaves the known free space there may be more.
    if (!free_.contains(device)) find_free(volume, tool, from);
    if (free_.valid && free_.contains(device)) {
      ++answered_free_;
      return out;
    }
  }
  overflow_ = false;
  const double step = std::min(kLongestStep, std::max(0.004, reach_mm));
  const bool swept = tool.ball() && sweeps_.size() > 0;
  if (swept && (solve_in_sweep(volume, tool, from, device, reach_mm, out) || near_cavity(volume, tool, from, step))) {
    if (!out.in_steps) out = solve_in_cavity(volume, tool, from, device, reach_mm);
  } else {
    out = solve_by_planes(volume, tool, from, device, predicted, step, most_mm);
    // No wall that balls have cut is known further off.
    if (swept && length_of(out.pose_mm - from) > step + kNearCavityMm) out = solve_in_cavity(volume, tool, from, device, reach_mm);
  }
  if (out.active > 0 || out.deferred || out.infeasible) return out;
  if (free_pause_ > 0)
    --free_pause_;
  else
    find_free(volume, tool, out.pose_mm);
  return out;
}

/// While it cuts, a head that is thinner by more than a ball would cut less.
SurfaceContact::Tool SurfaceContact::tool_of(const Bur& bur, Vec3 axis, std::uint16_t index) const noexcept {
  Tool tool{&bur, axis, index};
  if (!cut_.resolves()) tool.thin_cut = kClearanceMm;
  return tool;
}

bool SurfaceContact::fits(const Volume& volume, const Bur& bur, Vec3 axis, Vec3 pose) noexcept {
  const Tool tool{&bur, axis};
  if (inside_tissue(volume, pose)) return false;
  gathered_.valid = false;
  gather(volume, tool, pose, voxel_mm_);
  build_constraints(volume, tool, pose, voxel_mm_, pose, 0.0);
  gathered_.valid = false;
  if (tool.ball()) add_cavity(volume, tool, pose, 0.0);
  walls_.release();
  return planes_.size() == 0;
}

bool SurfaceContact::push_out(const Volume& volume, const Scene& scene, std::uint16_t bur, Vec3 axis, Vec3 pose, double thin_mm,
                              Vec3& out) noexcept {
  constexpr double kMost = 0.02, kBallMargin = 0.01, kFirst = 0.006;
  const bool ball = scene.burs[bur].head.ball();
  const Tool tool{&scene.burs[bur], axis, ball ? kNoBur : bur, thin_mm, thin_mm};
  if (ball) {
    count_ = 0;
    gathered_.valid = false;
    gather_head(volume, tool, pose, kMost + kBallMargin);
    for (std::size_t i = 0; i < count_; ++i)
      if (known_[i] == Known::unmade) make(volume, tool, i);
  }
  double within = kFirst;  // a head's constraints are built for this distance about y; a pose further off asks for all
  Vec3 y = pose;
  for (int pass = 0; pass < 8; ++pass) {
    planes_.clear();
    if (ball) {
      planes(tool, y, 0, count_, 0.1);
      add_cavity(volume, tool, y, kMost + kBallMargin);
    } else {
      gather(volume, tool, pose, 2.0 * within);
      add_head_constraints(volume, tool, pose, length_of(y - pose) + within, y, within);
    }
    const PlaneSearch found = closest_point(pose, planes_, kTolerance, {});
    if (!found.feasible || length_of(found.y - pose) > kMost) return false;
    const double moved = length_of(found.y - y);
    if (!ball && moved > within) {
      within = kMost;
      continue;
    }
    y = found.y;
    if (!refine_in_cavity(volume, tool, y, found, CavityWalls::Jump::replaces, CavityWalls::kMostSteps) && moved < 1e-6) break;
  }
  out = y;
  return true;
}

}  // namespace cusp::engine
