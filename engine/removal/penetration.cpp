#include "engine/removal/penetration.h"

#include <array>
#include <cmath>
#include <utility>

#include "engine/tool/swept.h"
#include "engine/volume/cell_field.h"
#include "engine/volume/surface_cells.h"

namespace cusp::engine {

namespace {

/// The first step on the ball's surface, and from a place that is near a crest; halved to 6 um.
constexpr double kFirstMm = 0.05, kBesideMm = 0.0125, kLastMm = 0.006;
constexpr double kBesideReachMm = 0.06;
constexpr int kMostSteps = 64;
/// Then along the crest of what the nearest strokes leave: no further than kCrestMm from those strokes.
constexpr double kGainMm = 0.004;     // that the crest is deeper than where steps to four sides end: measured 1.4 um at most
constexpr double kCrestMm = 0.02, kCrestFirstMm = 0.008, kCrestLastMm = 1e-4, kCrestLeastMm = 0.002;
constexpr int kCrestStrokes = 64, kCrestSteps = 32;
constexpr int kMostEvaluations = 30000;     // distances to strokes, some 4 ns each: then where it has come to is deep enough
constexpr double kUnknown = 0.02;      // voxels that a sample may be deeper in the cut than the strokes say

}  // namespace

double PenetrationSearch::Taken::off(Vec3 place) const noexcept {
  const Vec3 from_axis = off_axis(place);
  return std::sqrt(glm::dot(from_axis, from_axis)) - radius_mm;
}

/// What lies beside a place of the ball's surface: strokes, and the face they were cut into.
struct PenetrationSearch::Crest {
  std::array<const Taken*, kCrestStrokes> stroke;
  int strokes = 0;
  Vec3 face_normal{0.0};
  double face_level = 0.0;  // of the face: its normal times a place of it

  /// How deep a place lies in what each of them left, the least of that, and the way off each.
  struct Depths {
    std::array<double, kCrestStrokes + 1> depth, away;
    std::array<Vec3, kCrestStrokes + 1> off;
    double least = 1e300;
    std::size_t lowest = 0;
  };
  void evaluate(Vec3 x, Depths& out) const noexcept {
    const auto last = static_cast<std::size_t>(strokes);
    for (std::size_t k = 0; k < last; ++k) {
      out.off[k] = stroke[k]->off_axis(x);
      out.away[k] = std::sqrt(glm::dot(out.off[k], out.off[k]));
      out.depth[k] = out.away[k] - stroke[k]->radius_mm;
    }
    out.depth[last] = face_level - glm::dot(face_normal, x);
    out.off[last] = -face_normal;
    out.away[last] = 1.0;
    out.least = out.depth[last];
    out.lowest = last;
    for (std::size_t k = 0; k < last; ++k)
      if (out.depth[k] < out.least) {
        out.least = out.depth[k];
        out.lowest = k;
      }
  }
  /// The way on the ball about u along which the depth in all that bind within `slack` grows: the shortest mean of their
  /// slopes, by turning to the one that grows least.
  /// along: across the two that are most against each other, where there are such.
  Vec3 uphill(const Depths& seen, Vec3 u, double slack, Vec3& along_crest) const noexcept {
    constexpr int kBinding = 12, kTurns = 8;
    std::array<Vec3, kBinding> slope;
    int binding = 0;
    const auto take = [&](std::size_t k) {
      const Vec3 off = seen.off[k] / (seen.away[k] > 1e-12 ? seen.away[k] : 1e-12);
      slope[static_cast<std::size_t>(binding++)] = off - u * glm::dot(u, off);
    };
    take(seen.lowest);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(strokes) && binding < kBinding; ++k)
      if (k != seen.lowest && seen.depth[k] <= seen.least + slack) take(k);
    Vec3 way = slope[0], against = slope[0];
    double most_against = 1.0;
    for (int i = 1; i < binding; ++i) {
      const double cosine = glm::dot(slope[static_cast<std::size_t>(i)], slope[0]);
      if (cosine >= most_against) continue;
      most_against = cosine;
      against = slope[static_cast<std::size_t>(i)];
    }
    for (int turn = 0; turn < kTurns; ++turn) {
      double least = 1e300;
      Vec3 worst(0.0);
      for (int i = 0; i < binding; ++i) {
        const double along = glm::dot(slope[static_cast<std::size_t>(i)], way);
        if (along >= least) continue;
        least = along;
        worst = slope[static_cast<std::size_t>(i)];
      }
      const double square = glm::dot(way, way);
      if (least > square - 1e-4 || square < 1e-8) break;
      const Vec3 to = worst - way;
      const double part = -glm::dot(way, to) / glm::dot(to, to);
      way += to * (part > 1.0 ? 1.0 : part);
    }
    const Vec3 apart = slope[0] - against;
    const double square = glm::dot(apart, apart);
    if (square > 0.1) along_crest = glm::cross(u, apart) / std::sqrt(square);
    return way;
  }
};

