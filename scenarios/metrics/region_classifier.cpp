#include "scenarios/metrics/region_classifier.h"

#include <algorithm>
#include <cmath>

namespace cusp::scenarios {

namespace {

/// A corner with its distances from wall (u) and floor (v) and from the target (d).
struct Corner {
  Vec3 p;
  double u, v, d;
};
using Tetrahedron = std::array<Corner, 4>;

/// Far more than distances are rounded by, and so little that no cell beside the boundary's own holds more of it than 1e-6.
/// Test: tests/scenarios/metrics/boundary_test.cpp.
constexpr double kSectionVoxels = 1e-3;

Corner between(const Corner& a, const Corner& b, double t) noexcept {
  return {a.p + t * (b.p - a.p), a.u + t * (b.u - a.u), a.v + t * (b.v - a.v), a.d + t * (b.d - a.d)};
}

double mm3_of(const Tetrahedron& t) noexcept {
  return std::fabs(glm::dot(t[1].p - t[0].p, glm::cross(t[2].p - t[0].p, t[3].p - t[0].p))) / 6.0;
}

/// Share of a tetrahedron in which a value, linear between its corners, is below `level`. Pre: `f` ascending.
double share_below(const std::array<double, 4>& f, double level) noexcept {
  const auto at = [&](std::size_t a, std::size_t b) { return (level - f[a]) / (f[b] - f[a]); };
  if (level <= f[0]) return 0.0;
  if (level > f[3]) return 1.0;
  if (level <= f[1]) return at(0, 1) * at(0, 2) * at(0, 3);
  if (level > f[2]) return 1.0 - (1.0 - at(0, 3)) * (1.0 - at(1, 3)) * (1.0 - at(2, 3));
  return at(0, 2) * at(0, 3) * (1.0 - at(1, 3)) + at(0, 2) * (1.0 - at(1, 2)) * at(1, 3) + at(1, 2) * at(1, 3);
}

/// Area of the target's boundary in a tetrahedron: the mean of the sections at distances within `half_width` of it. Where the
/// boundary passes along a face of two tetrahedra, each then has half of it, whichever way a distance of 0 was rounded. No mean
/// is larger than a section, however flat the distance is across an edge of the target.
double boundary_mm2_of(const Tetrahedron& t, double half_width) noexcept {
  std::array<double, 4> d = {t[0].d, t[1].d, t[2].d, t[3].d};
  const auto [least, most] = std::ranges::minmax(d);
  if (least >= half_width || most <= -half_width) return 0.0;
  const Vec3 a = t[1].p - t[0].p, b = t[2].p - t[0].p, c = t[3].p - t[0].p;
  // Six volumes times the slope of the distance.
  const Vec3 slope = (d[1] - d[0]) * glm::cross(b, c) + (d[2] - d[0]) * glm::cross(c, a) + (d[3] - d[0]) * glm::cross(a, b);
  std::ranges::sort(d);
  const double share = share_below(d, half_width) - share_below(d, -half_width);
  return std::sqrt(glm::dot(slope, slope)) / 6.0 * share / (2.0 * half_width);
}

/// Divides a tetrahedron where a value, linear between its corners, is 0.
template <class Value, class Below, class Above>
void divide(const Tetrahedron& t, Value&& value, Below&& below, Above&& above) {
  std::array<double, 4> f{};
  std::array<std::size_t, 4> in{}, out{};
  std::size_t ins = 0, outs = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    f[i] = value(t[i]);
    if (f[i] < 0.0)
      in[ins++] = i;
    else
      out[outs++] = i;
  }
  const auto mix = [&](std::size_t a, std::size_t b) { return between(t[a], t[b], f[a] / (f[a] - f[b])); };
  const auto prism = [](auto&& side, const Corner& a0, const Corner& a1, const Corner& a2, const Corner& b0,
                        const Corner& b1, const Corner& b2) {
    side(Tetrahedron{a0, a1, a2, b2});
    side(Tetrahedron{a0, a1, b1, b2});
    side(Tetrahedron{a0, b0, b1, b2});
  };
  if (ins == 4) {
    below(t);
  } else if (outs == 4) {
    above(t);
  } else if (ins == 2) {
    const Corner ac = mix(in[0], out[0]), ad = mix(in[0], out[1]), bc = mix(in[1], out[0]), bd = mix(in[1], out[1]);
    prism(below, t[in[0]], ac, ad, t[in[1]], bc, bd);
    prism(above, t[out[0]], ac, bc, t[out[1]], ad, bd);
  } else {
    const std::size_t one = ins == 1 ? in[0] : out[0];
    const std::array<std::size_t, 4>& rest = ins == 1 ? out : in;
    const Corner a = mix(one, rest[0]), b = mix(one, rest[1]), c = mix(one, rest[2]);
    const Tetrahedron tip{t[one], a, b, c};
    if (ins == 1) {
      below(tip);
      prism(above, t[rest[0]], t[rest[1]], t[rest[2]], a, b, c);
    } else {
      above(tip);
      prism(below, t[rest[0]], t[rest[1]], t[rest[2]], a, b, c);
    }
  }
}

}  // namespace

