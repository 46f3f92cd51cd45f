#include "scenarios/import/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace cusp::scenarios {
namespace {

/// Six times the signed volume between a triangle and `from`.
double six_volumes(const TriangleMesh& m, const std::array<std::uint32_t, 3>& t, Vec3 from) {
  return glm::dot(m.points[t[0]] - from, glm::cross(m.points[t[1]] - from, m.points[t[2]] - from));
}

struct Edge {
  std::uint32_t low, high;  // points
  std::int32_t way;         // +1 from low to high
};

/// Which triangles hang together by their points, and what they enclose.
struct ShellVolumes {
  std::vector<std::uint32_t> root;  // [point]: one point of its shell
  std::vector<double> volume;       // [root]; positive for a solid
  bool inside_out = false;          // as a whole, so that volumes are turned here
};
ShellVolumes shell_volumes(const TriangleMesh& mesh) {
  ShellVolumes out;
  out.root.resize(mesh.points.size());
  std::iota(out.root.begin(), out.root.end(), 0u);
  const auto find = [&](std::uint32_t i) {
    while (out.root[i] != i) i = out.root[i] = out.root[out.root[i]];
    return i;
  };
  for (const auto& t : mesh.triangles) {
    out.root[find(t[1])] = find(t[0]);
    out.root[find(t[2])] = find(t[0]);
  }
  for (std::uint32_t i = 0; i < out.root.size(); ++i) out.root[i] = find(i);
  out.volume.assign(mesh.points.size(), 0.0);
  double total = 0.0;
  for (const auto& t : mesh.triangles) {
    const std::uint32_t shell = out.root[t[0]];
    // From a point of the shell itself, so that shells far from the origin lose no digits.
    const double v = six_volumes(mesh, t, mesh.points[shell]) / 6.0;
    out.volume[shell] += v;
    total += v;
  }
  out.inside_out = total < 0.0;
  if (out.inside_out)
    for (double& v : out.volume) v = -v;
  return out;
}

struct ShellBox {
  std::uint32_t root = 0;
  Vec3 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};
  bool holds(Vec3 p) const noexcept { return glm::min(p, low) == low && glm::max(p, high) == high; }
  double room() const noexcept { return (high.x - low.x) * (high.y - low.y) * (high.z - low.z); }
};
struct ShellBoxes {
  std::vector<ShellBox> solids;    // largest first: one of them holds most hollows
  std::vector<ShellBox> cavities;
};
ShellBoxes shell_boxes(const TriangleMesh& mesh, const ShellVolumes& shells) {
  std::vector<ShellBox> all(mesh.points.size());
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t p : t) {
      ShellBox& box = all[shells.root[p]];
      box.low = glm::min(box.low, mesh.points[p]);
      box.high = glm::max(box.high, mesh.points[p]);
    }
  ShellBoxes out;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    all[i].root = i;
    if (shells.volume[i] > 0.0) out.solids.push_back(all[i]);
    if (shells.volume[i] < 0.0) out.cavities.push_back(all[i]);
  }
  std::ranges::stable_sort(out.solids, std::ranges::greater{}, &ShellBox::room);
  return out;
}

/// Whether a point lies within a shell: the solid angle of its triangles (Van Oosterom and Strackee 1983) is a whole turn.
bool lies_within(const TriangleMesh& mesh, const ShellVolumes& shells, std::uint32_t shell, Vec3 p) {
  double angle = 0.0;
  for (const auto& t : mesh.triangles) {
    if (shells.root[t[0]] != shell) continue;
    const Vec3 a = mesh.points[t[0]] - p, b = mesh.points[t[1]] - p, c = mesh.points[t[2]] - p;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double part = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    angle += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)), part);
  }
  return std::abs(angle) > 2.0 * std::numbers::pi;
}

}  // namespace

