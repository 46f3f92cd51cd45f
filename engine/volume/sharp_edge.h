/// Sharp edges of a field: where two smooth surfaces meet, as a point, a tangent and a bend. A trilinear field rounds
/// an edge by up to a third of a voxel; the faces on either side, continued to their common zero, do not. Only + - * /
/// sqrt. Any thread.
#pragma once

#include "engine/volume/cell_field.h"

namespace cusp::engine {

/// x(t) = at + tangent t + bend t^2 + twist t^3 for |t| <= 0.7, in voxels from the cell's lower corner;
/// tangent is unit.
struct SharpEdge {
  Vec3 at{0.5}, tangent{0.0}, bend{0.0}, twist{0.0};
};

/// Where a and b are both zero, nearest to `from` by Newton's shortest steps. a, b: distance in voxels at a place of
/// the cell, and its gradient. False if they do not meet, or are parallel.
template <class A, class B>
inline bool meet(const A& a, const B& b, Vec3 from, Vec3& at, Vec3& tangent) noexcept {
  Vec3 ga(0.0), gb(0.0);
  at = from;
  for (int pass = 0; pass < 6; ++pass) {
    const double da = a(at, ga), db = b(at, gb);
    const double aa = glm::dot(ga, ga), bb = glm::dot(gb, gb), ab = glm::dot(ga, gb);
    const double det = aa * bb - ab * ab;
    if (!(det > 1e-3)) return false;
    const Vec3 step = ga * ((da * bb - db * ab) / det) + gb * ((db * aa - da * ab) / det);
    at -= step;
    const Vec3 off = at - from;
    if (!(glm::dot(off, off) < 4.0)) return false;
    if (glm::dot(step, step) < 1e-10) break;
  }
  const Vec3 t = glm::cross(ga, gb);
  const double length = std::sqrt(glm::dot(t, t));
  if (!(length > 1e-3)) return false;
  tangent = t / length;
  return true;
}

/// The curve along which a and b meet, about out.at, which lies on it: through four places as far as `half` either way.
template <class A, class B>
inline void fit_curve(const A& a, const B& b, double half, SharpEdge& out) noexcept {
  out.bend = out.twist = Vec3(0.0);
  const double near = 0.5 * half;
  Vec3 x[4], along;
  int k = 0;
  for (const double s : {-half, -near, near, half})
    if (!meet(a, b, out.at + out.tangent * s, x[k++], along)) return;
  const Vec3 even = 0.5 * (x[3] + x[0]) - out.at, even_near = 0.5 * (x[2] + x[1]) - out.at;
  const Vec3 odd = 0.5 * (x[3] - x[0]) - out.tangent * half, odd_near = 0.5 * (x[2] - x[1]) - out.tangent * near;
  const double square = half * half;
  const Vec3 fourth = (even - 4.0 * even_near) / (0.75 * square * square);
  const Vec3 bend = even / square - fourth * square;
  // The mean of two cubics, which differ by the fifth power.
  const Vec3 twist = 0.5 * (odd + 8.0 * odd_near) / (square * half);
  if (glm::dot(bend, bend) < 0.25 && glm::dot(twist, twist) < 0.25 && glm::dot(fourth, fourth) < 0.25) {
    out.bend = bend;
    out.twist = twist;
  }
}

/// The edge where a and b meet in the cell [0,1]^3, with its bend. False if they do not meet there.
template <class A, class B>
inline bool edge_of(const A& a, const B& b, Vec3 from, SharpEdge& out) noexcept {
  if (!meet(a, b, from, out.at, out.tangent)) return false;
  // The place of the edge that is nearest to the cell's middle.
  const Vec3 slid = out.at + out.tangent * glm::dot(Vec3(0.5) - out.at, out.tangent);
  if (!meet(a, b, slid, out.at, out.tangent)) return false;
  for (int i = 0; i < 3; ++i)
    if (!(out.at[i] > -0.1 && out.at[i] < 1.1)) return false;
  out.bend = out.twist = Vec3(0.0);
  // A cubic through half a voxel on either side.
  Vec3 before, after, t;
  constexpr double kSide = 0.5;
  if (meet(a, b, out.at - out.tangent * kSide, before, t) && meet(a, b, out.at + out.tangent * kSide, after, t)) {
    const Vec3 bend = (before + after - 2.0 * out.at) / (2.0 * kSide * kSide);
    const Vec3 twist = (0.5 * (after - before) - out.tangent * kSide) / (kSide * kSide * kSide);
    if (glm::dot(bend, bend) < 0.25 && glm::dot(twist, twist) < 0.25) {
      out.bend = bend;
      out.twist = twist;
    }
  }
  return true;
}

/// A smooth surface continued beyond the cell where it is known: a point, the normal there and the curvatures. Its
/// distance is exact for a plane, a cylinder and a sphere. Voxels.
struct Face {
  Vec3 point{0.0}, normal{0.0};
  double bent[6] = {0, 0, 0, 0, 0, 0};  // of the tangent plane: xx, yy, zz, xy, xz, yz
  double most = 0.0;                    // curvature of the largest magnitude

