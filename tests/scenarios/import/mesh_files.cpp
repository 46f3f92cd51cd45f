#include "tests/scenarios/import/mesh_files.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "engine/base/ids.h"

namespace cusp::test {

Mesh sphere(std::string name, Vec3 centre, double radius, int level) {
  Mesh m{std::move(name), {}, {}};
  const double g = std::numbers::phi;
  m.points = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0}, {0, -1, g}, {0, 1, g},
              {0, -1, -g}, {0, 1, -g}, {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  m.triangles = {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8}, {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}};
  for (; level > 0; --level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [it, is_new] = middles.try_emplace(std::pair(std::min(a, b), std::max(a, b)),
                                                    static_cast<int>(m.points.size()));
      if (is_new)
        m.points.push_back(0.5 * (glm::normalize(m.points[static_cast<std::size_t>(a)]) +
                                  glm::normalize(m.points[static_cast<std::size_t>(b)])));
      return it->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : m.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    m.triangles = std::move(finer);
  }
  for (Vec3& p : m.points) p = centre + radius * glm::normalize(p);
  return m;
}

Mesh torus(std::string name, Vec3 centre, double ring, double tube, int n) {
  Mesh m{std::move(name), {}, {}};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = 2.0 * std::numbers::pi * i / n, v = 2.0 * std::numbers::pi * j / n;
      const double r = ring + tube * std::cos(v);
      m.points.push_back(centre + Vec3(r * std::cos(u), r * std::sin(u), tube * std::sin(v)));
      const int a = i * n + j, b = (i + 1) % n * n + j, c = (i + 1) % n * n + (j + 1) % n, d = i * n + (j + 1) % n;
      m.triangles.push_back({a, b, c});
      m.triangles.push_back({a, c, d});
    }
  return m;
}

namespace {

/// Octants of a sphere at the corners, quarter cylinders along the edges, rectangles between them; about the origin.
class RoundedBox {
 public:
  RoundedBox(Mesh& out, Vec3 core, double round, int level) : out_(out), core_(core), round_(round), n_(1 << level) {}

  void corners() {
    for (int sx : {-1, 1})
      for (int sy : {-1, 1})
        for (int sz : {-1, 1}) corner({sx, sy, sz});
  }
  void edges(int axis) {
    for (int su : {-1, 1})
      for (int sv : {-1, 1})
        for (int i = 0; i < n_; ++i) {
          const auto at = [&](int k, double end) { return on_edge(axis, {su, sv}, static_cast<double>(k) / n_, end); };
          const Vec3 a = at(i, -1), b = at(i + 1, -1), c = at(i + 1, 1), d = at(i, 1);
          su * sv > 0 ? quad({a, b, c, d}) : quad({a, d, c, b});
        }
  }
  void faces(int axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int side : {-1, 1}) {
      const auto at = [&](int du, int dv) {
        Vec3 p(0.0);
        p[axis] = side * (core_[axis] + round_);
        p[u] = du * core_[u];
        p[v] = dv * core_[v];
        return p;
      };
      side > 0 ? quad({at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)}) : quad({at(-1, -1), at(-1, 1), at(1, 1), at(1, -1)});
    }
  }

 private:
  int point(Vec3 p) {
    const std::array<long, 3> key = {std::lround(p.x * 1e9), std::lround(p.y * 1e9), std::lround(p.z * 1e9)};
    const auto [it, is_new] = known_.try_emplace(key, static_cast<int>(out_.points.size()));
    if (is_new) out_.points.push_back(p);
    return it->second;
  }
  void quad(const std::array<Vec3, 4>& corners) {
    const int i = point(corners[0]), j = point(corners[1]), k = point(corners[2]), l = point(corners[3]);
    if (i != j && j != k && k != i) out_.triangles.push_back({i, j, k});
    if (i != k && k != l && l != i) out_.triangles.push_back({i, k, l});
  }
  /// `s`: the signs of its axes.
  void corner(IVec3 s) {
    const auto at = [&](int i, int j) {  // of the octant's triangle, by its sides' shares
      const double a = static_cast<double>(i) / n_, b = static_cast<double>(j) / n_;
      return Vec3(s) * (core_ + round_ * glm::normalize(Vec3(1.0 - a - b, a, b)));
    };
    const bool odd = s.x * s.y * s.z < 0;
    const auto triangle = [&](Vec3 a, Vec3 b, Vec3 c) { odd ? quad({a, c, b, b}) : quad({a, b, c, c}); };
    for (int i = 0; i < n_; ++i)
      for (int j = 0; i + j < n_; ++j) {
        triangle(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < n_) triangle(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  Vec3 on_edge(int axis, std::array<int, 2> signs, double turn, double end) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Vec3 d(0.0);
    d[u] = 1.0 - turn;
    d[v] = turn;
    d = round_ * glm::normalize(d);
    Vec3 p(0.0);
    p[axis] = end * core_[axis];
    p[u] = signs[0] * (core_[u] + d[u]);
    p[v] = signs[1] * (core_[v] + d[v]);
    return p;
  }

  Mesh& out_;
  Vec3 core_;
  double round_;
  int n_;
  std::map<std::array<long, 3>, int> known_;
};

}  // namespace