bool RegionClassifier::within(Vec3 low, Vec3 high) noexcept {
  // A distance changes by no more than its place; a hundredth of the box is far more than rounding.
  const double reach = 0.51 * std::sqrt(glm::dot(high - low, high - low));
  const double middle = shape_.distance_mm(0.5 * (low + high));
  in_target_ = middle < -reach;
  return middle <= reach;
}

void RegionClassifier::cell(Vec3 low, Vec3 high) {
  low_ = low;
  high_ = high;
  sampled_ = false;
  if (in_target_) {
    whole_ = true;
    place_ = Place::target;
    return;
  }
  const Vec3 c = 0.5 * (low + high);
  whole_ = upright_ != nullptr ? whole_upright(c, high.x - low.x) : whole_tree(c, high.x - low.x);
}

bool RegionClassifier::whole_upright(Vec3 c, double h) noexcept {
  const double u = outline_mm({c.x, c.y});
  const double v = upright_->below_floor_mm(c.z);
  const double d = rounded_corner(u, v, upright_->corner_mm());
  // Half the cell's diagonal; u - v changes by no more than half a face's diagonal and half an edge.
  const double reach = 0.8661 * h;
  const double turn = 1.2072 * h;
  const bool floor = v >= u;
  const double edge = floor ? leeway_.floor_mm : leeway_.side_mm;
  place_ = d <= 0.0 ? Place::target
           : floor  ? (d <= edge ? Place::tolerated_floor : Place::beyond_floor)
                    : (d <= edge ? Place::tolerated_side : Place::beyond_side);
  if (place_ == Place::target) return d < -reach;
  return d > reach && std::fabs(u - v) > turn && std::fabs(d - edge) > reach;
}

bool RegionClassifier::whole_tree(Vec3 c, double h) noexcept {
  const Near middle = near_at(c);
  const double reach = 0.8661 * h;
  place_ = place_of(middle, leeway_);
  face_ = middle.face;
  if (place_ == Place::target) return middle.distance_mm < -reach;
  if (middle.distance_mm <= reach || std::fabs(middle.distance_mm - leeway_.of(middle.face)) <= reach) return false;
  // Which face is the nearest may change within the cell: its corners say whether it does.
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner(i & 1 ? high_.x : low_.x, i & 2 ? high_.y : low_.y, i & 4 ? high_.z : low_.z);
    if (near_at(corner).face != middle.face) return false;
  }
  return true;
}

double RegionClassifier::outline_at(Vec3 p) noexcept {
  if (!sampled_) {
    sampled_ = true;
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i)
        outline_[i + 3 * j] = outline_mm({low_.x + 0.5 * static_cast<double>(i) * (high_.x - low_.x),
                                          low_.y + 0.5 * static_cast<double>(j) * (high_.y - low_.y)});
  }
  const double fx = 2.0 * (p.x - low_.x) / (high_.x - low_.x);
  const double fy = 2.0 * (p.y - low_.y) / (high_.y - low_.y);
  const std::size_t i = fx < 1.0 ? 0 : 1;
  const std::size_t j = fy < 1.0 ? 0 : 1;
  const double x = fx - static_cast<double>(i);
  const double y = fy - static_cast<double>(j);
  const double* o = &outline_[i + 3 * j];
  return (1.0 - y) * ((1.0 - x) * o[0] + x * o[1]) + y * ((1.0 - x) * o[3] + x * o[4]);
}

double RegionClassifier::outline_mm(Vec2 p) noexcept {
  return outlines_.at(p, [&] { return upright_->outline_mm(p); });
}

