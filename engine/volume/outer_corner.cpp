#include "engine/volume/outer_corner.h"

#include <algorithm>

#include "engine/volume/cell_field.h"
#include "engine/volume/specimen.h"

namespace cusp::engine {

namespace {
// Voxels.
constexpr double kReach = 2.5;      // from a corner to the middles of the pieces that find it: faces are read two cells away
constexpr double kNear = 1.6;       // within it a face's plane, which reaches 0.8 from its point, ends at two edges
constexpr double kUnexplained = 1.0;  // within it the field is of three faces
constexpr double kMeets = 0.05;     // pieces pass a corner this close
constexpr double kOnFace = 0.05;
constexpr double kRounded = 0.35;   // by which a trilinear field leaves a corner
constexpr double kBack = 0.4;       // of a face's point from both of its edges

/// inward[k] runs along an edge; normal[k] is of the face between the two others, out of the tissue.
struct Corner {
  Vec3 at{0.0}, inward[3], normal[3];
  double far = 0.0;  // sum of the ways to the pieces that found it
};

/// The points of each brick, and where in the volume they stand.
class Points {
 public:
  Points(const Specimen& specimen, const std::vector<BasePlace>& points) : specimen_(specimen), points_(points) {
    const IVec3 n = specimen.brick_count();
    first_.assign(static_cast<std::size_t>(n.x * n.y * n.z) + 1, points.size());
    for (std::size_t i = points.size(); i-- > 0;) first_[static_cast<std::size_t>(points[i].brick)] = i;
    for (std::size_t b = first_.size() - 1; b-- > 0;) first_[b] = std::min(first_[b], first_[b + 1]);
  }
  /// Voxels from the volume's first voxel centre.
  Vec3 at(std::size_t i) const { return Vec3(specimen_.brick_at(points_[i].brick) * kBrickEdge) + points_[i].at; }
  const BasePlace& operator[](std::size_t i) const { return points_[i]; }
  bool edge(std::size_t i) const { return (points_[i].place & BaseNormal::kEdge) != 0; }
  std::size_t size() const { return points_.size(); }
  /// visit(i) for points within `reach` of a place.
  template <class Visit>
  void within(Vec3 place, double reach, Visit&& visit) const {
    const IVec3 low = IVec3(glm::floor((place - reach - 1.0) / double(kBrickEdge)));
    const IVec3 high = IVec3(glm::floor((place + reach + 1.0) / double(kBrickEdge)));
    IVec3 b;
    for (b.z = low.z; b.z <= high.z; ++b.z)
      for (b.y = low.y; b.y <= high.y; ++b.y)
        for (b.x = low.x; b.x <= high.x; ++b.x) {
          const int brick = specimen_.brick_index(b);
          if (brick < 0) continue;
          const auto slot = static_cast<std::size_t>(brick);
          for (std::size_t i = first_[slot]; i < first_[slot + 1]; ++i)
            if (length_of(at(i) - place) < reach) visit(i);
        }
  }

 private:
  const Specimen& specimen_;
  const std::vector<BasePlace>& points_;
  std::vector<std::size_t> first_;  // [brick + 1]
};

double distance_at(const Specimen& specimen, Vec3 place) {
  const IVec3 cell(glm::floor(place));
  CellField field;
  field.load(specimen, cell);
  Vec3 gradient;
  return field.eval(place - Vec3(cell), gradient);
}

/// How far a place stands over the corner's faces: the distance to the tissue, from below where it is outside.
double over(const Corner& corner, Vec3 place) {
  const Vec3 v = place - corner.at;
  return std::max({glm::dot(corner.normal[0], v), glm::dot(corner.normal[1], v), glm::dot(corner.normal[2], v)});
}

/// True if the specimen's voxels about the corner are those of its three faces.
bool is_tissue(const Specimen& specimen, const Corner& corner) {
  const IVec3 cell(glm::floor(corner.at));
  for (int i = 0; i < 64; ++i) {
    const IVec3 v = cell - 1 + IVec3(i & 3, i >> 2 & 3, i >> 4);
    const double d = distance_from_solid(specimen.s(v)), least = over(corner, Vec3(v));
    const double most = least > 0.0 ? length_of(Vec3(v) - corner.at) : least;
    if (d < std::max(least, -kBandVoxels) - kRounded || d > std::min(most, kBandVoxels) + kRounded) return false;
  }
  return true;
}

/// The corner where three pieces' lines meet.
bool meet(const Specimen& specimen, const Points& points, const std::size_t (&piece)[3], Corner& out) {
  // The place nearest to the three lines: the sum of (1 - t t) (x - p) is zero.
  glm::dmat3 squares(0.0);
  Vec3 sum(0.0);
  for (const std::size_t i : piece) {
    const Vec3 t = points[i].direction;
    const glm::dmat3 across = glm::dmat3(1.0) - glm::outerProduct(t, t);
    squares += across;
    sum += across * points.at(i);
  }
  if (!(glm::determinant(squares) > 0.1)) return false;
  out.at = glm::inverse(squares) * sum;
  out.far = 0.0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 t = points[piece[k]].direction, v = points.at(piece[k]) - out.at;
    const double along = glm::dot(v, t);
    if (length_of(v - t * along) > kMeets || std::fabs(along) > kReach) return false;
    out.far += std::fabs(along);
    const bool forth = distance_at(specimen, out.at + t * kNear) < distance_at(specimen, out.at - t * kNear);
    out.inward[k] = forth ? t : -t;
  }
  for (int k = 0; k < 3; ++k) {
    const Vec3 n = glm::cross(out.inward[(k + 1) % 3], out.inward[(k + 2) % 3]);
    const double length = length_of(n), facing = glm::dot(n, out.inward[k]) / length;
    if (!(std::fabs(facing) > 0.2)) return false;
    out.normal[k] = facing > 0.0 ? -n / length : n / length;
  }
  return is_tissue(specimen, out);
}

/// Of those that are one, the one whose pieces are nearest.
void keep_nearest(const Corner& corner, std::vector<Corner>& corners) {
  for (Corner& known : corners) {
    if (length_of(known.at - corner.at) > kHalfEdge) continue;
    if (corner.far < known.far) known = corner;
    return;
  }
  corners.push_back(corner);
}

std::vector<Corner> find(const Specimen& specimen, const Points& points) {
  constexpr double kOneWay = 0.94;  // cos 20 degrees
  std::vector<Corner> corners;
  std::vector<std::size_t> about;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points.edge(i)) continue;
    about.clear();
    points.within(points.at(i), 2.0 * kReach, [&](std::size_t j) {
      if (j > i && points.edge(j) && std::fabs(glm::dot(points[i].direction, points[j].direction)) < kOneWay) about.push_back(j);
    });
    for (std::size_t j = 0; j < about.size(); ++j)
      for (std::size_t k = j + 1; k < about.size(); ++k) {
        Corner corner;
        if (std::fabs(glm::dot(points[about[j]].direction, points[about[k]].direction)) < kOneWay &&
            meet(specimen, points, {i, about[j], about[k]}, corner))
          keep_nearest(corner, corners);
      }
  }
  return corners;
}

