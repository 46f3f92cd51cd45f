#include "scenarios/teeth/scenery.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace cusp::scenarios {
namespace {

constexpr int kSkip = 4;  // cells on a side of what is passed over when the surface is far

Vec3 slope_of(const Body& body, Vec3 p, double step) {
  const auto d = [&](Vec3 o) { return body.outside(p + o) - body.outside(p - o); };
  return Vec3(d({step, 0, 0}), d({0, step, 0}), d({0, 0, step})) / (2.0 * step);
}

/// Light from around that reaches a place of the surface: how far the field has grown along the normal, near and far.
std::uint8_t ambient_at(const Body& body, Vec3 at, Vec3 normal) {
  constexpr double kReach[] = {0.4, 1.0, 2.2};  // mm: a fissure, a fossa, the space between two roots
  double open = 0.0;
  for (const double mm : kReach) open += std::clamp(body.outside(at + mm * normal) / mm, 0.0, 1.0) / 3.0;
  return static_cast<std::uint8_t>(255.0 * open + 0.5);
}

/// A lattice of nodes over a body's box; x runs fastest.
struct Lattice {
  Vec3 low{0.0};
  double step = 0;
  IVec3 size{0};
  std::size_t node(int x, int y, int z) const noexcept { return static_cast<std::size_t>(x + size.x * (y + size.y * z)); }
};

/// The body's distance at every node; far from the surface, one distance for a cube of kSkip nodes.
std::vector<float> distances_at(const Lattice& lattice, const Body& body) {
  const IVec3 n = lattice.size;
  std::vector<float> f(lattice.node(0, 0, n.z), 1.0f);
  const double radius = 0.5 * kSkip * std::sqrt(3.0) * lattice.step;
  for (int bz = 0; bz < n.z; bz += kSkip) {
    for (int by = 0; by < n.y; by += kSkip) {
      for (int bx = 0; bx < n.x; bx += kSkip) {
        const double centre = body.outside(lattice.low + lattice.step * (Vec3(bx, by, bz) + 0.5 * (kSkip - 1)));
        const bool far = std::fabs(centre) > kSlopeMost * radius + kFissureMm;
        for (int z = bz; z < std::min(bz + kSkip, n.z); ++z) {
          for (int y = by; y < std::min(by + kSkip, n.y); ++y) {
            for (int x = bx; x < std::min(bx + kSkip, n.x); ++x) {
              f[lattice.node(x, y, z)] = static_cast<float>(far ? centre : body.outside(lattice.low + lattice.step * Vec3(x, y, z)));
            }
          }
        }
      }
    }
  }
  return f;
}

/// Mean of the places where the surface crosses a cell's edges, in cells from its low corner; nullopt: it crosses none.
std::optional<Vec3> crossing_of(const Lattice& lattice, const std::vector<float>& f, IVec3 cell) {
  Vec3 sum(0.0);
  int crossings = 0;
  for (int a = 0; a < 8; ++a) {
    for (int axis = 0; axis < 3; ++axis) {
      const int b = a | 1 << axis;
      if (b == a) continue;
      const IVec3 p(a & 1, a >> 1 & 1, a >> 2), q(b & 1, b >> 1 & 1, b >> 2);
      const double u = double(f[lattice.node(cell.x + p.x, cell.y + p.y, cell.z + p.z)]);
      const double v = double(f[lattice.node(cell.x + q.x, cell.y + q.y, cell.z + q.z)]);
      if ((u < 0.0) == (v < 0.0)) continue;
      sum += Vec3(p) + (u / (u - v)) * Vec3(q - p);
      ++crossings;
    }
  }
  return crossings > 0 ? std::optional(sum / double(crossings)) : std::nullopt;
}

/// One point a cell that the surface crosses, moved onto the surface; returns the point of each cell, -1 for none.
std::vector<std::int32_t> add_points(SceneryMesh& out, const Lattice& lattice, const std::vector<float>& f, const Body& body) {
  const double step = lattice.step;
  std::vector<std::int32_t> point(f.size(), -1);
  for (int z = 0; z + 1 < lattice.size.z; ++z) {
    for (int y = 0; y + 1 < lattice.size.y; ++y) {
      for (int x = 0; x + 1 < lattice.size.x; ++x) {
        const std::optional<Vec3> crossing = crossing_of(lattice, f, {x, y, z});
        if (!crossing) continue;
        const Vec3 home = lattice.low + step * (Vec3(x, y, z) + *crossing);
        Vec3 p = home, g(0, 0, 1);
        for (int round = 0; round < 2; ++round) {
          g = slope_of(body, p, 0.2 * step);
          p -= g * (body.outside(p) / std::max(glm::dot(g, g), 0.05));
        }
        if (glm::length(p - home) > step) p = home;
        point[lattice.node(x, y, z)] = static_cast<std::int32_t>(out.points_mm.size());
        out.points_mm.emplace_back(p);
        const Vec3 normal = glm::normalize(g + Vec3(0, 0, 1e-9));
        out.normals.emplace_back(normal);
        out.ambient.push_back(ambient_at(body, p, normal));
        out.tissue.push_back(body.skin(p));
      }
    }
  }
  return point;
}

enum class Facing : std::uint8_t { along, against };  // the axis that the quad crosses

void add_quad(SceneryMesh& out, std::array<std::int32_t, 4> corners, Facing facing) {
  for (const std::int32_t c : corners)
    if (c < 0) return;
  if (facing == Facing::against) std::swap(corners[1], corners[3]);
  for (const std::size_t i : {0, 1, 2, 0, 2, 3}) out.triangles.push_back(static_cast<std::uint32_t>(corners[i]));
}

/// A quad for each edge of the lattice that the surface crosses.
void add_quads(SceneryMesh& out, const Lattice& lattice, const std::vector<float>& f, const std::vector<std::int32_t>& point) {
  for (int z = 1; z + 1 < lattice.size.z; ++z) {
    for (int y = 1; y + 1 < lattice.size.y; ++y) {
      for (int x = 1; x + 1 < lattice.size.x; ++x) {
        const bool in = f[lattice.node(x, y, z)] < 0.0f;
        const Facing facing = in ? Facing::along : Facing::against;
        const auto at = [&](int dx, int dy, int dz) { return point[lattice.node(x + dx, y + dy, z + dz)]; };
        if (in != (f[lattice.node(x + 1, y, z)] < 0.0f)) add_quad(out, {at(0, -1, -1), at(0, 0, -1), at(0, 0, 0), at(0, -1, 0)}, facing);
        if (in != (f[lattice.node(x, y + 1, z)] < 0.0f)) add_quad(out, {at(-1, 0, -1), at(-1, 0, 0), at(0, 0, 0), at(0, 0, -1)}, facing);
        if (in != (f[lattice.node(x, y, z + 1)] < 0.0f)) add_quad(out, {at(-1, -1, 0), at(0, -1, 0), at(0, 0, 0), at(-1, 0, 0)}, facing);
      }
    }
  }
}

}  // namespace