void weld(TriangleMesh& mesh) {
  for (Vec3& p : mesh.points) p += 0.0;  // -0 becomes 0
  std::vector<std::uint32_t> order(mesh.points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto less = [&](std::uint32_t a, std::uint32_t b) {
    const Vec3 &p = mesh.points[a], &q = mesh.points[b];
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    if (p.z != q.z) return p.z < q.z;
    return a < b;
  };
  std::ranges::sort(order, less);
  std::vector<std::uint32_t> to(order.size());
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || mesh.points[order[i]] != mesh.points[order[i - 1]]) points.push_back(mesh.points[order[i]]);
    to[order[i]] = static_cast<std::uint32_t>(points.size() - 1);
  }
  mesh.points = std::move(points);
  for (auto& t : mesh.triangles)
    for (auto& p : t) p = to[p];
  std::erase_if(mesh.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

MeshCheck check(const TriangleMesh& mesh) {
  MeshCheck out;
  if (mesh.triangles.empty()) {
    out.closed = out.oriented = false;
    return out;
  }
  out.low = Vec3(std::numeric_limits<double>::max());
  out.high = -out.low;
  std::vector<Edge> edges;
  edges.reserve(mesh.triangles.size() * 3);
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      edges.push_back(a < b ? Edge{a, b, 1} : Edge{b, a, -1});
      out.low = glm::min(out.low, mesh.points[a]);
      out.high = glm::max(out.high, mesh.points[a]);
    }
    const Vec3 n = glm::cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
    out.area += 0.5 * std::sqrt(glm::dot(n, n));
  }
  std::ranges::sort(edges, [](const Edge& a, const Edge& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.way < b.way;
  });
  // An open edge takes precedence over a turned one, so the place is chosen after the whole list.
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    int sum = 0;
    for (; end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high; ++end)
      sum += edges[end].way;
    const bool odd = (end - i) % 2 == 1;
    if ((odd && out.closed) || (!odd && sum != 0 && out.closed && out.oriented))
      out.bad_edge = 0.5 * (mesh.points[edges[i].low] + mesh.points[edges[i].high]);
    if (odd) out.closed = false;
    if (sum != 0) out.oriented = false;
    i = end;
  }
  if (out.closed && out.oriented) {
    const Vec3 middle = 0.5 * (out.low + out.high);
    for (const auto& t : mesh.triangles) out.volume += six_volumes(mesh, t, middle) / 6.0;
  }
  return out;
}

Shells shells_of(const TriangleMesh& mesh) {
  const ShellVolumes shells = shell_volumes(mesh);

  constexpr std::uint32_t kNone = ~0u;
  std::vector<std::uint32_t> shell_at(mesh.points.size(), kNone);  // [root]: place among its kind
  std::vector<std::uint32_t> point_at(mesh.points.size(), kNone);  // [point]: within its shell
  Shells out;
  for (const auto& t : mesh.triangles) {
    const std::uint32_t shell = shells.root[t[0]];
    const double v = shells.volume[shell];
    if (v == 0.0) continue;
    std::vector<TriangleMesh>& kind = v > 0.0 ? out.solids : out.cavities;
    if (shell_at[shell] == kNone) {
      shell_at[shell] = static_cast<std::uint32_t>(kind.size());
      kind.push_back({mesh.name, {}, {}});
    }
    TriangleMesh& to = kind[shell_at[shell]];
    auto moved = t;
    for (auto& p : moved) {
      if (point_at[p] == kNone) {
        point_at[p] = static_cast<std::uint32_t>(to.points.size());
        to.points.push_back(mesh.points[p]);
      }
      p = point_at[p];
    }
    if ((v < 0.0) != shells.inside_out) std::swap(moved[1], moved[2]);
    to.triangles.push_back(moved);
  }
  return out;
}

std::vector<std::uint32_t> turned_outside(const TriangleMesh& mesh) {
  const ShellVolumes shells = shell_volumes(mesh);
  if (std::ranges::none_of(shells.volume, [](double v) { return v < 0.0; })) return {};
  const ShellBoxes boxes = shell_boxes(mesh, shells);
  std::vector<bool> turned(mesh.points.size(), false);  // [root]
  bool any = false;
  for (const ShellBox& cavity : boxes.cavities) {
    const Vec3 p = mesh.points[cavity.root];
    const auto boxed = [&](const ShellBox& s) { return s.holds(cavity.low) && s.holds(cavity.high); };
    const auto enclosed = [&](const ShellBox& s) { return s.holds(p) && lies_within(mesh, shells, s.root, p); };
    // Boxes come first: a scan can hold thousands of pores.
    if (std::ranges::any_of(boxes.solids, boxed) || std::ranges::any_of(boxes.solids, enclosed)) continue;
    turned[cavity.root] = true;
    any = true;
  }
  std::vector<std::uint32_t> out;
  for (std::uint32_t n = 0; any && n < mesh.triangles.size(); ++n)
    if (turned[shells.root[mesh.triangles[n][0]]]) out.push_back(n);
  return out;
}

}  // namespace cusp::scenarios