/// What is known at a corner of a point near it. False if it is no place of the surface, or add_pieces() replaces it.
bool end_at(const Corner& corner, Vec3 place, BasePlace& point) {
  const bool edge = (point.place & BaseNormal::kEdge) != 0;
  const Vec3 v = place - corner.at;
  const double far = length_of(v);
  int best = 0;
  double facing = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double f = edge ? std::fabs(glm::dot(point.direction, corner.inward[k])) : glm::dot(point.direction, corner.normal[k]);
    if (f <= facing) continue;
    facing = f;
    best = k;
  }
  if (edge) return far > kUnexplained ? glm::dot(v, corner.inward[best]) > 0.0 : glm::dot(v, corner.inward[best]) > kHalfEdge;
  if (!(facing > 0.98) || std::fabs(glm::dot(v, corner.normal[best])) > kOnFace || over(corner, place) > kOnFace)
    return far > kUnexplained;
  point.details = 0;
  for (int k = 0; k < 3; ++k)
    if (k != best) point.detail[point.details++] = {glm::dot(v, corner.normal[k]), corner.normal[k]};
  point.place |= BaseNormal::kBesideEdge;
  return true;
}

/// Adds an edge's piece that ends at the corner, and a point of each face.
void add_pieces(const Specimen& specimen, const Corner& corner, std::vector<BasePlace>& points) {
  const auto add = [&](Vec3 place, Vec3 direction, std::uint16_t flag) -> BasePlace& {
    BasePlace point;
    const IVec3 cell(glm::floor(place)), brick(cell.x >> 3, cell.y >> 3, cell.z >> 3);
    point.brick = specimen.brick_index(brick);
    point.place = static_cast<std::uint16_t>(brick_offset(cell.x & 7, cell.y & 7, cell.z & 7) | flag);
    point.tissue = corner_tissue(specimen, cell);
    point.at = place - Vec3(brick * kBrickEdge);
    point.direction = direction;
    points.push_back(point);
    return points.back();
  };
  for (int k = 0; k < 3; ++k) {
    add(corner.at + corner.inward[k] * kHalfEdge, corner.inward[k], BaseNormal::kEdge).details = 1;
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Vec3 back = (corner.inward[i] + corner.inward[j]) * kBack;
    BasePlace& face = add(corner.at + back, corner.normal[k], BaseNormal::kBesideEdge);
    face.details = 2;
    face.detail[0] = {glm::dot(back, corner.normal[i]), corner.normal[i]};
    face.detail[1] = {glm::dot(back, corner.normal[j]), corner.normal[j]};
  }
}

}  // namespace

Tissue corner_tissue(const Specimen& specimen, IVec3 cell) noexcept {
  int most = -1;
  Tissue tissue = Tissue::empty;
  for (int i = 0; i < 8; ++i) {
    const IVec3 v = cell + IVec3(i & 1, i >> 1 & 1, i >> 2);
    const int s = specimen.s(v);
    if (s > most && specimen.tissue(v) != Tissue::empty) {
      most = s;
      tissue = specimen.tissue(v);
    }
  }
  return tissue;
}

void add_outer_corners(const Specimen& specimen, std::vector<BasePlace>& points) {
  const Points before(specimen, points);
  const std::vector<Corner> corners = find(specimen, before);
  if (corners.empty()) return;
  std::vector<char> gone(points.size(), 0);
  std::vector<BasePlace> out = points;
  for (const Corner& corner : corners)
    before.within(corner.at, kNear, [&](std::size_t i) {
      if (!end_at(corner, before.at(i), out[i])) gone[i] = 1;
    });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (gone[i] == 0) out[kept++] = out[i];
  out.resize(kept);
  for (const Corner& corner : corners) add_pieces(specimen, corner, out);
  std::stable_sort(out.begin(), out.end(), [](const BasePlace& a, const BasePlace& b) {
    return a.brick != b.brick ? a.brick < b.brick : (a.place & 511) < (b.place & 511);
  });
  points = std::move(out);
}

}  // namespace cusp::engine