Near RegionClassifier::near_at(Vec3 p) noexcept {
  if (upright_ == nullptr) return nears_.at(p, [&] { return shape_.near(p); });
  const double u = outline_at(p);
  const double v = upright_->below_floor_mm(p.z);
  const FaceName face = v >= u ? FaceName::pulpal_floor : FaceName::side_wall;  // of all faces of its kind one leeway
  return {.distance_mm = rounded_corner(u, v, upright_->corner_mm()), .wall_mm = u, .floor_mm = v, .face = face};
}

Place RegionClassifier::place_at(Vec3 p, double& d) noexcept {
  const Near near = near_at(p);
  d = near.distance_mm;
  return whole_ ? place_ : place_of(near, leeway_);
}

void RegionClassifier::box(Vec3 low, Vec3 high, Tissue tissue) {
  const Vec3 size = high - low;
  if (whole_) {
    solid(place_, size.x * size.y * size.z, tissue);
    return;
  }
  // In halves of the cell, where the outline was sampled, each as six tetrahedra about the diagonal.
  const int parts = size.x > 0.75 * (high_.x - low_.x) ? 2 : 1;
  const Vec3 step = size / static_cast<double>(parts);
  constexpr std::array<std::array<int, 4>, 6> kPaths = {
      {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};
  for (int k = 0; k < parts; ++k)
    for (int j = 0; j < parts; ++j)
      for (int i = 0; i < parts; ++i) {
        const Vec3 corner = low + step * Vec3(i, j, k);
        for (const auto& path : kPaths) {
          std::array<Vec3, 4> t;
          for (std::size_t n = 0; n < 4; ++n)
            t[n] = corner + step * Vec3(path[n] & 1, path[n] >> 1 & 1, path[n] >> 2);
          tetrahedron(t, step.x * step.y * step.z / 6.0, tissue);
        }
      }
}

void RegionClassifier::tetrahedron(const std::array<Vec3, 4>& corners, double mm3, Tissue tissue) {
  if (whole_) {
    solid(place_, mm3, tissue);
    return;
  }
  Tetrahedron t;
  for (std::size_t i = 0; i < 4; ++i) {
    const Near near = near_at(corners[i]);
    t[i] = {corners[i], near.wall_mm, near.floor_mm, near.distance_mm};
  }
  boundary_mm2_ += boundary_mm2_of(t, kSectionVoxels * (high_.x - low_.x));
  double floor_edge = leeway_.floor_mm, side_edge = leeway_.side_mm;
  Near middle;
  if (upright_ == nullptr) {  // a tetrahedron has one floor and one wall: those that its middle is nearest to
    middle = near_at(0.25 * (corners[0] + corners[1] + corners[2] + corners[3]));
    (is_floor(middle.face) ? floor_edge : side_edge) = leeway_.of(middle.face);
  }
  const auto split = [&](const Tetrahedron& part, double edge, Place near, Place far) {
    face_ = near == Place::tolerated_floor ? middle.floor : middle.wall;
    divide(
        part, [&](const Corner& c) { return c.d - edge; },
        [&](const Tetrahedron& x) { solid(near, mm3_of(x), tissue); },
        [&](const Tetrahedron& x) { solid(far, mm3_of(x), tissue); });
  };
  divide(
      t, [](const Corner& c) { return c.d; },
      [&](const Tetrahedron& inside) { solid(Place::target, mm3_of(inside), tissue); },
      [&](const Tetrahedron& outside) {
        divide(
            outside, [](const Corner& c) { return c.u - c.v; },
            [&](const Tetrahedron& x) { split(x, floor_edge, Place::tolerated_floor, Place::beyond_floor); },
            [&](const Tetrahedron& x) { split(x, side_edge, Place::tolerated_side, Place::beyond_side); });
      });
}

void emit_removed_by_place(const Volume& volume, int brick, RegionClassifier& sink) {
  const BrickBox cells = cells_of_brick(volume.specimen(), brick);
  sink.within(cells.low, cells.high);
  emit_removed(volume, brick, sink);
}

BrickBox cells_of_brick(const Specimen& specimen, int brick) noexcept {
  const IVec3 at = specimen.brick_at(brick);
  const Grid& grid = specimen.grid();
  // A brick at the low end of the grid also has the cells that reach out of it.
  return {grid.centre_mm(at * kBrickEdge - IVec3(1)), grid.centre_mm(at * kBrickEdge + kBrickEdge)};
}

}  // namespace cusp::scenarios
