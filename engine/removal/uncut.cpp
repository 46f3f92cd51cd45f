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
constexpr double kUntold = 0.02;      // voxels that a sample may be deeper in the cut than the strokes say

/// Distance of a place to what a stroke took.
double off_stroke(const CutMemory::Segment& s, Vec3 place) noexcept {
  const Vec3 along = s.b - s.a, from = place - s.a;
  const double square = glm::dot(along, along);
  double part = square > 1e-18 ? glm::dot(from, along) / square : 0.0;
  part = part < 0.0 ? 0.0 : part > 1.0 ? 1.0 : part;
  const Vec3 off = from - along * part;
  return std::sqrt(glm::dot(off, off)) - s.by.radius_mm;
}

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