  double operator()(Vec3 x, Vec3& gradient) const noexcept {
    const Vec3 v = x - point;
    const double height = glm::dot(normal, v);
    const Vec3 t = v - normal * height;
    const Vec3 k(bent[0] * t.x + bent[3] * t.y + bent[4] * t.z, bent[3] * t.x + bent[1] * t.y + bent[5] * t.z,
                 bent[4] * t.x + bent[5] * t.y + bent[2] * t.z);
    const double sag = glm::dot(t, k);
    const double up = 1.0 + most * height;
    const double square = up * up + most * sag;
    if (square < 0.01 || std::fabs(most) < 1e-3) {
      gradient = normal + k;
      return height + 0.5 * sag;
    }
    const double root = std::sqrt(square);
    gradient = (normal * up + k) / root;
    return (root - 1.0) / most;
  }
};

/// The face of a crossed cell. False unless its polynomial is one smooth distance: the gradient keeps its length, and
/// no radius is below three voxels. Outside an edge a distance is smooth, too, but bends more.
inline bool face_of(const CellField& field, Face& out) noexcept {
  constexpr double kLength2 = 0.02, kBent = 0.35;
  if (!field.crossed() || field.most_bent() > kBent) return false;
  Vec3 g;
  for (const int i : {0, 3, 5, 6}) {  // the corners of a tetrahedron
    field.eval(Vec3(i & 1, i >> 1 & 1, i >> 2), g);
    const double off = glm::dot(g, g) - 1.0;
    if (!(off < kLength2 && off > -kLength2)) return false;
  }
  if (!cell_point(field, out.point, out.normal)) return false;
  double h[3], m[3];
  field.hessian(out.point, h, m);
  // P H P with P = 1 - n n^T: a distance does not bend along its own normal, the rest is rounding.
  const Vec3 n = out.normal;
  const Vec3 hn(h[0] * n.x + m[0] * n.y + m[1] * n.z, m[0] * n.x + h[1] * n.y + m[2] * n.z,
                m[1] * n.x + m[2] * n.y + h[2] * n.z);
  const double nhn = glm::dot(n, hn);
  const auto projected = [&](int i, int j, double value) { return value - n[i] * hn[j] - hn[i] * n[j] + nhn * n[i] * n[j]; };
  out.bent[0] = projected(0, 0, h[0]);
  out.bent[1] = projected(1, 1, h[1]);
  out.bent[2] = projected(2, 2, h[2]);
  out.bent[3] = projected(0, 1, m[0]);
  out.bent[4] = projected(0, 2, m[1]);
  out.bent[5] = projected(1, 2, m[2]);
  // Eigenvalues of the tangent part from its trace and the sum of its squares.
  const double trace = out.bent[0] + out.bent[1] + out.bent[2];
  const double squares = out.bent[0] * out.bent[0] + out.bent[1] * out.bent[1] + out.bent[2] * out.bent[2] +
                         2.0 * (out.bent[3] * out.bent[3] + out.bent[4] * out.bent[4] + out.bent[5] * out.bent[5]);
  const double inner = 2.0 * squares - trace * trace;
  const double root = inner > 0.0 ? std::sqrt(inner) : 0.0;
  out.most = 0.5 * (trace < 0.0 ? trace - root : trace + root);
  return true;
}

/// What a crossed cell holds where one field is creased outwards: an edge, or, beside it, a point of one face.
struct Creased {
  /// ridge: two faces explain the cell, but neither their edge nor a point of them lies in it.
  enum class Kind : std::uint8_t { no, edge, face, ridge } kind = Kind::no;
  bool examined = false;  // the cell is creased: the answer depends on the cells two away as well
  SharpEdge edge;
  Vec3 point{0.5}, normal{0.0};              // of the face that is the surface in this cell
  double other_d = 0.0;                      // of the point, to the other face, negative inside; voxels
  Vec3 other_normal{0.0};
  /// Of an edge's cell: a point of each face beside it, where that lies in the cell.
  struct Side {
    Vec3 point{0.5}, normal{0.0}, other_normal{0.0};
    double other_d = 0.0;
  } side[2];
  int sides = 0;
};

/// Cells that creased() examines. A crease shows by a gradient whose length is no distance's; by chance a rounded edge
/// has that length, too.
enum class CreaseSearch : std::uint8_t {
  by_gradient,  // cells with a gradient of another length
  every_cell,   // every cell that an edge may pass close to
};

namespace sharp_edge {

/// Faces of the cells two away from a creased one, out of reach of its crease, and their distances at its corners.
struct NearFaces {
  static constexpr int kMost = 50;
  Face face[kMost];
  double at_corner[kMost][8];
  int count = 0;
};

template <class Load>
inline void find_faces(Load&& load, NearFaces& out) noexcept {
  for (int z = -2; z <= 2; ++z)
    for (int y = -2; y <= 2; ++y)
      for (int x = -2; x <= 2; ++x) {
        const IVec3 o(x, y, z);
        // Every other cell of the shell is enough.
        if ((x != 2 && x != -2 && y != 2 && y != -2 && z != 2 && z != -2) || ((x + y + z) & 1) != 0) continue;
        CellField field;
        Face& face = out.face[out.count];
        if (!load(o, field) || !face_of(field, face)) continue;
        face.point += Vec3(o);
        ++out.count;
      }
  Vec3 gradient;
  for (int k = 0; k < out.count; ++k)
    for (int i = 0; i < 8; ++i) out.at_corner[k][i] = out.face[k](Vec3(i & 1, i >> 1 & 1, i >> 2), gradient);
}

/// Difference of the cell's corners from the larger of faces j and k, whose tissue lies inside both: voxels, summed.
inline double ridge_misfit(const NearFaces& faces, const double (&own_d)[8], int j, int k) noexcept {
  double sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double larger = faces.at_corner[j][i] > faces.at_corner[k][i] ? faces.at_corner[j][i] : faces.at_corner[k][i];
    sum += std::fabs(own_d[i] - larger);
  }
  return sum;
}

/// The same from the smaller of the two, whose tissue lies inside either.
inline double valley_misfit(const NearFaces& faces, const double (&own_d)[8], int j, int k) noexcept {
  double sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double smaller =
        faces.at_corner[j][i] < faces.at_corner[k][i] ? faces.at_corner[j][i] : faces.at_corner[k][i];
    sum += std::fabs(own_d[i] - smaller);
  }
  return sum;
}

