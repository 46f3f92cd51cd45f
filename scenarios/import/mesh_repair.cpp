#include "scenarios/import/mesh_repair.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>

namespace cusp::scenarios {
namespace {

constexpr double kJoin = 1e-4;  // of the box's diagonal: a micrometre on a tooth, far below a voxel and above what STL rounds

using Triangle = std::array<std::uint32_t, 3>;

struct HalfEdge {
  std::uint32_t low, high;
  std::int32_t way;  // +1 from low to high
  std::uint32_t triangle;
};

std::vector<HalfEdge> half_edges(const TriangleMesh& mesh) {
  std::vector<HalfEdge> out;
  out.reserve(mesh.triangles.size() * 3);
  for (std::uint32_t n = 0; n < mesh.triangles.size(); ++n) {
    const Triangle& t = mesh.triangles[n];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      out.push_back(a < b ? HalfEdge{a, b, 1, n} : HalfEdge{b, a, -1, n});
    }
  }
  std::ranges::sort(out, [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.way, a.triangle) < std::tie(b.low, b.high, b.way, b.triangle);
  });
  return out;
}

/// Calls each(first, end) for every edge's half edges.
template <class Each>
void for_each_edge(const std::vector<HalfEdge>& edges, Each each) {
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    each(i, end);
    i = end;
  }
}

class Sets {
 public:
  explicit Sets(std::size_t n) : root_(n) { std::iota(root_.begin(), root_.end(), 0u); }
  std::uint32_t find(std::uint32_t i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }
  /// The lower of the two becomes the root.
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a != b) root_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> root_;
};

/// Edges whose other side is missing, from `from` to `to` as their triangle runs, gathered by the points they share.
struct OpenEdge {
  std::uint32_t from, to;
};
std::map<std::uint32_t, std::vector<OpenEdge>> open_edges(const TriangleMesh& mesh) {
  const std::vector<HalfEdge> edges = half_edges(mesh);
  std::vector<OpenEdge> open;
  for_each_edge(edges, [&](std::size_t first, std::size_t end) {
    if ((end - first) % 2 == 0) return;
    int sum = 0;
    for (std::size_t i = first; i < end; ++i) sum += edges[i].way;
    if (sum > 0) open.push_back({edges[first].low, edges[first].high});
    else open.push_back({edges[first].high, edges[first].low});
  });
  Sets sets(mesh.points.size());
  for (const OpenEdge& e : open) sets.join(e.from, e.to);
  std::map<std::uint32_t, std::vector<OpenEdge>> out;
  for (const OpenEdge& e : open) out[sets.find(e.from)].push_back(e);
  return out;
}

MeshGap gap_of(const TriangleMesh& mesh, const std::vector<OpenEdge>& edges) {
  MeshGap out;
  out.low = out.high = mesh.points[edges.front().from];
  out.edges = edges.size();
  for (const OpenEdge& e : edges) {
    const Vec3 a = mesh.points[e.from], b = mesh.points[e.to];
    out.length += glm::length(b - a);
    out.low = glm::min(out.low, glm::min(a, b));
    out.high = glm::max(out.high, glm::max(a, b));
  }
  return out;
}

/// Points by the cubes of a lattice that they lie in.
class PointCubes {
 public:
  PointCubes(const std::vector<Vec3>& points, Vec3 low, double edge) : cubes_(points.size()) {
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const IVec3 at(glm::clamp(glm::floor((points[i] - low) / edge) + 1.0, Vec3(1.0), Vec3(kMost)));
      cubes_[i] = {key(at.x, at.y, at.z), i};
    }
    std::ranges::sort(cubes_);
  }
  /// Calls each(i, j) once for every two points in one cube or in two that touch.
  template <class Each>
  void for_each_pair(Each each) const {
    for (std::size_t n = 0; n < cubes_.size(); ++n) {
      const auto& [cube, i] = cubes_[n];
      for (std::size_t m = n + 1; m < cubes_.size() && cubes_[m].first <= cube + 1; ++m) each(i, cubes_[m].second);
    }
    // Columns along z that come later: as the cube rises, so does the first one near it.
    for (const std::int64_t column : {key(0, 1, 0), key(1, -1, 0), key(1, 0, 0), key(1, 1, 0)}) {
      std::size_t first = 0;
      for (const auto& [cube, i] : cubes_) {
        while (first < cubes_.size() && cubes_[first].first < cube + column - 1) ++first;
        const std::int64_t last = cube + column + 1;
        for (std::size_t m = first; m < cubes_.size() && cubes_[m].first <= last; ++m) each(i, cubes_[m].second);
      }
    }
  }

 private:
  static constexpr std::int64_t kWide = 1 << 20;
  static constexpr double kMost = kWide - 2;  // beside it the next column begins
  static constexpr std::int64_t key(std::int64_t x, std::int64_t y, std::int64_t z) { return (x * kWide + y) * kWide + z; }
  std::vector<std::pair<std::int64_t, std::uint32_t>> cubes_;
};

