#include "engine/tool/heads.h"

#include <cmath>
#include <initializer_list>

namespace cusp::engine {

namespace {

OutlinePiece line(OnHalf from, OnHalf to) { return {from, to, {}, 0.0}; }

std::optional<Profile> of(std::initializer_list<OutlinePiece> pieces) {
  Profile out;
  for (const OutlinePiece& p : pieces) {
    const bool nothing = p.from == p.to;
    if (!nothing && !out.add(p)) return std::nullopt;
  }
  if (!out.closed()) return std::nullopt;
  return out;
}

bool positive(std::initializer_list<double> all) {
  for (const double v : all)
    if (!(v > 0.0 && v < 1e3)) return false;
  return true;
}

/// The point where the tangent from `to` touches the circle, on the side of greater rho.
std::optional<OnHalf> leaving(OnHalf centre, double radius, OnHalf to) {
  const double t = to.t - centre.t, rho = to.rho - centre.rho;
  const double square = t * t + rho * rho;
  const double beyond = square - radius * radius;
  if (!(beyond > 0.0)) return std::nullopt;
  const double tangent = std::sqrt(beyond);
  const OnHalf n{(t * radius - rho * tangent) / square, (rho * radius + t * tangent) / square};
  return OnHalf{centre.t + radius * n.t, centre.rho + radius * n.rho};
}

}  // namespace

std::optional<Profile> flat_head(double tip_radius, double top_radius, double length) {
  if (!positive({tip_radius, top_radius, length})) return std::nullopt;
  const double low = -(tip_radius > top_radius ? tip_radius : top_radius), high = low + length;
  const OnHalf rim{low, tip_radius}, top{high, top_radius};
  return of({line({low, 0.0}, rim), line(rim, top), line(top, {high, 0.0})});
}

std::optional<Profile> round_end_head(double tip_radius, double top_radius, double length) {
  if (!positive({tip_radius, top_radius, length}) || top_radius < tip_radius) return std::nullopt;
  const double low = -top_radius, high = low + length;
  const OnHalf centre{low + tip_radius, 0.0}, top{high, top_radius};
  const std::optional<OnHalf> rim = leaving(centre, tip_radius, top);
  if (!rim) return std::nullopt;
  return of({{{low, 0.0}, *rim, centre, tip_radius}, line(*rim, top), line(top, {high, 0.0})});
}

std::optional<Profile> pear_head(double radius, double corner_radius, double top_radius, double length) {
  if (!positive({radius, corner_radius, top_radius, length}) || corner_radius > radius || top_radius > radius)
    return std::nullopt;
  const double low = -radius, high = low + length;
  const OnHalf flat{low, radius - corner_radius}, centre{low + corner_radius, radius - corner_radius};
  const OnHalf top{high, top_radius};
  const std::optional<OnHalf> rim = leaving(centre, corner_radius, top);
  if (!rim) return std::nullopt;
  return of({line({low, 0.0}, flat), {flat, *rim, centre, corner_radius}, line(*rim, top), line(top, {high, 0.0})});
}

std::optional<Profile> oval_head(double radius, double tip_radius, double widest_at, double top_radius, double length) {
  if (!positive({radius, tip_radius, widest_at, top_radius, length}) || tip_radius >= radius || top_radius >= radius ||
      widest_at <= tip_radius || length <= widest_at)
    return std::nullopt;
  const double low = -radius, high = low + length;
  // The lower flank touches the tip's ball from outside and is parallel to the axis at the widest place.
  const double below_widest = widest_at - tip_radius;
  const double lower =
      (below_widest * below_widest + radius * radius - tip_radius * tip_radius) / (2.0 * (radius - tip_radius));
  const OnHalf widest{low + widest_at, radius};
  const OnHalf tip{low + tip_radius, 0.0}, below{widest.t, radius - lower};
  const double between = lower - tip_radius;
  if (!(between > 0.0)) return std::nullopt;
  const OnHalf rim{tip.t + tip_radius * (tip.t - below.t) / between, tip_radius * (0.0 - below.rho) / between};
  const double above_widest = length - widest_at, drop = radius - top_radius;
  const double upper = (above_widest * above_widest + drop * drop) / (2.0 * drop);
  const OnHalf top{high, top_radius};
  return of({{{low, 0.0}, rim, tip, tip_radius},
             {rim, widest, below, lower},
             {widest, top, {widest.t, radius - upper}, upper},
             line(top, {high, 0.0})});
}

}  // namespace cusp::engine
