#include "scenarios/shapes/outline.h"

#include <limits>

namespace cusp::scenarios {
namespace {

/// Tangent with + - * / alone, so that every machine gives the same bits. Pre: at most 45 degrees either way; nine terms
/// of the series then leave less than 1e-17.
double tangent_of(double deg) noexcept {
  const double x = deg * 0.017453292519943295, square = x * x;
  double sine = 0.0, cosine = 0.0;
  for (int term = 9; term >= 0; --term) {
    sine = 1.0 - square * sine / ((2.0 * term + 2.0) * (2.0 * term + 3.0));
    cosine = 1.0 - square * cosine / ((2.0 * term + 1.0) * (2.0 * term + 2.0));
  }
  return x * sine / cosine;
}

/// Whether the segment a-b meets the rectangle (the way of Liang and Barsky).
bool meets(Vec2 a, Vec2 b, Vec2 low, Vec2 high) noexcept {
  double first = 0.0, last = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double way = b[axis] - a[axis];
    if (way == 0.0) {
      if (a[axis] < low[axis] || a[axis] > high[axis]) return false;
      continue;
    }
    const double s = (low[axis] - a[axis]) / way, t = (high[axis] - a[axis]) / way;
    first = std::max(first, std::min(s, t));
    last = std::min(last, std::max(s, t));
  }
  return first <= last;
}

/// From the segment a-b to the rectangle; 0 where they meet.
double segment_to_rectangle(Vec2 a, Vec2 b, Vec2 low, Vec2 high) noexcept {
  if (meets(a, b, low, high)) return 0.0;
  const Vec2 centre = 0.5 * (low + high), half = 0.5 * (high - low);
  double out = std::min(rectangle_distance(a, centre, half), rectangle_distance(b, centre, half));
  for (const Vec2 corner : {low, high, Vec2(low.x, high.y), Vec2(high.x, low.y)}) out = std::min(out, segment_distance(corner, a, b));
  return out;
}

}  // namespace

OutlineShape::OutlineShape(const Outline& outline)
    : top_mm_(outline.top_mm), floor_mm_(outline.top_mm - outline.depth_mm) {
  if (outline.shape == "box") {
    if (!outline.paths.empty() && !outline.paths.front().empty()) {
      const Vec3 c = outline.paths.front().front();
      box_ = true;
      box_centre_ = {c.x, c.y};
      box_half_ = 0.5 * Vec2(outline.box_size_mm.x, outline.box_size_mm.y);
      half_width_mm_ = std::min(box_half_.x, box_half_.y);
      low_ = box_centre_ - box_half_;
      high_ = box_centre_ + box_half_;
    }
  } else {
    half_width_mm_ = 0.5 * outline.width_mm;
    low_ = Vec2(std::numeric_limits<double>::max());
    high_ = -low_;
    for (const std::vector<Vec3>& path : outline.paths) {
      for (std::size_t i = 0; i < path.size(); ++i) {
        const Vec2 b(path[i].x, path[i].y);
        const Vec2 a = i == 0 ? b : Vec2(path[i - 1].x, path[i - 1].y);
        low_ = glm::min(low_, b - half_width_mm_);
        high_ = glm::max(high_, b + half_width_mm_);
        if (i > 0 || path.size() == 1) segments_.push_back({a, b});
      }
    }
    if (segments_.empty()) low_ = high_ = Vec2(0.0);
  }
  corner_mm_ = std::max(0.0, std::min({outline.corner_radius_mm, half_width_mm_, outline.depth_mm}));
  for (std::size_t side = 0; side < 4; ++side) {
    slope_[side] = tangent_of(outline.taper_deg[side]);
    tapered_ = tapered_ || slope_[side] != 0.0;
  }
  if (!tapered_) return;
  const double x = std::max(std::fabs(slope_[0]), std::fabs(slope_[1])), y = std::max(std::fabs(slope_[2]), std::fabs(slope_[3]));
  steepness_ = std::sqrt(1.0 + x * x + y * y);
  const double depth = top_mm_ - floor_mm_;
  low_ -= depth * Vec2(std::fabs(slope_[0]), std::fabs(slope_[2]));
  high_ += depth * Vec2(std::fabs(slope_[1]), std::fabs(slope_[3]));
}

double OutlineShape::outline_mm(Vec2 p) const noexcept {
  if (box_) return rectangle_distance(p, box_centre_, box_half_);
  double nearest = std::numeric_limits<double>::max();
  for (const Segment& s : segments_) {
    const Vec2 off = p - (s.a + nearest_on_segment(p, s.a, s.b) * (s.b - s.a));
    nearest = std::min(nearest, glm::dot(off, off));
  }
  return std::sqrt(nearest) - half_width_mm_;
}