PenetrationSearch::PenetrationSearch(const Volume& volume, const CutMemory& memory, double radius_mm, Vec3 pose, Vec3 towards) noexcept
    : volume_{volume}, radius_{radius_mm}, pose_{pose}, towards_{towards} {
  const Vec3 foot = pose + towards * radius_mm;
  std::array<CutMemory::Segment, kStrokes> found;
  strokes_ = memory.reaching(foot - kReachMm, foot + kReachMm, kNearMm, found);
  if (strokes_ <= 0) return;
  for (std::size_t i = 0; i < static_cast<std::size_t>(strokes_); ++i) {
    const Vec3 along = found[i].b - found[i].a;
    const double square = glm::dot(along, along);
    stroke_[i] = {found[i].a, along, square > 1e-18 ? 1.0 / square : 0.0, found[i].by.radius_mm};
  }
  const double face = base_distance_mm(volume.specimen(), foot, &normal_);
  level_ = glm::dot(normal_, foot) - face;
}

/// Of a place in what the strokes left; no more than `enough` where it is that or less. The stroke that said so is asked first
/// then: beside a ridge it mostly says so again.
double PenetrationSearch::depth(Vec3 place, double enough_mm) noexcept {
  double least = level_ - glm::dot(normal_, place);
  for (int i = 0; i < at_hand_ && least > enough_mm; ++i) {
    std::uint16_t& which = order_[static_cast<std::size_t>(i)];
    const Taken& taken = stroke_[which];
    const Vec3 off = taken.off_axis(place);
    const double off2 = glm::dot(off, off), reach = least + taken.radius_mm;
    ++evaluations_;
    if (reach > 0.0 && off2 >= reach * reach) continue;  // it is not the nearest: no root
    const double d = std::sqrt(off2) - taken.radius_mm;
    least = d < least ? d : least;
    if (least <= enough_mm) std::swap(order_[0], which);
  }
  return least;
}

/// Which strokes can bind within `reach` of a place; all of them for a negative one.
void PenetrationSearch::choose_strokes(Vec3 place, double reach_mm) noexcept {
  std::array<float, kStrokes> off;
  float least = 1e30f;
  for (int i = 0; i < strokes_ && reach_mm >= 0.0; ++i) {
    const auto k = static_cast<std::size_t>(i);
    off[k] = static_cast<float>(stroke_[k].off(place));
    least = off[k] < least ? off[k] : least;
  }
  at_hand_ = 0;
  for (int i = 0; i < strokes_; ++i)
    if (reach_mm < 0.0 || off[static_cast<std::size_t>(i)] <= least + static_cast<float>(2.0 * reach_mm))
      order_[static_cast<std::size_t>(at_hand_++)] = static_cast<std::uint16_t>(i);
}

/// In steps to four sides.
double PenetrationSearch::climb(Vec3 pose, bool beside, Vec3& towards) noexcept {
  const Vec3 start = beside ? towards : towards_;
  const double reach = beside ? kBesideReachMm : kReachMm;
  double best = depth(pose + towards * radius_, -1e300);
  int steps = 0;
  for (double step = (beside ? kBesideMm : kFirstMm) / radius_; step > kLastMm / radius_; step *= 0.5)
    for (bool moved = true; moved && steps < kMostSteps && evaluations_ < kMostEvaluations; ++steps) {
      moved = false;
      const Vec3 one = across(towards), other = glm::cross(towards, one);
      for (const Vec3& side : {one, -one, other, -other}) {
        Vec3 u = towards + side * step;
        u = u / std::sqrt(glm::dot(u, u));
        const Vec3 off = (u - start) * radius_;
        if (glm::dot(off, off) > reach * reach) continue;
        const double d = depth(pose + u * radius_, best);
        if (d <= best) continue;
        best = d;
        towards = u;
        moved = true;
        break;
      }
    }
  return best;
}

