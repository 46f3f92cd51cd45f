#include "engine/removal/uncut.h"

#include <array>
#include <cmath>
#include <utility>

#include "engine/tool/swept.h"
#include "engine/volume/cell_field.h"
#include "engine/volume/surface_cells.h"

namespace cusp {

namespace {

constexpr double kNearMm = 0.02;      // strokes whose surface comes so near to where is looked
constexpr double kFirstMm = 0.05;     // the first step on the ball's surface, halved to 0.4 um
constexpr int kHalvings = 8, kMostSteps = 64;
/// Then along the crest of what the nearest strokes leave: no further than kCrestMm from where those are told.
constexpr double kCrestMm = 0.03, kCrestFirstMm = 0.008, kCrestLastMm = 5e-5;
constexpr int kCrestStrokes = 64, kCrestSteps = 48;
constexpr double kUntold = 0.02;      // voxels that a sample may be deeper in the cut than the strokes say

/// Distance of a place to what a stroke took, and the way off it.
double off_stroke(const CutMemory::Segment& s, Vec3 place, Vec3& off, double& away) noexcept {
  const Vec3 along = s.b - s.a, from = place - s.a;
  const double square = glm::dot(along, along);
  double part = square > 1e-18 ? glm::dot(from, along) / square : 0.0;
  part = part < 0.0 ? 0.0 : part > 1.0 ? 1.0 : part;
  off = from - along * part;
  away = std::sqrt(glm::dot(off, off));
  return away - s.by.radius_mm;
}
double off_stroke(const CutMemory::Segment& s, Vec3 place) noexcept {
  Vec3 off;
  double away;
  return off_stroke(s, place, off, away);
}

/// What lies beside a place of the ball's surface: strokes, and the face they were cut into.
struct Beside {
  std::array<const CutMemory::Segment*, kCrestStrokes> stroke;
  int strokes = 0;
  Vec3 face_normal{0.0};
  double face_level = 0.0;  // of the face: its normal times a place of it