/// Two faces that explain a cell; -1: none do. misfit: the least of all pairs.
struct FacePair {
  int one = -1, other = -1;
  double misfit = 0.0;
};

/// Of the pairs whose misfit is about the least, the one with the least curvature. A crease nearby bends the faces that
/// it touches.
inline FacePair best_pair(const NearFaces& faces, const double (&own_d)[8], double most_off) noexcept {
  constexpr double kApart = 0.966;                        // cos 15 degrees
  constexpr double kAsWell = 0.05;                        // of most_off
  float misfit[NearFaces::kMost * NearFaces::kMost / 2];  // of each pair, in order
  FacePair out;
  out.misfit = most_off;
  int pair = 0;
  for (int j = 0; j < faces.count; ++j)
    for (int k = j + 1; k < faces.count; ++k, ++pair) {
      const bool differ = glm::dot(faces.face[j].normal, faces.face[k].normal) <= kApart;
      const double sum = differ ? ridge_misfit(faces, own_d, j, k) : most_off;
      misfit[pair] = static_cast<float>(sum);
      out.misfit = sum < out.misfit ? sum : out.misfit;
    }
  double bent = 0.0;
  pair = 0;
  for (int j = 0; j < faces.count; ++j)
    for (int k = j + 1; k < faces.count; ++k, ++pair) {
      if (misfit[pair] >= most_off || misfit[pair] > out.misfit + kAsWell * most_off) continue;
      const double sum = std::fabs(faces.face[j].most) + std::fabs(faces.face[k].most);
      if (out.one >= 0 && !(sum < bent)) continue;
      bent = sum;
      out.one = j;
      out.other = k;
    }
  return out;
}