SceneryMesh mesh_of(const Body& body, double step) {
  const Lattice lattice{body.low() - 2.0 * step, step, IVec3(glm::ceil((body.high() - body.low()) / step)) + 5};
  const std::vector<float> f = distances_at(lattice, body);
  SceneryMesh out;
  add_quads(out, lattice, f, add_points(out, lattice, f, body));
  out.seen = out.triangles.size();
  return out;
}

void cover(SceneryMesh& mesh, const Body& by, double margin) {
  std::vector<std::uint8_t> hidden(mesh.points_mm.size(), 0);
  for (std::size_t i = 0; i < hidden.size(); ++i) {
    const Vec3 p(mesh.points_mm[i]);
    const Vec3 off = glm::max(glm::max(by.low() - p, p - by.high()), Vec3(0.0));
    hidden[i] = glm::dot(off, off) <= margin * margin && by.outside(p) < margin;
  }
  std::vector<std::uint32_t> open, covered;
  for (std::size_t k = 0; k + 2 < mesh.triangles.size(); k += 3) {
    const auto corner = [&](std::size_t i) { return mesh.triangles[k + i]; };
    const bool lost = k >= mesh.seen || (hidden[corner(0)] && hidden[corner(1)] && hidden[corner(2)]);
    for (std::size_t i = 0; i < 3; ++i) (lost ? covered : open).push_back(corner(i));
  }
  mesh.seen = open.size();
  open.insert(open.end(), covered.begin(), covered.end());
  mesh.triangles = std::move(open);
}

void tuck_in(SceneryMesh& mesh, const Body& under, double under_mm) {
  std::vector<std::uint8_t> of(mesh.points_mm.size(), 0);  // 1: of what lies open, 2: of the rest
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) of[mesh.triangles[k]] |= k < mesh.seen ? 1 : 2;
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (of[i] != 3) continue;
    Vec3 p(mesh.points_mm[i]);
    for (int round = 0; round < 3; ++round) {
      const double above = under.outside(p) + under_mm;
      if (above <= 0.0) break;
      const Vec3 g = slope_of(under, p, 0.05);
      p -= g * (above / std::max(glm::dot(g, g), 0.25));
    }
    mesh.points_mm[i] = glm::vec3(p);
  }
}

void mirror(SceneryMesh& mesh) noexcept {
  for (glm::vec3& p : mesh.points_mm) p.x = -p.x;
  for (glm::vec3& n : mesh.normals) n.x = -n.x;
  for (std::size_t k = 0; k + 2 < mesh.triangles.size(); k += 3) std::swap(mesh.triangles[k + 1], mesh.triangles[k + 2]);
}

}  // namespace cusp::scenarios
