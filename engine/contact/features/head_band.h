/// Which of many points may hold off a head that is no ball, four at a time. Places in voxels, single precision: what passes is
/// asked again exactly. Wait-free. Thread: any.
#pragma once

#include <cmath>

#include "engine/base/lanes.h"
#include "engine/base/vec.h"
#include "engine/contact/features/near_points.h"
#include "engine/tool/profile.h"

namespace cusp::engine {

/// The places about a head at which a surface may be within `slack` of it. In the points' own frame.
/// A surface's plane stands for it within `side` of its point: the point is within slack + side of the head (`wide`).
/// Off the head's edges a ball of its least radius touches that plane from within: the point is within `narrow`.
/// At an edge the point is within `rim2` of it.
struct HeadBand {
  static constexpr double kSlack = 0.02;  // voxels: single precision is off by less, near the axis by 0.008
  struct Line { Lanes t, rho, level; };
  struct Rim { Lanes t, rho; };

  HeadBand(const Profile& head, Vec3 along, double slack_mm, double side_mm, double per_mm) noexcept : axis(Vec3f(along)) {
    const auto bound = [&](double mm) { return static_cast<float>(mm * per_mm + kSlack); };
    const auto spread = [](double v) { return all_lanes(static_cast<float>(v)); };
    const double bend = head.least_radius() + slack_mm;
    wide = bound(slack_mm + side_mm);
    narrow = bound(std::sqrt(bend * bend + side_mm * side_mm) - head.least_radius());
    const float reach = bound(side_mm + std::sqrt(slack_mm * slack_mm + side_mm * side_mm));
    rim2 = reach * reach;
    for (const SupportLine& l : head.support_lines())
      line[count++] = {spread(l.normal.t), spread(l.normal.rho), spread(l.level * per_mm)};
    for (int i = 0; i < head.size(); ++i)
      if (head.edge(i)) rim[rims++] = {spread(head.piece(i).to.t * per_mm), spread(head.piece(i).to.rho * per_mm)};
  }

  VecLanes at, axis;  // of the pivot
  float wide = 0.0f, narrow = 0.0f, rim2 = 0.0f;  // of the distance to the head, and the squared one to an edge
  int count = 0, rims = 0;
  Line line[Profile::kMostPieces * Profile::kMostOfPiece];
  Rim rim[Profile::kMostPieces];
};

/// Calls visit(i, may_be_surface) in rising order for each point within `wide`; may_be_surface: also within `narrow`, or near an
/// edge. Seven floats beyond count must be readable.
template <class Visit>
inline void for_band(const float* x, const float* y, const float* z, int count, const HeadBand& band, Visit&& visit) noexcept {
  unsigned char narrow[kHitBlock / kLanes];
  const auto four = [&](int i) {
    const Lanes dx = load_lanes(x + i) - band.at.x, dy = load_lanes(y + i) - band.at.y, dz = load_lanes(z + i) - band.at.z;
    const Lanes t = dx * band.axis.x + dy * band.axis.y + dz * band.axis.z;
    const Lanes rho = sqrt_of(most_of(dx * dx + dy * dy + dz * dz - t * t, all_lanes(0.0f)));
    // A convex head is no nearer than a line that it touches.
    Lanes off = all_lanes(-3.0e38f);
    for (int k = 0; k < band.count; ++k) off = most_of(off, t * band.line[k].t + rho * band.line[k].rho - band.line[k].level);
    const unsigned hit = bits_of(off <= band.wide);
    if (hit == 0) return hit;
    LaneMask close = off <= band.narrow;
    for (int k = 0; k < band.rims; ++k) {
      const Lanes dt = t - band.rim[k].t, dr = rho - band.rim[k].rho;
      close |= dt * dt + dr * dr <= band.rim2;
    }
    narrow[i % kHitBlock / kLanes] = static_cast<unsigned char>(bits_of(close));
    return hit;
  };
  for_hits(count, four, [&](int i) { visit(i, (narrow[i % kHitBlock / kLanes] >> i % kLanes & 1) != 0); });
}

}  // namespace cusp::engine
