#include "engine/contact/solver/plane_search.h"

#include <algorithm>

namespace cusp::engine {

namespace {

/// Squared sine below which normals count as one and the same.
constexpr double kSame = 1e-22;

/// r = (N^T N)^-1 N^T n for up to three active normals; z = n - N r, the part of n that no active plane holds.
struct Split {
  double r[3] = {0, 0, 0};
  Vec3 z{0.0};
};

/// By cross products, which stay accurate where normals nearly coincide (neighbouring planes of a smooth surface do).
Split split(const Vec3* normals, int count, Vec3 n) noexcept {
  Split out;
  if (count == 0) {
    out.z = n;
    return out;
  }
  const Vec3& n0 = normals[0];
  if (count > 1) {
    const Vec3& n1 = normals[1];
    const Vec3 c01 = glm::cross(n0, n1);
    const double square = glm::dot(c01, c01);
    if (count == 2 && square > kSame) {
      out.r[0] = glm::dot(glm::cross(n, n1), c01) / square;
      out.r[1] = glm::dot(glm::cross(n0, n), c01) / square;
      out.z = c01 * (glm::dot(c01, n) / square);
      return out;
    }
    if (count == 3) {
      // Three independent normals span the space: nothing is left over.
      const double det = glm::dot(normals[2], c01);
      if (det * det > kSame * square) {
        out.r[0] = glm::dot(n, glm::cross(n1, normals[2])) / det;
        out.r[1] = glm::dot(n, glm::cross(normals[2], n0)) / det;
        out.r[2] = glm::dot(n, c01) / det;
        return out;
      }
    }
  }
  // One, or several that are the same to rounding: the first stands for them.
  out.r[0] = glm::dot(n0, n);
  out.z = glm::cross(glm::cross(n0, n), n0);
  return out;
}

/// Independence of a new normal from the active ones: squared sine of the angle to their span.
/// 1e-10 for a pair and 1e-14 for a triple: larger bounds reject neighbouring planes of a smooth surface.
constexpr double kPair = 1e-10;
constexpr double kTriple = 1e-14;
/// Squared mm: planes that meet beyond this contradict each other but for rounding.
constexpr double kFar = 1e10;

/// The point nearest to q on all of the planes given, if every multiplier is positive: a start for the search.
bool on_all(Vec3 q, const Vec3* n, const double* c, int count, PlaneSearch& out) noexcept {
  if (count == 1) {
    out.weight[0] = c[0] - glm::dot(n[0], q);
    out.y = q + n[0] * out.weight[0];
    return out.weight[0] > 0.0;
  }
  if (count == 2) {
    const double g = glm::dot(n[0], n[1]), det = 1.0 - g * g;
    if (det < kPair) return false;
    const double a = c[0] - glm::dot(n[0], q), b = c[1] - glm::dot(n[1], q);
    out.weight[0] = (a - g * b) / det;
    out.weight[1] = (b - g * a) / det;
    out.y = q + n[0] * out.weight[0] + n[1] * out.weight[1];
    return out.weight[0] > 0.0 && out.weight[1] > 0.0;
  }
  const Vec3 c12 = glm::cross(n[1], n[2]), c20 = glm::cross(n[2], n[0]), c01 = glm::cross(n[0], n[1]);
  const double det = glm::dot(n[0], c12);
  if (det * det < 1e-10) return false;  // nearly in one plane: the search sorts them out better
  out.y = (c12 * c[0] + c20 * c[1] + c01 * c[2]) / det;
  const Vec3 d = out.y - q;
  out.weight[0] = glm::dot(d, c12) / det;
  out.weight[1] = glm::dot(d, c20) / det;
  out.weight[2] = glm::dot(d, c01) / det;
  return out.weight[0] > 0.0 && out.weight[1] > 0.0 && out.weight[2] > 0.0;
}

/// Starts a search on the planes given, if they hold it there.
template <class Planes>
void start_on(Vec3 q, const Planes& planes, std::span<const int> start, Vec3 (&normal)[3], PlaneSearch& out) noexcept {
  double c[3];
  int count = 0;
  for (const int i : start) {
    if (count == 3) break;
    normal[count] = planes.n(static_cast<std::size_t>(i));
    c[count] = planes.c(static_cast<std::size_t>(i));
    out.index[count++] = i;
  }
  if (count == 0) return;
  if (on_all(q, normal, c, count, out))
    out.active = count;
  else
    out.y = q;
}

/// The active plane whose multiplier reaches 0 first on a step, and the step's length there; -1: none does.
int first_to_leave(const PlaneSearch& at, const Split& s, double& step) noexcept {
  int out = -1;
  step = 0.0;
  for (int a = 0; a < at.active; ++a) {
    if (!(s.r[a] > 1e-12)) continue;
    const double t = at.weight[a] / s.r[a];
    if (out >= 0 && t >= step) continue;
    out = a;
    step = t;
  }
  return out;
}

void leave(int a, Vec3 (&normal)[3], PlaneSearch& at) noexcept {
  for (; a + 1 < at.active; ++a) {
    normal[a] = normal[a + 1];
    at.index[a] = at.index[a + 1];
    at.weight[a] = at.weight[a + 1];
  }
  --at.active;
}

struct FewPlanes {
  std::span<const Plane> planes;
  std::size_t size() const noexcept { return planes.size(); }
  Vec3 n(std::size_t i) const noexcept { return planes[i].n; }
  double c(std::size_t i) const noexcept { return planes[i].c; }
  double slack(std::size_t i, Vec3 y) const noexcept { return n(i).x * y.x + n(i).y * y.y + n(i).z * y.z - c(i); }
};

/// The most violated plane that is not active yet; the lowest of equals.
template <class Planes>
int worst_of(const Planes& planes, const PlaneSearch& at, double tolerance_mm) noexcept {
  const auto is_active = [&at](int i) { return std::find(at.index, at.index + at.active, i) != at.index + at.active; };
  if constexpr (requires { planes.worst(at.y, tolerance_mm); }) {
    const int found = planes.worst(at.y, tolerance_mm);
    if (!is_active(found)) return found;
    // An active plane, by rounding: the others one by one.
  }
  int worst = -1;
  double most = -tolerance_mm;
  for (int i = 0; i < static_cast<int>(planes.size()); ++i) {
    const double slack = planes.slack(static_cast<std::size_t>(i), at.y);
    if (!(slack < most) || is_active(i)) continue;
    most = slack;
    worst = i;
  }
  return worst;
}

/// Goldfarb and Idnani from a point that is best for its active planes.
template <class Planes>
PlaneSearch search(Vec3 q, const Planes& planes, double tolerance_mm, std::span<const int> start) noexcept {
  PlaneSearch out;
  out.y = q;
  Vec3 normal[3];
  start_on(q, planes, start, normal, out);
  bool anew = false;  // y has been put on its planes since the last one was added
  for (int round = 0; round < 48; ++round) {
    if (!(glm::dot(out.y, out.y) < kFar)) break;  // NaN too
    const int worst = worst_of(planes, out, tolerance_mm);
    if (worst < 0) return out;

    const Vec3 add_n = planes.n(static_cast<std::size_t>(worst));
    const double add_c = planes.c(static_cast<std::size_t>(worst));
    double gained = 0.0;
    for (int inner = 0; inner < 4; ++inner) {
      const Split s = split(normal, out.active, add_n);
      const double room = glm::dot(s.z, s.z);
      const bool dependent = out.active == 3 || room < (out.active == 2 ? kTriple : kPair);
      // Longest step that keeps every multiplier from turning negative.
      double t_drop = 0.0;
      const int drop = first_to_leave(out, s, t_drop);
      if (dependent && drop < 0) {
        // If the active set is infeasible, y is projected onto its planes and the search tries once more. Near-parallel planes need
        // this: steps of many times the way to q leave y off them by more than the tolerance.
        if (anew) {
          out.feasible = false;
          return out;
        }
        anew = true;
        double c[3];
        for (int a = 0; a < out.active; ++a) c[a] = planes.c(static_cast<std::size_t>(out.index[a]));
        PlaneSearch on = out;
        if (out.active > 0 && on_all(q, normal, c, out.active, on)) out = on;
        break;
      }
      const double slack = glm::dot(add_n, out.y) - add_c;
      const double t_full = dependent ? 0.0 : -slack / room;
      const bool full = !dependent && (drop < 0 || t_full <= t_drop);
      const double t = full ? t_full : t_drop;
      if (!dependent) out.y += s.z * t;
      for (int a = 0; a < out.active; ++a) out.weight[a] -= t * s.r[a];
      gained += t;
      if (full) {
        normal[out.active] = add_n;
        out.index[out.active] = worst;
        out.weight[out.active] = gained;
        ++out.active;
        anew = false;
        break;
      }
      leave(drop, normal, out);
    }
  }
  out.y = q;
  out.active = 0;
  out.feasible = false;
  return out;
}

}  // namespace

PlaneSearch closest_point(Vec3 q, std::span<const Plane> planes, double tolerance_mm) noexcept {
  return search(q, FewPlanes{planes}, tolerance_mm, {});
}

PlaneSearch closest_point(Vec3 q, const PlaneSet& planes, double tolerance_mm, std::span<const int> start) noexcept {
  return search(q, planes, tolerance_mm, start);
}

int PlaneSet::worst(Vec3 y, double tolerance_mm) const noexcept {
  // Two lanes, each with the first of its worst.
  Pair most = both(-tolerance_mm), at = both(-1.0), index{0.0, 1.0};
  const auto end = static_cast<double>(count_);
  for (std::size_t i = 0; i < count_; i += 2) {
    const Pair slack = load_pair(&nx_[i]) * y.x + load_pair(&ny_[i]) * y.y + load_pair(&nz_[i]) * y.z - load_pair(&c_[i]);
    const PairMask less = (slack < most) & (index < end);
    most = less ? slack : most;
    at = less ? index : at;
    index += 2.0;
  }
  const bool second = at[1] >= 0.0 && (at[0] < 0.0 || most[1] < most[0] || (most[1] == most[0] && at[1] < at[0]));
  return static_cast<int>(second ? at[1] : at[0]);
}

}  // namespace cusp::engine