/// The crest of a ridge is a thin line, along which steps to four sides seldom lead.
double PenetrationSearch::along_crest(Vec3 pose, double best, double enough_mm, Vec3& towards, Vec3& along) const noexcept {
  const Vec3 about = pose + towards * radius_;
  if (best + kGainMm <= enough_mm) return best;
  Crest crest;
  crest.face_normal = normal_;
  crest.face_level = level_;
  std::array<float, kStrokes> off_about;
  for (int i = 0; i < at_hand_; ++i) {
    const auto k = static_cast<std::size_t>(i);
    off_about[k] = static_cast<float>(stroke_[order_[k]].off(about));
  }
  double reach = 2.0 * kCrestMm;
  bool all = false;
  while (!all) {
    reach *= 0.5;
    if (reach < kCrestLeastMm) return best;
    all = true;
    crest.strokes = 0;
    for (int i = 0; i < at_hand_ && all; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (off_about[k] > best + 2.0 * reach) continue;
      all = crest.strokes < kCrestStrokes;
      if (all) crest.stroke[static_cast<std::size_t>(crest.strokes++)] = &stroke_[order_[k]];
    }
  }
  Crest::Depths seen, next;
  crest.evaluate(about, seen);
  double length = kCrestFirstMm < 0.5 * reach ? kCrestFirstMm : 0.5 * reach;
  for (int i = 0; i < kCrestSteps && length > kCrestLastMm; ++i) {
    const Vec3 way = crest.uphill(seen, towards, 1.5 * length, along);
    const double steep = std::sqrt(glm::dot(way, way));
    if (steep < 1e-3) {
      length *= 0.5;
      continue;
    }
    Vec3 u = towards + way * (length / (steep * radius_));
    u = u / std::sqrt(glm::dot(u, u));
    const Vec3 x = pose + u * radius_, off = x - about;
    crest.evaluate(x, next);
    if (glm::dot(off, off) > reach * reach || !(next.least > seen.least)) {
      length *= 0.5;
      continue;
    }
    std::swap(seen, next);
    towards = u;
  }
  return seen.least > best ? seen.least : best;
}

/// The strokes must account for all that the field has there; otherwise an unknown one removed tissue.
bool PenetrationSearch::known_from_strokes(Vec3 place) noexcept {
  const Grid& grid = volume_.grid();
  const IVec3 cell = cell_of_voxels((place - grid.origin_mm) / grid.voxel_mm);
  if (known_ && known_cell_ == cell) return true;
  for (int corner = 0; corner < 8; ++corner) {
    const IVec3 v = cell + IVec3(corner & 1, corner >> 1 & 1, corner >> 2);
    const double in_cut = field_sample(volume_, Field::cut, v);
    if (in_cut <= -kBandVoxels) continue;
    const double so_near = (kUnknown - in_cut) * grid.voxel_mm;
    const Vec3 at = grid.centre_mm(v);
    bool known = false;
    for (int i = 0; i < strokes_ && !known; ++i) {
      known = stroke_[static_cast<std::size_t>(i)].off(at) <= so_near;
      if (known) std::swap(stroke_[0], stroke_[static_cast<std::size_t>(i)]);
    }
    if (!known && -kBandVoxels < in_cut - kUnknown) return false;
  }
  known_ = true;
  known_cell_ = cell;
  return true;
}

Penetration PenetrationSearch::deepest(Vec3 pose, Vec3 towards, double enough_mm, bool beside) noexcept {
  Penetration out;
  out.towards = towards;
  if (strokes_ <= 0) return out;
  choose_strokes(pose + towards * radius_, beside ? kBesideReachMm : -1.0);
  double best = climb(pose, beside, out.towards);
  best = along_crest(pose, best, enough_mm, out.towards, out.along);
  if (!(best > enough_mm) || !(best > 0.0) || !known_from_strokes(pose + out.towards * radius_)) return out;
  const Vec3 lifted = pose - pose_;
  const double known = kNearMm - std::sqrt(glm::dot(lifted, lifted));
  out.depth_mm = best < known ? best : known;
  return out;
}

}  // namespace cusp::engine