/// Adds a point of face `mine` beside out.edge, below face `its`, if one lies in the cell.
inline void add_side(const Face& mine, const Face& its, Creased& out) noexcept {
  constexpr double kBack = 0.3;  // voxels from the edge
  Vec3 g, h;
  mine(out.edge.at, g);
  its(out.edge.at, h);
  const Vec3 back = h - g * (glm::dot(g, h) / glm::dot(g, g));
  const double length = std::sqrt(glm::dot(back, back));
  if (!(length > 1e-3)) return;
  Creased::Side& side = out.side[out.sides];
  side.point = out.edge.at - back * (kBack / length);
  for (int pass = 0; pass < 3; ++pass) side.point -= g * (mine(side.point, g) / glm::dot(g, g));
  side.other_d = its(side.point, h);
  bool inside = side.other_d < 0.0;
  for (int i = 0; i < 3; ++i) inside = inside && side.point[i] > -0.1 && side.point[i] < 1.1;
  if (!inside) return;
  side.normal = g / std::sqrt(glm::dot(g, g));
  side.other_normal = h / std::sqrt(glm::dot(h, h));
  ++out.sides;
}

/// A cell that the edge of a and b does not cross: a point on the face that is further out at `from`. Sets Kind::face
/// if that point lies in the cell.
inline void add_face_point(const Face& a, const Face& b, Vec3 from, Creased& out) noexcept {
  Vec3 g, h;
  const Face& mine = a(from, g) > b(from, h) ? a : b;
  const Face& its = &mine == &a ? b : a;
  out.point = from;
  for (int pass = 0; pass < 4; ++pass) {
    const double d = mine(out.point, g);
    out.point -= g * (d / glm::dot(g, g));
  }
  for (int i = 0; i < 3; ++i)
    if (!(out.point[i] > -0.1 && out.point[i] < 1.1)) return;
  out.other_d = its(out.point, h);
  if (out.other_d > 0.0) return;
  out.normal = g / std::sqrt(glm::dot(g, g));
  out.other_normal = h / std::sqrt(glm::dot(h, h));
  out.kind = Creased::Kind::face;
}

}  // namespace sharp_edge

/// load(offset, CellField&) reads the cell `offset` away; it returns false if the surface does not cross that cell.
/// most_off: by how much the field may differ from the larger of two faces (voxels, summed over the eight corners).
template <class Load>
inline Creased creased(const CellField& own, double most_off, Load&& load,
                       CreaseSearch search = CreaseSearch::by_gradient) noexcept {
  constexpr double kOff = 0.015;  // of a gradient's length
  Creased out;
  if (!own.crease_near()) return out;
  Vec3 f(0.5), n(0.0);
  double steep = 0.0;
  const bool has_point = cell_point(own, f, n, &steep);
  if (has_point && steep > 1.0 - kOff && steep < 1.0 + kOff && search == CreaseSearch::by_gradient) return out;
  out.examined = true;

  sharp_edge::NearFaces faces;
  sharp_edge::find_faces(load, faces);
  double own_d[8];
  for (int i = 0; i < 8; ++i) own_d[i] = own.at_corner(i);
  const sharp_edge::FacePair pair = sharp_edge::best_pair(faces, own_d, most_off);
  if (pair.one < 0 || pair.misfit >= most_off) return out;
  if (pair.misfit > 0.5 * sharp_edge::valley_misfit(faces, own_d, pair.one, pair.other)) return out;
  const Face& a = faces.face[pair.one];
  const Face& b = faces.face[pair.other];
  if (edge_of(a, b, f, out.edge)) {
    out.kind = Creased::Kind::edge;
    sharp_edge::add_side(a, b, out);
    sharp_edge::add_side(b, a, out);
  } else {
    out.kind = Creased::Kind::ridge;
    sharp_edge::add_face_point(a, b, f, out);
  }
  return out;
}

}  // namespace cusp::engine