/// Points nearer than `near` become one: the first of them in the order of their places. How many went.
std::size_t join_points(TriangleMesh& mesh, const MeshCheck& box, double near) {
  if (!(near > 0.0)) return 0;
  const std::size_t before = mesh.points.size();
  Sets sets(before);
  // The edge exceeds `near`: rounding never puts two near points two cubes apart.
  PointCubes(mesh.points, box.low, 1.001 * near).for_each_pair([&](std::uint32_t i, std::uint32_t j) {
    const Vec3 d = mesh.points[j] - mesh.points[i];
    if (glm::dot(d, d) <= near * near) sets.join(i, j);
  });
  for (Triangle& t : mesh.triangles)
    for (auto& p : t) p = sets.find(p);
  std::vector<Vec3> moved = mesh.points;
  for (std::uint32_t i = 0; i < before; ++i) moved[i] = mesh.points[sets.find(i)];
  mesh.points = std::move(moved);
  weld(mesh);
  return before - mesh.points.size();
}

/// Of triangles on the same three points those that cancel each other go, and all but one of the rest. A mesh that cancels
/// altogether is a surface with two sides, and keeps one.
std::size_t drop_doubles(TriangleMesh& mesh) {
  std::vector<std::pair<Triangle, std::int32_t>> keyed;  // sorted points and the way round, +1 or -1, with the index behind
  std::vector<std::uint32_t> order(mesh.triangles.size());
  keyed.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    Triangle s = t;
    std::int32_t way = 1;
    for (const auto& [i, j] : {std::pair{0u, 1u}, {1u, 2u}, {0u, 1u}})
      if (s[i] > s[j]) {
        std::swap(s[i], s[j]);
        way = -way;
      }
    keyed.emplace_back(s, way);
  }
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return std::tie(keyed[a].first, a) < std::tie(keyed[b].first, b); });
  std::vector<bool> keep(mesh.triangles.size(), true);
  std::vector<std::uint32_t> firsts;  // of each three points
  bool any = false;
  for (std::size_t i = 0; i < order.size();) {
    firsts.push_back(order[i]);
    std::size_t end = i;
    int sum = 0;
    for (; end < order.size() && keyed[order[end]].first == keyed[order[i]].first; ++end) sum += keyed[order[end]].second;
    bool kept = sum == 0 || end - i == 1;
    if (end - i > 1) {
      for (std::size_t k = i; k < end; ++k) {
        const bool wanted = !kept && (keyed[order[k]].second > 0) == (sum > 0);
        keep[order[k]] = wanted;
        kept |= wanted;
        any |= wanted;
      }
    } else {
      any = true;
    }
    i = end;
  }
  if (!any)
    for (const std::uint32_t first : firsts) keep[first] = true;
  const std::size_t before = mesh.triangles.size();
  std::size_t n = 0;
  std::erase_if(mesh.triangles, [&](const Triangle&) { return !keep[n++]; });
  return before - mesh.triangles.size();
}