  /// How each of them sees a place: how deep it lies in what that one left, and the way on the ball along which that grows.
  struct Seen {
    std::array<double, kCrestStrokes + 1> depth;
    std::array<Vec3, kCrestStrokes + 1> slope;
    double least = 1e300;
    int lowest = 0;
  };
  void look(Vec3 x, Vec3 u, Seen& out) const noexcept {
    out.least = 1e300;
    for (int i = 0; i <= strokes; ++i) {
      const auto k = static_cast<std::size_t>(i);
      Vec3 slope = -face_normal;
      double depth = face_level - glm::dot(face_normal, x);
      if (i < strokes) {
        double away;
        depth = off_stroke(*stroke[k], x, slope, away);
        slope = away > 0.0 ? slope / away : Vec3(0.0);
      }
      out.depth[k] = depth;
      out.slope[k] = slope - u * glm::dot(u, slope);
      if (depth < out.least) {
        out.least = depth;
        out.lowest = i;
      }
    }
  }
  /// The way along which all that bind within `slack` grow: the shortest mean of their slopes.
  Vec3 uphill(const Seen& seen, double slack) const noexcept {
    Vec3 way = seen.slope[static_cast<std::size_t>(seen.lowest)];
    for (int pass = 0; pass < 8; ++pass) {
      double least = 1e300;
      std::size_t worst = 0;
      for (int i = 0; i <= strokes; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (seen.depth[k] > seen.least + slack) continue;
        const double along = glm::dot(seen.slope[k], way);
        if (along < least) {
          least = along;
          worst = k;
        }
      }
      const double square = glm::dot(way, way);
      if (least > square - 1e-4 || square < 1e-8) break;
      const Vec3 to = seen.slope[worst] - way;
      double part = -glm::dot(way, to) / glm::dot(to, to);
      part = part > 1.0 ? 1.0 : part;
      way += to * part;
    }
    return way;
  }
};

}  // namespace

Uncut deepest_uncut(const Volume& volume, const CutMemory& memory, double radius_mm, Vec3 pose, Vec3 towards) noexcept {
  Uncut out;
  out.towards = towards;
  const Vec3 foot = pose + towards * radius_mm;
  std::array<CutMemory::Segment, kUncutStrokes> stroke;
  const int strokes = memory.reaching(foot - kUncutReachMm, foot + kUncutReachMm, kNearMm, stroke);
  if (strokes <= 0) return out;
  // A face is flat enough within the reach.
  Vec3 normal;
  const double face = base_distance_mm(volume.specimen(), foot, &normal);
  // Of a place on the surface; no more than `enough` where it is that or less. The stroke that said so is asked first
  // then: beside a ridge it mostly says so again.
  const auto depth = [&](Vec3 u, double enough) {
    const Vec3 x = pose + u * radius_mm;
    double least = -(face + glm::dot(normal, x - foot));
    for (int i = 0; i < strokes && least > enough; ++i) {
      const double d = off_stroke(stroke[static_cast<std::size_t>(i)], x);
      least = d < least ? d : least;
      if (least <= enough) std::swap(stroke[0], stroke[static_cast<std::size_t>(i)]);
    }
    return least;
  };
  double best = depth(towards, -1e300);
  double step = kFirstMm / radius_mm;
  int steps = 0;
  for (int halving = 0; halving < kHalvings; ++halving, step *= 0.5)
    for (bool moved = true; moved && steps < kMostSteps; ++steps) {
      moved = false;
      const Vec3 one = across(out.towards), other = glm::cross(out.towards, one);
      for (const Vec3& side : {one, -one, other, -other}) {
        Vec3 u = out.towards + side * step;
        u = u / std::sqrt(glm::dot(u, u));
        const Vec3 beside = (u - towards) * radius_mm;
        if (glm::dot(beside, beside) > kUncutReachMm * kUncutReachMm) continue;
        const double d = depth(u, best);
        if (d <= best) continue;
        best = d;
        out.towards = u;
        moved = true;
        break;
      }
    }
  std::array<double, kUncutStrokes> off_about;
  // The crest of a ridge is a thin line, along which steps to four sides seldom lead.
  Beside beside;
  beside.face_normal = normal;
  beside.face_level = glm::dot(normal, foot) - face;
  const Vec3 about = pose + out.towards * radius_mm;
  for (int i = 0; i < strokes; ++i) off_about[static_cast<std::size_t>(i)] = off_stroke(stroke[static_cast<std::size_t>(i)], about);
  double reach = 2.0 * kCrestMm;
  bool all = false;
  while (!all && reach > kCrestFirstMm) {
    reach *= 0.5;
    all = true;
    beside.strokes = 0;
    for (int i = 0; i < strokes && all; ++i) {
      if (off_about[static_cast<std::size_t>(i)] > best + 2.0 * reach) continue;
      all = beside.strokes < kCrestStrokes;
      if (all) beside.stroke[static_cast<std::size_t>(beside.strokes++)] = &stroke[static_cast<std::size_t>(i)];
    }
  }
  if (all) {
    Beside::Seen seen, next;
    beside.look(about, out.towards, seen);
    double length = kCrestFirstMm;
    for (int i = 0; i < kCrestSteps && length > kCrestLastMm; ++i) {
      const Vec3 way = beside.uphill(seen, 1.5 * length);
      const double steep = std::sqrt(glm::dot(way, way));
      if (steep < 1e-3) {
        length *= 0.5;
        continue;
      }
      Vec3 u = out.towards + way * (length / (steep * radius_mm));
      u = u / std::sqrt(glm::dot(u, u));
      const Vec3 x = pose + u * radius_mm;
      const Vec3 off = x - about;
      beside.look(x, u, next);
      if (glm::dot(off, off) > reach * reach || !(next.least > seen.least)) {
        length *= 0.5;
        continue;
      }
      seen = next;
      out.towards = u;
    }
    best = seen.least > best ? seen.least : best;
  }
  if (!(best > 0.0)) return out;
  // All that the field has there must be told by the strokes: else tissue has gone without one that is known.
  const Grid& grid = volume.grid();
  const IVec3 cell = cell_of_voxels((pose + out.towards * radius_mm - grid.origin_mm) / grid.voxel_mm);
  for (int corner = 0; corner < 8; ++corner) {
    const IVec3 v = cell + IVec3(corner & 1, corner >> 1 & 1, corner >> 2);
    const double in_cut = field_sample(volume, Field::cut, v);
    if (in_cut <= -kBandVoxels) continue;
    const Vec3 place = grid.centre_mm(v);
    double told = -kBandVoxels;
    for (int i = 0; i < strokes && told < in_cut - kUntold; ++i) {
      const double d = off_stroke(stroke[static_cast<std::size_t>(i)], place) / grid.voxel_mm;
      told = -d > told ? -d : told;
    }
    if (told < in_cut - kUntold) return out;
  }
  out.depth_mm = best;
  return out;
}

}  // namespace cusp
