#include "scenarios/teeth/scenery.h"

#include <algorithm>
#include <cmath>

namespace cusp::scenarios {
namespace {

constexpr int kSkip = 4;           // cells on a side of what is passed over when the surface is far
constexpr double kSlopeMost = 1.5; // of the fields, away from fissures
constexpr double kFissureMm = 0.35;

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

}  // namespace

SceneryMesh mesh_of(const Body& body, double step) {
  const Vec3 low = body.low() - 2.0 * step;
  const IVec3 n = IVec3(glm::ceil((body.high() - body.low()) / step)) + 5;
  const auto node = [&](int x, int y, int z) { return static_cast<std::size_t>(x + n.x * (y + n.y * z)); };
  std::vector<float> f(node(0, 0, n.z), 1.0f);
  const double radius = 0.5 * kSkip * std::sqrt(3.0) * step;
  for (int bz = 0; bz < n.z; bz += kSkip) {
    for (int by = 0; by < n.y; by += kSkip) {
      for (int bx = 0; bx < n.x; bx += kSkip) {
        const double centre = body.outside(low + step * (Vec3(bx, by, bz) + 0.5 * (kSkip - 1)));
        const bool far = std::fabs(centre) > kSlopeMost * radius + kFissureMm;
        for (int z = bz; z < std::min(bz + kSkip, n.z); ++z) {
          for (int y = by; y < std::min(by + kSkip, n.y); ++y) {
            for (int x = bx; x < std::min(bx + kSkip, n.x); ++x) {
              f[node(x, y, z)] = static_cast<float>(far ? centre : body.outside(low + step * Vec3(x, y, z)));
            }
          }
        }
      }
    }
  }
  SceneryMesh out;
  std::vector<std::int32_t> point(f.size(), -1);
  for (int z = 0; z + 1 < n.z; ++z) {
    for (int y = 0; y + 1 < n.y; ++y) {
      for (int x = 0; x + 1 < n.x; ++x) {
        Vec3 sum(0.0);
        int crossings = 0;
        for (int a = 0; a < 8; ++a) {
          for (int axis = 0; axis < 3; ++axis) {
            const int b = a | 1 << axis;
            if (b == a) continue;
            const IVec3 p(a & 1, a >> 1 & 1, a >> 2), q(b & 1, b >> 1 & 1, b >> 2);
            const double u = double(f[node(x + p.x, y + p.y, z + p.z)]), v = double(f[node(x + q.x, y + q.y, z + q.z)]);
            if ((u < 0.0) == (v < 0.0)) continue;
            sum += Vec3(p) + (u / (u - v)) * Vec3(q - p);
            ++crossings;
          }
        }
        if (crossings == 0) continue;
        const Vec3 home = low + step * (Vec3(x, y, z) + sum / double(crossings));
        Vec3 p = home, g(0, 0, 1);
        for (int round = 0; round < 2; ++round) {
          g = slope_of(body, p, 0.2 * step);
          p -= g * (body.outside(p) / std::max(glm::dot(g, g), 0.05));
        }
        if (glm::length(p - home) > step) p = home;
        point[node(x, y, z)] = static_cast<std::int32_t>(out.points_mm.size());
        out.points_mm.emplace_back(p);
        const Vec3 normal = glm::normalize(g + Vec3(0, 0, 1e-9));
        out.normals.emplace_back(normal);
        out.ambient.push_back(ambient_at(body, p, normal));
        out.tissue.push_back(body.skin(p));
      }
    }
  }
  const auto quad = [&](std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d, bool turned) {
    if (a < 0 || b < 0 || c < 0 || d < 0) return;
    if (turned) std::swap(b, d);
    for (const std::int32_t i : {a, b, c, a, c, d}) out.triangles.push_back(static_cast<std::uint32_t>(i));
  };
  for (int z = 1; z + 1 < n.z; ++z) {
    for (int y = 1; y + 1 < n.y; ++y) {
      for (int x = 1; x + 1 < n.x; ++x) {
        const bool in = f[node(x, y, z)] < 0.0f;
        const auto at = [&](int dx, int dy, int dz) { return point[node(x + dx, y + dy, z + dz)]; };
        if (in != (f[node(x + 1, y, z)] < 0.0f)) quad(at(0, -1, -1), at(0, 0, -1), at(0, 0, 0), at(0, -1, 0), !in);
        if (in != (f[node(x, y + 1, z)] < 0.0f)) quad(at(-1, 0, -1), at(-1, 0, 0), at(0, 0, 0), at(0, 0, -1), !in);
        if (in != (f[node(x, y, z + 1)] < 0.0f)) quad(at(-1, -1, 0), at(0, -1, 0), at(0, 0, 0), at(-1, 0, 0), !in);
      }
    }
  }
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