Mesh rounded_box(std::string name, Vec3 centre, Vec3 core, double round, int level) {
  Mesh out{std::move(name), {}, {}};
  RoundedBox box(out, core, round, level);
  box.corners();
  for (int axis = 0; axis < 3; ++axis) {
    box.edges(axis);
    box.faces(axis);
  }
  for (Vec3& p : out.points) p += centre;
  return out;
}

Mesh inside_out(Mesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

double Prism::area() const { return 0.5 * sides * radius * radius * std::sin(2.0 * std::numbers::pi / sides); }

Mesh prism(std::string name, const Prism& shape) {
  Mesh m{std::move(name), {{0, 0, shape.bottom}, {0, 0, shape.top}}, {}};
  for (int i = 0; i < shape.sides; ++i) {
    const double a = 2.0 * std::numbers::pi * i / shape.sides;
    for (const double z : {shape.bottom, shape.top}) m.points.push_back({shape.radius * std::cos(a), shape.radius * std::sin(a), z});
    const int low = 2 + 2 * i, next = 2 + 2 * ((i + 1) % shape.sides);
    m.triangles.insert(m.triangles.end(), {{low, next, next + 1}, {low, next + 1, low + 1}, {1, low + 1, next + 1}});
    if (!shape.open_bottom) m.triangles.push_back({0, next, low});
  }
  return m;
}

Mesh joined(Mesh a, const Mesh& b) {
  const int base = static_cast<int>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& [i, j, k] : b.triangles) a.triangles.push_back({i + base, j + base, k + base});
  return a;
}

bool in_lopsided(Vec3 p) {
  const auto within = [&](Vec3 low, Vec3 high) {
    return p.x > low.x && p.y > low.y && p.z > low.z && p.x < high.x && p.y < high.y && p.z < high.z;
  };
  return within({1, 2, -1}, {7, 6, 2}) || within({1.5, 2.5, 1.5}, {3, 3.5, 3}) || within({6.5, 4.5, -0.5}, {7.5, 5.5, 1});
}

Mesh lopsided(std::string name) {
  Mesh m{std::move(name), {}, {}};
  std::map<std::array<int, 3>, int> known;
  const auto corner = [&](IVec3 at) {
    const auto [it, is_new] = known.try_emplace({at.x, at.y, at.z}, static_cast<int>(m.points.size()));
    if (is_new) m.points.push_back(0.5 * Vec3(at));
    return it->second;
  };
  // Of all cells of half a millimetre about it the faces between inside and outside.
  for (int z = -4; z < 8; ++z)
    for (int y = 2; y < 14; ++y)
      for (int x = 0; x < 17; ++x) {
        if (!in_lopsided(0.5 * Vec3(x, y, z) + 0.25)) continue;
        for (int axis = 0; axis < 3; ++axis)
          for (const int side : {0, 1}) {
            IVec3 beside(x, y, z);
            beside[axis] += side == 1 ? 1 : -1;
            if (in_lopsided(0.5 * Vec3(beside) + 0.25)) continue;
            IVec3 a(x, y, z), u(0), v(0);
            a[axis] += side;
            u[(axis + 1) % 3] = 1;
            v[(axis + 2) % 3] = 1;
            const int p = corner(a), q = corner(a + u), r = corner(a + u + v), t = corner(a + v);
            if (side == 1) m.triangles.insert(m.triangles.end(), {{p, q, r}, {p, r, t}});
            else m.triangles.insert(m.triangles.end(), {{p, r, q}, {p, t, r}});
          }
      }
  return m;
}

Mesh turned(Mesh mesh) {
  const Quat q = glm::angleAxis(0.61, glm::normalize(Vec3(1.0, 2.0, 3.0)));
  for (Vec3& p : mesh.points) p = q * p;
  return mesh;
}

TempFolder::TempFolder() : path_(std::filesystem::temp_directory_path() / ("cusp-test-" + Uuid::v7().text())) {
  std::filesystem::create_directory(path_);
}
TempFolder::~TempFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void write_obj(const std::filesystem::path& file, const std::vector<Mesh>& meshes) {
  std::ofstream out(file);
  out.precision(9);
  int base = 1;
  for (const Mesh& m : meshes) {
    out << "g " << m.name << "\n";
    for (const Vec3& p : m.points) out << "v " << p.x << " " << p.y << " " << p.z << "\n";
    for (const auto& [a, b, c] : m.triangles) out << "f " << base + a << " " << base + b << " " << base + c << "\n";
    base += static_cast<int>(m.points.size());
  }
}

void write_stl(const std::filesystem::path& file, const Mesh& mesh) {
  std::ofstream out(file);
  out.precision(9);
  out << "solid " << mesh.name << "\n";
  for (const auto& t : mesh.triangles) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const int i : t) {
      const Vec3& p = mesh.points[static_cast<std::size_t>(i)];
      out << "vertex " << p.x << " " << p.y << " " << p.z << "\n";
    }
    out << "endloop\nendfacet\n";
  }
  out << "endsolid " << mesh.name << "\n";
}

void write_off(const std::filesystem::path& file, const Mesh& mesh) {
  std::ofstream out(file);
  out.precision(9);
  out << "OFF\n" << mesh.points.size() << " " << mesh.triangles.size() << " 0\n";
  for (const Vec3& p : mesh.points) out << p.x << " " << p.y << " " << p.z << "\n";
  for (const auto& [a, b, c] : mesh.triangles) out << "3 " << a << " " << b << " " << c << "\n";
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace cusp::test