/// Neighbours over an edge of two triangles are wound alike; of each component the fewer are turned.
std::size_t wind_alike(TriangleMesh& mesh) {
  const std::vector<HalfEdge> edges = half_edges(mesh);
  struct Neighbour {
    std::uint32_t triangle;
    bool turned;
  };
  std::vector<std::vector<Neighbour>> neighbours(mesh.triangles.size());
  for_each_edge(edges, [&](std::size_t first, std::size_t end) {
    if (end - first != 2) return;
    const HalfEdge &a = edges[first], &b = edges[first + 1];
    const bool turned = a.way == b.way;
    neighbours[a.triangle].push_back({b.triangle, turned});
    neighbours[b.triangle].push_back({a.triangle, turned});
  });
  std::vector<std::int8_t> state(mesh.triangles.size(), -1);  // 1: to be turned
  std::size_t turned = 0;
  std::vector<std::uint32_t> component;
  for (std::uint32_t start = 0; start < state.size(); ++start) {
    if (state[start] >= 0) continue;
    component.assign(1, start);
    state[start] = 0;
    std::size_t ones = 0;
    for (std::size_t at = 0; at < component.size(); ++at) {
      const std::uint32_t t = component[at];
      for (const Neighbour& n : neighbours[t]) {
        if (state[n.triangle] >= 0) continue;
        state[n.triangle] = static_cast<std::int8_t>(state[t] ^ (n.turned ? 1 : 0));
        ones += state[n.triangle] == 1;
        component.push_back(n.triangle);
      }
    }
    const std::int8_t turn = 2 * ones > component.size() ? 0 : 1;
    for (const std::uint32_t t : component) {
      if (state[t] != turn) continue;
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
      ++turned;
    }
  }
  return turned;
}

/// How many triangles were turned; the mesh is closed and oriented.
std::size_t turn_shells(TriangleMesh& mesh) {
  const std::vector<std::uint32_t> turned = turned_outside(mesh);
  for (const std::uint32_t n : turned) std::swap(mesh.triangles[n][1], mesh.triangles[n][2]);
  return turned.size();
}

/// A cone from the hole's edges to their middle; its area.
double close_hole(TriangleMesh& mesh, const std::vector<OpenEdge>& edges) {
  Vec3 middle(0.0);
  for (const OpenEdge& e : edges) middle += mesh.points[e.from] / static_cast<double>(edges.size());
  const auto tip = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back(middle);
  double area = 0.0;
  for (const OpenEdge& e : edges) {
    mesh.triangles.push_back({e.to, e.from, tip});
    area += 0.5 * glm::length(glm::cross(mesh.points[e.from] - middle, mesh.points[e.to] - middle));
  }
  return area;
}

}  // namespace

std::vector<MeshGap> gaps_of(const TriangleMesh& mesh) {
  std::vector<MeshGap> out;
  for (const auto& [root, edges] : open_edges(mesh)) out.push_back(gap_of(mesh, edges));
  std::ranges::sort(out, [](const MeshGap& a, const MeshGap& b) {
    if (a.width() != b.width()) return a.width() > b.width();
    return std::tie(a.low.x, a.low.y, a.low.z) < std::tie(b.low.x, b.low.y, b.low.z);
  });
  return out;
}

MeshRepair repair(TriangleMesh& mesh, double max_hole) {
  MeshRepair out;
  if (mesh.points.empty()) return out;
  weld(mesh);
  const MeshCheck before = check(mesh);
  const bool sound = before.closed && before.oriented;
  const std::size_t triangles = mesh.triangles.size();
  if (!sound) out.points_joined = join_points(mesh, before, kJoin * glm::length(before.high - before.low));
  drop_doubles(mesh);
  out.triangles_dropped = triangles - mesh.triangles.size();
  if (sound && out.triangles_dropped == 0) {
    out.triangles_turned = turn_shells(mesh);
    return out;
  }
  out.triangles_turned = wind_alike(mesh);
  out.own_area = check(mesh).area;
  const std::size_t own = mesh.triangles.size();
  for (const auto& [root, edges] : open_edges(mesh)) {
    const MeshGap gap = gap_of(mesh, edges);
    if (gap.width() > max_hole) continue;
    const double area = close_hole(mesh, edges);
    out.cap_area += area;
    out.largest_cap = std::max(out.largest_cap, area);
    ++out.holes_closed;
    out.widest_hole = std::max(out.widest_hole, gap.width());
  }
  weld(mesh);  // drops triangles of no area alone, and of those only the caps have any
  out.cap_triangles = mesh.triangles.size() - own;
  if (const MeshCheck after = check(mesh); after.closed && after.oriented) out.triangles_turned += turn_shells(mesh);
  return out;
}

}  // namespace cusp::scenarios
