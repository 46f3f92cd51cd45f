/// Edges, sharper than a cell: where two smooth surfaces meet, as a point, a tangent and a bend. A trilinear field rounds
/// an edge by up to a third of a voxel; the faces on either side, continued to where both are zero, do not. Only + - * / sqrt. Any thread.
#pragma once

#include <utility>

#include "engine/volume/cell_field.h"

namespace cusp::engine {

/// x(t) = at + tangent t + bend t^2 + twist t^3 + fourth t^4 for |t| <= 0.7, in voxels from the cell's lower corner;
/// tangent is unit.
struct SharpEdge {
  Vec3 at{0.5}, tangent{0.0}, bend{0.0}, twist{0.0}, fourth{0.0};
};

/// Where a and b are both zero, nearest to `from` by Newton's shortest steps. a, b: distance in voxels at a place of the
/// cell, and its gradient. False where they do not meet, or run along each other.
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

/// The curve along which a and b meet, about out.at, which lies on it: laid through four places as far as `half` either way.
template <class A, class B>
inline void lay_curve(const A& a, const B& b, double half, SharpEdge& out) noexcept {
  out.bend = out.twist = out.fourth = Vec3(0.0);
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
  // Of the two cubics the mean: they differ by the fifth power.
  const Vec3 twist = 0.5 * (odd + 8.0 * odd_near) / (square * half);
  if (glm::dot(bend, bend) < 0.25 && glm::dot(twist, twist) < 0.25 && glm::dot(fourth, fourth) < 0.25) {
    out.bend = bend;
    out.twist = twist;
    out.fourth = fourth;
  }
}

/// The edge where a and b meet in the cell [0,1]^3, with its bend; false where they do not.
template <class A, class B>
inline bool edge_of(const A& a, const B& b, Vec3 from, SharpEdge& out) noexcept {
  if (!meet(a, b, from, out.at, out.tangent)) return false;
  // The place of the edge that is nearest to the cell's middle.
  const Vec3 slid = out.at + out.tangent * glm::dot(Vec3(0.5) - out.at, out.tangent);
  if (!meet(a, b, slid, out.at, out.tangent)) return false;
  for (int i = 0; i < 3; ++i)
    if (!(out.at[i] > -0.1 && out.at[i] < 1.1)) return false;
  out.bend = out.twist = out.fourth = Vec3(0.0);
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

/// A smooth surface continued beyond the cell where it is known: a point, the normal there and the curvatures, as the
/// distance to a plane, a cylinder or a sphere (exact for those). Voxels.
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

/// The face of a crossed cell; false unless its polynomial is that of one smooth distance: a gradient that keeps its
/// length, and no bend sharper than a radius of three voxels (outside an edge a distance is smooth too, but bends more).
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
  /// ridge: two faces explain the cell, but it holds no place of theirs.
  enum class Kind : std::uint8_t { no, edge, face, ridge } kind = Kind::no;
  bool looked = false;                       // the cell is creased: the answer depends on the cells two away as well
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

/// load(offset, CellField&) reads the cell `offset` away, or says false where it is not crossed. most_off: by how much (voxels, summed over the eight corners)
/// the field may differ from the larger of two faces; 0: a crease is only seen, not looked into. A crease shows by a gradient that is no distance's; thorough: every cell that an
/// edge may pass close to is looked into, for by chance a rounded one has the right length.
template <class Load>
inline Creased creased(const CellField& own, double most_off, Load&& load, bool thorough = false) noexcept {
  constexpr double kOff = 0.015, kApart = 0.966;  // of a gradient's length; cos 15 degrees
  constexpr int kFaces = 50;
  constexpr double kBack = 0.3;                   // voxels
  constexpr double kAsWell = 0.05;                // of most_off

  Creased out;
  if (!own.crease_near()) return out;
  Vec3 f(0.5), n(0.0);
  double steep = 0.0;
  if (cell_point(own, f, n, &steep) && steep > 1.0 - kOff && steep < 1.0 + kOff && !thorough) return out;
  out.looked = true;
  if (!(most_off > 0.0)) return out;
  // Faces two cells away, out of reach of the crease.
  Face face[kFaces];
  int faces = 0;
  for (int z = -2; z <= 2; ++z)
    for (int y = -2; y <= 2; ++y)
      for (int x = -2; x <= 2; ++x) {
        const IVec3 o(x, y, z);
        // Every other one is enough.
        if ((x != 2 && x != -2 && y != 2 && y != -2 && z != 2 && z != -2) || ((x + y + z) & 1) != 0) continue;
        CellField field;
        if (!load(o, field) || !face_of(field, face[faces])) continue;
        face[faces].point += Vec3(o);
        ++faces;
      }
  // Tissue inside both: at the corners the field is the larger of the two. The pair of faces that says so best.
  double at_corner[kFaces][8];
  float told[kFaces * kFaces / 2];  // of each pair, in order
  double own_d[8];
  Vec3 ga, gb;
  for (int i = 0; i < 8; ++i) own_d[i] = own.at_corner(i);
  for (int k = 0; k < faces; ++k)
    for (int i = 0; i < 8; ++i) at_corner[k][i] = face[k](Vec3(i & 1, i >> 1 & 1, i >> 2), ga);
  const auto as_ridge = [&](int j, int k) {
    double sum = 0.0;
    for (int i = 0; i < 8; ++i) {
      const double larger = at_corner[j][i] > at_corner[k][i] ? at_corner[j][i] : at_corner[k][i];
      sum += std::fabs(own_d[i] - larger);
    }
    return sum;
  };
  double best = most_off;
  int pair = 0;
  for (int j = 0; j < faces; ++j)
    for (int k = j + 1; k < faces; ++k, ++pair) {
      const bool differ = glm::dot(face[j].normal, face[k].normal) <= kApart;
      const double sum = differ ? as_ridge(j, k) : most_off;
      told[pair] = static_cast<float>(sum);
      best = sum < best ? sum : best;
    }
  // Of the pairs that say it as well, the one that bends least: what a crease nearby has touched bends.
  int one = -1, other = -1;
  double bent = 0.0;
  pair = 0;
  for (int j = 0; j < faces; ++j)
    for (int k = j + 1; k < faces; ++k, ++pair) {
      if (told[pair] >= most_off || told[pair] > best + kAsWell * most_off) continue;
      const double sum = std::fabs(face[j].most) + std::fabs(face[k].most);
      if (one >= 0 && !(sum < bent)) continue;
      bent = sum;
      one = j;
      other = k;
    }
  if (one < 0 || best >= most_off) return out;
  double as_valley = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double smaller = at_corner[one][i] < at_corner[other][i] ? at_corner[one][i] : at_corner[other][i];
    as_valley += std::fabs(own_d[i] - smaller);
  }
  if (best > 0.5 * as_valley) return out;
  const Face& a = face[one];
  const Face& b = face[other];
  if (edge_of(a, b, f, out.edge)) {
    out.kind = Creased::Kind::edge;
    for (const auto& [mine, its] : {std::pair(&a, &b), std::pair(&b, &a)}) {
      // From the edge a little way back on the one face, below the other.
      Vec3 g, h;
      (*mine)(out.edge.at, g);
      (*its)(out.edge.at, h);
      const Vec3 back = h - g * (glm::dot(g, h) / glm::dot(g, g));
      const double length = std::sqrt(glm::dot(back, back));
      if (!(length > 1e-3)) continue;
      Creased::Side& side = out.side[out.sides];
      side.point = out.edge.at - back * (kBack / length);
      for (int pass = 0; pass < 3; ++pass) side.point -= g * ((*mine)(side.point, g) / glm::dot(g, g));
      side.other_d = (*its)(side.point, h);
      bool inside = side.other_d < 0.0;
      for (int i = 0; i < 3; ++i) inside = inside && side.point[i] > -0.1 && side.point[i] < 1.1;
      if (!inside) continue;
      side.normal = g / std::sqrt(glm::dot(g, g));
      side.other_normal = h / std::sqrt(glm::dot(h, h));
      ++out.sides;
    }
    return out;
  }
  out.kind = Creased::Kind::ridge;
  // No edge in this cell: its point stands on the face that is further out.
  const Face& mine = a(f, ga) > b(f, gb) ? a : b;
  const Face& its = &mine == &a ? b : a;
  out.point = f;
  Vec3 g;
  for (int pass = 0; pass < 4; ++pass) {
    const double d = mine(out.point, g);
    out.point -= g * (d / glm::dot(g, g));
  }
  for (int i = 0; i < 3; ++i)
    if (!(out.point[i] > -0.1 && out.point[i] < 1.1)) return out;
  out.other_d = its(out.point, gb);
  if (out.other_d > 0.0) return out;
  out.normal = g / std::sqrt(glm::dot(g, g));
  out.other_normal = gb / std::sqrt(glm::dot(gb, gb));
  out.kind = Creased::Kind::face;
  return out;
}

}  // namespace cusp::engine