std::array<double, 4> OutlineShape::spread_at(double z) const noexcept {
  const double depth = top_mm_ - floor_mm_, up = std::clamp(z - floor_mm_, 0.0, depth);
  std::array<double, 4> out;
  for (std::size_t side = 0; side < 4; ++side) out[side] = slope_[side] > 0.0 ? slope_[side] * up : -slope_[side] * (depth - up);
  return out;
}

double OutlineShape::wall_mm(Vec3 p) const noexcept {
  const Vec2 flat(p.x, p.y);
  if (!tapered_) return outline_mm(flat);
  const std::array<double, 4> out = spread_at(p.z);
  const Vec2 low(-out[0], -out[2]), high(out[1], out[3]);
  if (box_) {
    const Vec2 bottom = box_centre_ - box_half_ + low, top = box_centre_ + box_half_ + high;
    return rectangle_distance(flat, 0.5 * (bottom + top), 0.5 * (top - bottom)) / steepness_;
  }
  // A line that every point of a rectangle is moved along lies as far off as the rectangle about the place from the line.
  double nearest = std::numeric_limits<double>::max();
  for (const Segment& s : segments_) nearest = std::min(nearest, segment_to_rectangle(s.a, s.b, flat - high, flat - low));
  return (nearest - half_width_mm_) / steepness_;
}

double OutlineShape::distance_mm(Vec3 p) const noexcept {
  const double u = wall_mm(p), v = below_floor_mm(p.z);
  return tapered_ ? blended_max(u, v, corner_mm_) : rounded_corner(u, v, corner_mm_);
}

std::size_t OutlineShape::side_of(Vec3 p) const noexcept {
  const Vec2 flat(p.x, p.y);
  Vec2 off = flat - box_centre_;
  if (box_) {
    const std::size_t x = off.x < 0.0 ? 0 : 1, y = off.y < 0.0 ? 2 : 3;
    const std::array<double, 4> spread = spread_at(p.z);
    const Vec2 out = glm::abs(off) - box_half_ - Vec2(spread[x], spread[y]);
    return out.x >= out.y ? x : y;
  }
  double nearest = std::numeric_limits<double>::max();
  for (const Segment& s : segments_) {
    const Vec2 from = flat - (s.a + nearest_on_segment(flat, s.a, s.b) * (s.b - s.a));
    if (glm::dot(from, from) >= nearest) continue;
    nearest = glm::dot(from, from);
    off = from;
  }
  if (std::fabs(off.x) >= std::fabs(off.y)) return off.x < 0.0 ? 0 : 1;
  return off.y < 0.0 ? 2 : 3;
}

std::size_t OutlineShape::faces_at(Vec3 p, const std::array<FaceName, 6>& faces, std::array<LeafFace, 6>& out) const noexcept {
  out[0] = {faces[0], below_floor_mm(p.z), Vec3(0.0, 0.0, -1.0)};
  const Vec2 flat(p.x, p.y);
  if (!box_) {
    Vec2 off(0.0);
    double nearest = std::numeric_limits<double>::max();
    for (const Segment& s : segments_) {
      const Vec2 from = flat - (s.a + nearest_on_segment(flat, s.a, s.b) * (s.b - s.a));
      if (glm::dot(from, from) >= nearest) continue;
      nearest = glm::dot(from, from);
      off = from;
    }
    if (!(nearest > 0.0)) return 1;  // on the line itself no wall is the nearer
    out[1] = {faces[1 + side_of(p)], wall_mm(p), Vec3(off / std::sqrt(nearest), 0.0)};
    return 2;
  }
  const std::array<double, 4> spread = spread_at(p.z);
  for (std::size_t side = 0; side < 4; ++side) {
    const int axis = static_cast<int>(side / 2);
    const double way = side % 2 == 0 ? -1.0 : 1.0, steep = std::sqrt(1.0 + slope_[side] * slope_[side]);
    Vec3 normal(0.0, 0.0, -slope_[side] / steep);
    normal[axis] = way / steep;
    out[1 + side] = {faces[1 + side], (way * (flat[axis] - box_centre_[axis]) - box_half_[axis] - spread[side]) / steep, normal};
  }
  return 5;
}

Near OutlineShape::near(Vec3 p, const std::array<FaceName, 6>& faces) const noexcept {
  const double u = wall_mm(p), v = below_floor_mm(p.z);
  const FaceName bottom = faces[0], side = faces[1 + side_of(p)];
  Near out{.distance_mm = tapered_ ? blended_max(u, v, corner_mm_) : rounded_corner(u, v, corner_mm_), .wall_mm = u, .floor_mm = v,
           .face = v < u ? side : bottom};
  for (const FaceName one : {bottom, side}) (is_floor(one) ? out.floor : out.wall) = one;
  // An author may call the bottom a wall, or a wall a floor.
  if (is_floor(out.face) != (v >= u)) std::swap(out.wall_mm, out.floor_mm);
  return out;
}

}  // namespace cusp::scenarios
